#pragma once
/// Values worked out beside the window's thread, again only when what they depend on has changed.

#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <utility>

namespace chartflood {

/// Where lazy values are worked out.
struct WorkPlace {
  bool immediate = false;      ///< by the caller, at once
  std::function<void()> wake;  ///< called from another thread when a value is ready; may be empty
};

/// Keeps the newest finished value. Not for several threads: all calls come from one.
template <typename Key, typename Value>
class LazyValue {
 public:
  /// The value for `key`, or the last one finished before while it is worked out; null at first.
  /// `make()` runs on another thread and must own all that it reads. While one value is under way
  /// no other is begun, so that changes in quick succession cost little.
  template <typename Make>
  std::shared_ptr<const Value> get(const Key& key, const WorkPlace& place, Make make) {
    take();
    if ((asked_ && *asked_ == key) || running_.valid()) return value_;
    asked_ = key;
    if (place.immediate) {
      value_ = std::make_shared<const Value>(make());
      return value_;
    }
    std::promise<std::shared_ptr<const Value>> promise;
    result_ = promise.get_future();
    running_ = std::async(std::launch::async, [promise = std::move(promise), wake = place.wake,
                                               make = std::move(make)]() mutable {
      try {
        promise.set_value(std::make_shared<const Value>(make()));
      } catch (...) {
        promise.set_exception(std::current_exception());
      }
      // Only now: whoever is woken finds the value.
      if (wake) wake();
    });
    return value_;
  }

 private:
  void take() {
    if (!result_.valid() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
      return;
    running_ = {};
    value_ = result_.get();
  }

  std::optional<Key> asked_;
  std::shared_ptr<const Value> value_;
  std::future<std::shared_ptr<const Value>> result_;
  std::future<void> running_;  ///< joins the thread
};

}  // namespace chartflood
