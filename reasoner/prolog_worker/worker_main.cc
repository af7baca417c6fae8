#include "reasoner/prolog_worker/worker_main.h"

#include <fcntl.h>
#include <unistd.h>

#include <new>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "reasoner/prolog/expert.h"
#include "reasoner/prolog_worker/confinement.h"
#include "reasoner/prolog_worker/frames.h"
#include "reasoner/prolog_worker/snapshot_file.h"

namespace lares::prolog {
namespace {

using Json = nlohmann::ordered_json;

void SendEnd(const GoalEnd& end) {
  Json json{{"answers", end.answers}, {"complete", end.complete}};
  if (end.fault) {
    json["fault"] = {{"kind", end.fault->kind},
                     {"message", end.fault->message},
                     {"line", end.fault->line},
                     {"column", end.fault->column}};
  }
  SendFrame(kWorkerSocket, FrameKind::kEnd,
            json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void SendFault(const char* kind, const char* message) {
  GoalEnd end;
  end.fault = GoalFault{kind, message};
  SendEnd(end);
}

void Work() {
  StartExpertProlog();
  Frame frame;
  int snapshot = -1;
  if (!ReceiveFrame(kWorkerSocket, &frame, &snapshot) || snapshot < 0) return;
  const Json request = Json::parse(frame.bytes);
  const rdf::View view = ReadSnapshot(snapshot);
  ::close(snapshot);
  Confine({request.at("memory_bytes"), request.at("cpu_s")});

  ExpertLimits limits;
  limits.max_answers = request.at("max_answers");
  limits.prove = request.at("prove");
  const auto send = [](std::string answer) {
    if (answer.size() > kMaxFrame) throw std::bad_alloc();
    return SendFrame(kWorkerSocket, FrameKind::kAnswer, answer);
  };
  SendEnd(RunExpertGoal(view, request.at("goal").get_ref<const std::string&>(), limits, send));
}

}  // namespace

void RunWorker() {
  try {
    Work();
  } catch (const std::bad_alloc&) {
    SendFault("memory", "the goal needs more memory than it may have");
  } catch (const Error& error) {
    SendFault(error.code() == Code::kTooLarge ? "memory" : "worker", error.what());
  } catch (const std::exception& error) {
    SendFault("worker", error.what());
  }
  ::_exit(0);
}

}  // namespace lares::prolog
