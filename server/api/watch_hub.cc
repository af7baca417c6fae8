#include "server/api/watch_hub.h"

#include <algorithm>
#include <atomic>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/hash.h"
#include "server/api/answers.h"
#include "server/api/standing_query.h"
#include "server/http/problem.h"

namespace lares::api {
namespace {

using Clock = std::chrono::steady_clock;

// An answer as a sorted bag of rows, each compact JSON.
struct Rows {
  std::vector<std::string> rows;
  std::uint64_t generation = 0;

  std::string Digest() const {
    Sha256 hash;
    for (const std::string& row : rows) {
      hash.Update(row);
      hash.Update("\n");
    }
    return hash.FinishHex();
  }
};

// Gathers rows within the limits of a watch.
class Gatherer {
 public:
  explicit Gatherer(const WatchOptions& options) : options_(options) {}

  void Add(const Json& row) {
    rows_.push_back(Compact(row));
    bytes_ += rows_.back().size();
    if (rows_.size() > options_.max_rows || bytes_ > options_.max_bytes) {
      throw Error(Code::kTooLarge, "the answer is too large to be watched: more than " +
                                       std::to_string(options_.max_rows) + " rows or " +
                                       std::to_string(options_.max_bytes >> 20) + " MiB")
          .WithHint("watch a narrower query, or one that counts");
    }
  }
  std::vector<std::string> Sorted() {
    std::sort(rows_.begin(), rows_.end());
    return std::move(rows_);
  }

 private:
  const WatchOptions& options_;
  std::vector<std::string> rows_;
  std::size_t bytes_ = 0;
};

std::vector<std::string> Ask(const sparql::Query& query, const rdf::View& view,
                             const WatchOptions& options, std::stop_token stop) {
  const sparql::Dataset dataset = DatasetOf(view);
  sparql::Limits limits;
  limits.timeout = options.timeout;
  limits.max_memory_bytes = 64u << 20;
  Gatherer gatherer(options);
  if (query.form() == sparql::Form::kAsk) {
    gatherer.Add({{"boolean", sparql::Ask(query, dataset, limits, stop)}});
  } else if (query.form() == sparql::Form::kSelect) {
    sparql::Select(query, dataset, limits, stop, [&](sparql::Cells cells) {
      Json row = Json::object();
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i]) row[query.variables()[i]] = TermToJson(*cells[i]);
      }
      gatherer.Add(row);
      return true;
    });
  } else {
    const rdf::Document document = sparql::Construct(query, dataset, limits, stop);
    const auto term = [&](std::uint32_t index) { return TermToJson(document.terms[index].view()); };
    for (const rdf::Statement& statement : document.statements) {
      gatherer.Add({{"subject", term(statement.subject)},
                    {"predicate", term(statement.predicate)},
                    {"object", term(statement.object)}});
    }
  }
  return gatherer.Sorted();
}

// Rows are JSON already.
std::string Array(const std::vector<std::string>& rows) {
  std::string text = "[";
  for (const std::string& row : rows) text += (text.size() > 1 ? "," : "") + row;
  return text + "]";
}

std::string Summary(const Rows& answer) {
  return "{\"generation\":" + std::to_string(answer.generation) +
         ",\"count\":" + std::to_string(answer.rows.size()) + ",\"digest\":\"" + answer.Digest() +
         "\"";
}

http::Event FirstOf(const Rows& answer, FirstEvent first) {
  std::string data = Summary(answer);
  if (first == FirstEvent::kRows) data += ",\"rows\":" + Array(answer.rows);
  return {"answer", std::to_string(answer.generation), data + "}"};
}

http::Event ChangeOf(const Rows& before, const Rows& now) {
  std::vector<std::string> added, removed;
  std::set_difference(now.rows.begin(), now.rows.end(), before.rows.begin(), before.rows.end(),
                      std::back_inserter(added));
  std::set_difference(before.rows.begin(), before.rows.end(), now.rows.begin(), now.rows.end(),
                      std::back_inserter(removed));
  return {"change", std::to_string(now.generation),
          Summary(now) + ",\"added\":" + Array(added) + ",\"removed\":" + Array(removed) + "}"};
}

