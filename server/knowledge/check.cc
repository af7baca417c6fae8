// Checking an ontology document without keeping it.
#include "reasoner/profile/check.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

#include "ontology/rdf/reader.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

constexpr std::chrono::seconds kLongest{60};

// Asks to stop when the time is over; ends without waiting when the work is done before.
class Deadline {
 public:
  explicit Deadline(std::chrono::seconds time)
      : clock_([this, time](std::stop_token done) {
          std::unique_lock lock(mutex_);
          if (!over_.wait_for(lock, done, time, [] { return false; }) && !done.stop_requested()) {
            source_.request_stop();
          }
        }) {}
  std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::mutex mutex_;
  std::condition_variable_any over_;
  std::jthread clock_;  // last: it uses the others
};

}  // namespace

CheckAnswer Knowledge::Check(const CheckRequest& request) {
  const rdf::Format format = rdf::GuessFormat(request.media_type, request.file_name, request.bytes);
  rdf::ReadOptions options = OptionsFor("check:document", request.file_name, state_->aliases);
  options.recover = request.recover;
  options.record_lines = true;
  const rdf::Document document = rdf::ReadRdf(request.bytes, format, options);
  const auto catalogue = state_->catalogue();
  CheckAnswer answer;
  const Deadline deadline(kLongest);
  // The document's terms stay in the dictionary, as those of a document that is refused do.
  answer.report =
      profile::Check({document, request.bytes, request.file_name, state_->aliases, catalogue->view},
                     deadline.token());
  answer.remarks = document.remarks;
  answer.warnings = AbsentImports(document, catalogue->modules, state_->aliases);
  answer.statements = document.statements.size();
  return answer;
}

}  // namespace lares::server
