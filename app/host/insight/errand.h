#pragma once
/// One piece of work beside the window's thread.

#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <optional>
#include <utility>

namespace chartflood {

/// Where work is done.
struct WorkPlace {
  bool immediate = false;      ///< by the caller, at once
  std::function<void()> wake;  ///< called from another thread when a value is ready; may be empty
};

/// Not for several threads: all calls come from one.
template <typename Value>
class Errand {
 public:
  /// True from begin() until the value was taken.
  bool running() const { return running_.valid(); }

  /// `make()` runs on a thread of its own and must own all that it reads. \pre !running()
  template <typename Make>
  void begin(const std::function<void()>& wake, Make make) {
    std::promise<Value> promise;
    result_ = promise.get_future();
    running_ = std::async(std::launch::async,
                          [promise = std::move(promise), wake, make = std::move(make)]() mutable {
                            try {
                              promise.set_value(make());
                            } catch (...) {
                              promise.set_exception(std::current_exception());
                            }
                            // Only now: whoever is woken finds the value.
                            if (wake) wake();
                          });
  }

  /// The value, once, when it is ready; throws what make() threw.
  std::optional<Value> take() {
    if (!running() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      return std::nullopt;
    }
    running_ = {};
    return result_.get();
  }

 private:
  std::future<Value> result_;
  std::future<void> running_;  ///< joins the thread
};

}  // namespace chartflood