struct Subscriber {
  FirstEvent first;
  std::shared_ptr<http::EventChannel> channel;
  std::shared_ptr<void> place;
  std::function<bool()> allowed;
  std::shared_ptr<const Rows> told;  // null: nothing yet
};

struct Watch {
  Standing standing;
  std::vector<Subscriber> subscribers;
  std::shared_ptr<const Rows> answer;       // null: not asked yet
  std::optional<std::uint64_t> generation;  // that it was asked at
  std::vector<std::shared_ptr<const rdf::Layer>> layers;
  Clock::time_point not_before{};
};

}  // namespace

struct WatchHub::State {
  server::Knowledge& knowledge;
  std::shared_ptr<server::Snapshots> snapshots;
  const WatchOptions options;

  std::mutex mutex;
  std::condition_variable_any woken;
  bool has_news = false;
  std::vector<std::pair<Standing, Subscriber>> arrivals;
  std::shared_ptr<std::map<std::string, int>> places =
      std::make_shared<std::map<std::string, int>>();
  std::shared_ptr<std::mutex> places_mutex = std::make_shared<std::mutex>();
  std::atomic<std::size_t> count{0};

  std::map<std::string, Watch> watches;  // of the thread alone

  std::shared_ptr<void> listening;
  std::jthread thread;

  void Wake() {
    {
      const std::lock_guard lock(mutex);
      has_news = true;
    }
    woken.notify_all();
  }
  void Run(const std::stop_token& stop);
  bool Round(const std::stop_token& stop);
  void Admit();
  void Refresh(Watch& watch, std::uint64_t generation, const std::stop_token& stop);
  bool Tell(Watch& watch);
  static void EndForbidden(Watch& watch);
  static void Fail(Watch& watch, const std::exception& error);
};

void WatchHub::State::Run(const std::stop_token& stop) {
  bool unfinished = false;
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(mutex);
      const std::chrono::milliseconds patience(unfinished ? 50 : 1000);
      const bool news = woken.wait_for(lock, stop, patience, [this] { return has_news; });
      if (news) woken.wait_for(lock, stop, options.settle_time, [] { return false; });
      has_news = false;
    }
    if (!stop.stop_requested()) unfinished = Round(stop);
  }
  for (auto& [key, watch] : watches) {
    for (Subscriber& subscriber : watch.subscribers) subscriber.channel->End();
  }
}

// True when something is left to do though no news come.
bool WatchHub::State::Round(const std::stop_token& stop) {
  const std::uint64_t generation = knowledge.changes().generation();
  Admit();
  std::size_t subscribers = 0;
  for (auto& [key, watch] : watches) {
    EndForbidden(watch);
    std::erase_if(watch.subscribers, [](const Subscriber& one) { return one.channel->gone(); });
    subscribers += watch.subscribers.size();
  }
  count = subscribers;
  bool unfinished = false;
  for (auto entry = watches.begin(); entry != watches.end() && !stop.stop_requested();) {
    Watch& watch = entry->second;
    if (watch.subscribers.empty()) {
      entry = watches.erase(entry);
      continue;
    }
    try {
      if (watch.generation != generation && Clock::now() >= watch.not_before) {
        Refresh(watch, generation, stop);
      }
      if (!Tell(watch) || watch.generation != generation) unfinished = true;
      ++entry;
    } catch (const std::exception& error) {
      if (!stop.stop_requested()) Fail(watch, error);
      entry = watches.erase(entry);
    }
  }
  return unfinished;
}

// A store that cannot be asked ends no stream: it is asked again in the next round.
void WatchHub::State::EndForbidden(Watch& watch) {
  for (Subscriber& subscriber : watch.subscribers) {
    try {
      if (!subscriber.allowed()) subscriber.channel->End();
    } catch (const Error&) {
      continue;
    }
  }
}

void WatchHub::State::Admit() {
  std::vector<std::pair<Standing, Subscriber>> arrived;
  {
    const std::lock_guard lock(mutex);
    arrived.swap(arrivals);
  }
  for (auto& [standing, subscriber] : arrived) {
    const std::string key = standing.key;
    auto found = watches.find(key);
    if (found == watches.end()) {
      found = watches.emplace(key, Watch{std::move(standing), {}, {}, {}, {}, {}}).first;
    }
    found->second.subscribers.push_back(std::move(subscriber));
  }
}

