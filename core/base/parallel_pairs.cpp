#include "core/base/parallel_pairs.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <queue>
#include <vector>

#include "core/base/parallel.h"

namespace chartflood {

namespace {

/// Which pairs may begin: those that wait for no earlier one, the first of them first.
class PairQueue {
 public:
  PairQueue(std::span<const std::pair<Index, Index>> pairs, std::size_t things)
      : next_(pairs.size(), {kNone, kNone}), waiting_(pairs.size(), 0), left_(pairs.size()) {
    std::vector<Index> last(things, kNone);
    for (Index i = 0; i < pairs.size(); ++i) {
      for (const Index thing : {pairs[i].first, pairs[i].second}) {
        if (last[thing] != kNone) {
          auto& [first, second] = next_[last[thing]];
          (first == kNone ? first : second) = i;
          ++waiting_[i];
        }
        last[thing] = i;
      }
      if (waiting_[i] == 0) ready_.push(i);
    }
  }

  /// Waits for a pair that may begin; kNone when there is nothing left to do.
  Index take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stopped_ || left_ == 0 || !ready_.empty(); });
    if (stopped_ || left_ == 0) return kNone;
    const Index i = ready_.top();
    ready_.pop();
    return i;
  }
  void finish(Index i) {
    const std::lock_guard lock(mutex_);
    for (const Index next : {next_[i].first, next_[i].second}) {
      if (next != kNone && --waiting_[next] == 0) ready_.push(next);
    }
    --left_;
    changed_.notify_all();
  }
  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    changed_.notify_all();
  }

 private:
  std::vector<std::pair<Index, Index>> next_;  ///< that each pair holds up
  std::vector<int> waiting_;                   ///< how many each pair waits for
  std::priority_queue<Index, std::vector<Index>, std::greater<>> ready_;
  std::size_t left_;
  bool stopped_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
};

}  // namespace

void parallelPairs(std::span<const std::pair<Index, Index>> pairs, std::size_t things,
                   const std::function<bool(std::size_t, std::size_t)>& task) {
  PairQueue queue(pairs, things);
  parallelFor(threadCount(), [&](std::size_t worker) {
    for (Index i = queue.take(); i != kNone; i = queue.take()) {
      try {
        if (task(i, worker)) {
          queue.finish(i);
        } else {
          queue.stop();
        }
      } catch (...) {
        queue.stop();
        throw;
      }
    }
  });
}

}  // namespace chartflood
