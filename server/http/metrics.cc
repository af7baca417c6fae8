#include "server/http/metrics.h"

#include <algorithm>
#include <sstream>

namespace lares::http {
namespace {

void Header(std::ostringstream& out, const std::string& name, const std::string& type,
            const std::string& help) {
  out << "# HELP " << name << ' ' << help << "\n# TYPE " << name << ' ' << type << '\n';
}

}  // namespace

Metrics::Series& Metrics::Find(const Key& key) {
  {
    const std::shared_lock lock(mutex_);
    const auto found = series_.find(key);
    if (found != series_.end()) return *found->second;
  }
  const std::unique_lock lock(mutex_);
  std::unique_ptr<Series>& series = series_[key];
  if (series == nullptr) series = std::make_unique<Series>();
  return *series;
}

void Metrics::Record(const std::string& operation, int status, std::chrono::nanoseconds duration,
                     std::uint64_t bytes_in, std::uint64_t bytes_out) {
  Series& series = Find({operation, status});
  const double seconds = std::chrono::duration<double>(duration).count();
  const auto bucket = static_cast<std::size_t>(
      std::lower_bound(kBounds.begin(), kBounds.end(), seconds) - kBounds.begin());
  series.buckets[bucket].fetch_add(1, std::memory_order_relaxed);
  series.nanoseconds.fetch_add(static_cast<std::uint64_t>(duration.count()),
                               std::memory_order_relaxed);
  series.bytes_in.fetch_add(bytes_in, std::memory_order_relaxed);
  series.bytes_out.fetch_add(bytes_out, std::memory_order_relaxed);
}

std::string Metrics::ToPrometheus(const std::vector<Gauge>& gauges) const {
  std::ostringstream durations, counts, in, out;
  Header(counts, "lares_http_requests_total", "counter", "Requests answered.");
  Header(durations, "lares_http_request_duration_seconds", "histogram",
         "From the complete header to the last byte handed to the system.");
  Header(in, "lares_http_request_bytes_total", "counter", "Bytes of request bodies.");
  Header(out, "lares_http_response_bytes_total", "counter", "Bytes of response bodies.");
  const std::shared_lock lock(mutex_);
  for (const auto& [key, series] : series_) {
    const std::string labels =
        "operation=\"" + key.first + "\",status=\"" + std::to_string(key.second) + "\"";
    std::uint64_t total = 0;
    for (std::size_t i = 0; i <= kBounds.size(); ++i) {
      total += series->buckets[i].load(std::memory_order_relaxed);
      durations << "lares_http_request_duration_seconds_bucket{" << labels << ",le=\"";
      if (i < kBounds.size()) {
        durations << kBounds[i];
      } else {
        durations << "+Inf";
      }
      durations << "\"} " << total << '\n';
    }
    durations << "lares_http_request_duration_seconds_sum{" << labels << "} "
              << static_cast<double>(series->nanoseconds.load(std::memory_order_relaxed)) * 1e-9
              << "\nlares_http_request_duration_seconds_count{" << labels << "} " << total << '\n';
    counts << "lares_http_requests_total{" << labels << "} " << total << '\n';
    in << "lares_http_request_bytes_total{" << labels << "} " << series->bytes_in << '\n';
    out << "lares_http_response_bytes_total{" << labels << "} " << series->bytes_out << '\n';
  }
  for (const Gauge& gauge : gauges) {
    Header(out, gauge.name, "gauge", gauge.help);
    out << gauge.name << ' ' << gauge.value << '\n';
  }
  return counts.str() + durations.str() + in.str() + out.str();
}

}  // namespace lares::http
