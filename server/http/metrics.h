// Counts and durations of requests, in Prometheus' text format.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <vector>

namespace lares::http {

struct Gauge {
  std::string name;  // "lares_terms"
  std::string help;
  double value = 0;
};

// Thread-safe. One series per operation and status; both come from fixed sets, so that nobody
// outside can make the table grow.
class Metrics {
 public:
  void Record(const std::string& operation, int status, std::chrono::nanoseconds duration,
              std::uint64_t bytes_in, std::uint64_t bytes_out);
  std::string ToPrometheus(const std::vector<Gauge>& gauges) const;

 private:
  // Upper bounds of the histogram's buckets in seconds; one more holds the rest.
  static constexpr std::array<double, 12> kBounds{0.0001, 0.00025, 0.0005, 0.001, 0.0025, 0.005,
                                                  0.01,   0.05,    0.1,    0.5,   2.5,    10};
  struct Series {
    std::array<std::atomic<std::uint64_t>, kBounds.size() + 1> buckets{};
    std::atomic<std::uint64_t> nanoseconds{0};
    std::atomic<std::uint64_t> bytes_in{0};
    std::atomic<std::uint64_t> bytes_out{0};
  };
  using Key = std::pair<std::string, int>;

  Series& Find(const Key& key);

  mutable std::shared_mutex mutex_;
  std::map<Key, std::unique_ptr<Series>> series_;
};

}  // namespace lares::http
