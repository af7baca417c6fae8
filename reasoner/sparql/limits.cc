#include "reasoner/sparql/limits.h"

#include <string>
#include <utility>

namespace lares::sparql {

void Account::Refuse() const {
  throw Error(Code::kTooLarge,
              "the query needs more than its " + std::to_string(limit_ >> 20) + " MiB of memory")
      .WithHint("make it more selective, or take ORDER BY, DISTINCT or GROUP BY off large answers");
}

Guard::Guard(std::chrono::milliseconds timeout, std::stop_token stop)
    : timeout_(timeout), start_(std::chrono::steady_clock::now()), stop_(std::move(stop)) {}

void Guard::Check() const {
  if (stop_.stop_requested()) throw Error(Code::kTimeout, "the query was stopped");
  if (std::chrono::steady_clock::now() - start_ <= timeout_) return;
  throw Error(Code::kTimeout,
              "the query took longer than " + std::to_string(timeout_.count()) + " ms")
      .WithHint("make it more selective; EXPLAIN shows how it is answered");
}

std::chrono::microseconds Guard::elapsed() const {
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() -
                                                               start_);
}

}  // namespace lares::sparql
