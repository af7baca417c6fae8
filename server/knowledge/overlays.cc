#include "server/knowledge/overlays.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <memory>
#include <utility>

#include "base/aside.h"
#include "reasoner/owl/materialise.h"

namespace lares::server {
namespace {

std::string KeyOf(const std::vector<OverlaySource>& stack) {
  std::string key;
  for (const OverlaySource& source : stack) key += "|" + source.key;
  return key;
}

std::shared_future<Snapshot> InFuture(Snapshot snapshot) {
  std::promise<Snapshot> promise;
  promise.set_value(std::move(snapshot));
  return promise.get_future().share();
}

bool IsReady(const std::shared_future<Snapshot>& snapshot) {
  return snapshot.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

Snapshot Close(const Snapshot& below, const OverlaySource& source, rdf::Graph top,
               const std::stop_token& stop) {
  std::vector<rdf::Graph> graphs;
  graphs.push_back(std::move(top));
  const rdf::View view = below.view.With(
      Aside([&] { return owl::Materialise(below.view, std::move(graphs), {}, stop); }));
  return {source.complete ? source.complete(view) : view, below.generation};
}

}  // namespace

Overlays::Overlays(std::size_t capacity, std::function<void()> renewed)
    : capacity_(capacity),
      renewed_(std::move(renewed)),
      worker_([this](const std::stop_token& stop) { Work(stop); }) {}

Overlays::~Overlays() {
  worker_.request_stop();
  worker_.join();
}

Snapshot Overlays::Get(const Snapshot& catalogue, const std::vector<OverlaySource>& stack,
                       const rdf::Graph* top) {
  if (stack.empty()) return catalogue;
  const std::string key = KeyOf(stack);
  std::promise<Snapshot> promise;
  std::shared_future<Snapshot> known;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = by_key_.find(key); found != by_key_.end()) {
      by_use_.splice(by_use_.begin(), by_use_, found->second);
      known = found->second->snapshot;
    } else {
      by_use_.push_front({key, stack, promise.get_future().share(), false});
      by_key_[key] = by_use_.begin();
      DropOldest();
    }
  }
  if (known.valid()) return known.get();
  try {
    const Snapshot below = Get(catalogue, {stack.begin(), stack.end() - 1});
    Snapshot made = Close(below, stack.back(), top != nullptr ? *top : stack.back().read(), {});
    promise.set_value(made);
    const std::lock_guard lock(mutex_);
    if (const auto found = by_key_.find(key); found != by_key_.end()) MarkIfOld(*found->second);
    return made;
  } catch (...) {
    Forget(key);
    promise.set_exception(std::current_exception());
    throw;
  }
}

void Overlays::Renew(const Snapshot& catalogue) {
  const std::lock_guard lock(mutex_);
  if (newest_ && catalogue.generation <= newest_->generation) return;
  newest_ = catalogue;
  for (Entry& entry : by_use_) MarkIfOld(entry);
}

// One that is first made is looked at when it is there.
void Overlays::MarkIfOld(Entry& entry) {
  if (!newest_ || !IsReady(entry.snapshot)) return;
  if (entry.snapshot.get().generation >= newest_->generation) return;
  entry.is_due = true;
  changed_.notify_all();
}

void Overlays::DropOldest() {
  if (by_use_.size() <= capacity_) return;
  by_key_.erase(by_use_.back().key);
  by_use_.pop_back();
  changed_.notify_all();
}

void Overlays::Forget(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto found = by_key_.find(key);
  if (found == by_key_.end()) return;
  by_use_.erase(found->second);
  by_key_.erase(found);
}

Overlays::Entries::iterator Overlays::NextDue() {
  return std::find_if(by_use_.begin(), by_use_.end(),
                      [](const Entry& entry) { return entry.is_due; });
}

void Overlays::Wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !is_working_ && NextDue() == by_use_.end(); });
}

void Overlays::Work(const std::stop_token& stop) {
  GiveWay();
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [&] { return NextDue() != by_use_.end(); })) {
    if (stop.stop_requested()) return;
    const auto due = NextDue();
    due->is_due = false;
    is_working_ = true;
    const std::string key = due->key;
    const std::vector<OverlaySource> stack = due->stack;
    const Snapshot catalogue = *newest_;
    lock.unlock();
    try {
      RenewOne(catalogue, stack, stop);
    } catch (const std::exception&) {
      if (!stop.stop_requested()) Forget(key);
    }
    if (renewed_ && !stop.stop_requested()) renewed_();
    lock.lock();
    is_working_ = false;
    changed_.notify_all();
  }
}

// With what lies below it in the stack: what is new there already is used, the rest replaced.
void Overlays::RenewOne(const Snapshot& catalogue, const std::vector<OverlaySource>& stack,
                        const std::stop_token& stop) {
  Snapshot below = catalogue;
  std::vector<OverlaySource> lower;
  for (const OverlaySource& source : stack) {
    lower.push_back(source);
    const std::string key = KeyOf(lower);
    const auto newer = [&]() -> std::optional<Snapshot> {
      const auto found = by_key_.find(key);
      if (found == by_key_.end() || !IsReady(found->second->snapshot)) return std::nullopt;
      const Snapshot& kept = found->second->snapshot.get();
      if (kept.generation < catalogue.generation) return std::nullopt;
      return kept;
    };
    std::unique_lock lock(mutex_);
    if (const auto kept = newer()) {
      below = *kept;
      continue;
    }
    lock.unlock();
    below = Close(below, source, source.read(), stop);
    lock.lock();
    const auto found = by_key_.find(key);
    if (found == by_key_.end() || newer()) continue;
    found->second->snapshot = InFuture(below);
    found->second->is_due = false;
    MarkIfOld(*found->second);
  }
}

std::size_t Overlays::size() const {
  const std::lock_guard lock(mutex_);
  return by_use_.size();
}

}  // namespace lares::server