void WatchHub::State::Refresh(Watch& watch, std::uint64_t generation, const std::stop_token& stop) {
  const Clock::time_point start = Clock::now();
  const server::PinnedView pinned(snapshots, knowledge.ViewFor(watch.standing.about));
  if (watch.answer == nullptr || watch.layers != pinned.view().layers()) {
    std::vector<std::string> rows = Ask(watch.standing.query, pinned.view(), options, stop);
    if (watch.answer == nullptr || watch.answer->rows != rows) {
      watch.answer = std::make_shared<const Rows>(Rows{std::move(rows), generation});
    }
    watch.layers = pinned.view().layers();
  }
  watch.generation = generation;
  const Clock::duration taken = Clock::now() - start;
  if (taken > std::chrono::milliseconds(20)) watch.not_before = Clock::now() + 9 * taken;
}

// False when somebody is still busy with the event before.
bool WatchHub::State::Tell(Watch& watch) {
  bool all = true;
  if (watch.answer == nullptr) return true;
  for (Subscriber& subscriber : watch.subscribers) {
    if (subscriber.told == watch.answer) continue;
    if (!subscriber.channel->drained()) {
      all = false;
      continue;
    }
    const bool same = subscriber.told != nullptr && subscriber.told->rows == watch.answer->rows;
    if (!same) {
      const http::Event event = subscriber.told == nullptr
                                    ? FirstOf(*watch.answer, subscriber.first)
                                    : ChangeOf(*subscriber.told, *watch.answer);
      if (subscriber.channel->Send(event) != http::EventChannel::Sent::kTaken) {
        all = false;
        continue;
      }
    }
    subscriber.told = watch.answer;
  }
  return all;
}

void WatchHub::State::Fail(Watch& watch, const std::exception& error) {
  const auto* fault = dynamic_cast<const Error*>(&error);
  const http::Response problem =
      http::ToProblem(fault != nullptr ? *fault : Error(Code::kInternal, error.what()), "");
  for (Subscriber& subscriber : watch.subscribers) {
    subscriber.channel->Send(
        {"error", "", Compact(Json::parse(std::get<std::string>(problem.body)))});
    subscriber.channel->End();
  }
}

WatchHub::WatchHub(server::Knowledge& knowledge, std::shared_ptr<server::Snapshots> snapshots,
                   const WatchOptions& options)
    : state_(new State{knowledge, std::move(snapshots), options}) {
  State& state = *state_;
  state.listening = knowledge.changes().Listen([&state] { state.Wake(); });
  state.thread = std::jthread([&state](const std::stop_token& stop) { state.Run(stop); });
}

WatchHub::~WatchHub() {
  state_->listening.reset();
  state_->thread.request_stop();
  state_->thread.join();
}

std::shared_ptr<void> WatchHub::Reserve(const std::string& key) {
  const std::lock_guard lock(*state_->places_mutex);
  auto& places = *state_->places;
  if (!places.contains(key) && places.size() >= state_->options.max_queries) {
    throw http::ProblemError("unavailable", std::to_string(state_->options.max_queries) +
                                                " different queries are watched already")
        .WithHeader("Retry-After", "5");
  }
  ++places[key];
  return {nullptr, [all = state_->places, mutex = state_->places_mutex, key](void*) {
            const std::lock_guard inner(*mutex);
            const auto found = all->find(key);
            if (--found->second == 0) all->erase(found);
          }};
}

void WatchHub::Subscribe(Standing standing, FirstEvent first,
                         std::shared_ptr<http::EventChannel> channel, std::shared_ptr<void> place,
                         std::function<bool()> allowed) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->arrivals.emplace_back(
        std::move(standing),
        Subscriber{first, std::move(channel), std::move(place), std::move(allowed), nullptr});
  }
  state_->Wake();
}

std::size_t WatchHub::subscribers() const { return state_->count; }

}  // namespace lares::api
