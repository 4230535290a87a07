#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace chartflood {

namespace {

/// Threads that wait for a batch of tasks; the caller of a batch works along.
class Pool {
 public:
  explicit Pool(unsigned workers) {
    for (unsigned i = 0; i < workers; ++i) threads_.emplace_back([this] { workerLoop(); });
  }
  ~Pool() {
    {
      std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }
  unsigned size() const { return static_cast<unsigned>(threads_.size()) + 1; }

  /// False when a batch already runs: the caller then does the work alone.
  bool run(std::size_t count, const std::function<void(std::size_t)>& task) {
    if (busy_.exchange(true)) return false;
    {
      std::lock_guard lock(mutex_);
      task_ = &task;
      count_ = count;
      next_.store(0);
      error_ = nullptr;
      active_ = static_cast<unsigned>(threads_.size());
      ++generation_;
    }
    wake_.notify_all();
    work();
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return active_ == 0; });
    task_ = nullptr;
    const std::exception_ptr error = std::exchange(error_, nullptr);
    lock.unlock();
    busy_.store(false);
    if (error) std::rethrow_exception(error);
    return true;
  }

 private:
  void work() {
    for (std::size_t i = next_.fetch_add(1); i < count_; i = next_.fetch_add(1)) {
      try {
        (*task_)(i);
      } catch (...) {
        std::lock_guard lock(mutex_);
        if (!error_) error_ = std::current_exception();
      }
    }
  }
  void workerLoop() {
    unsigned long seen = 0;
    while (true) {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [&] { return stopping_ || generation_ != seen; });
      if (stopping_) return;
      seen = generation_;
      lock.unlock();
      work();
      lock.lock();
      if (--active_ == 0) done_.notify_one();
    }
  }

  std::vector<std::thread> threads_;
  std::atomic<bool> busy_{false};
  std::mutex mutex_;
  std::condition_variable wake_, done_;
  const std::function<void(std::size_t)>* task_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_{0};
  std::exception_ptr error_;
  unsigned active_ = 0;
  unsigned long generation_ = 0;
  bool stopping_ = false;
};

std::mutex poolMutex;
std::shared_ptr<Pool> sharedPool;
unsigned wantedThreads = 0;

std::shared_ptr<Pool> pool() {
  std::lock_guard lock(poolMutex);
  if (!sharedPool) {
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    sharedPool = std::make_shared<Pool>((wantedThreads == 0 ? cores : wantedThreads) - 1);
  }
  return sharedPool;
}

}  // namespace

void setThreadCount(unsigned count) {
  std::lock_guard lock(poolMutex);
  wantedThreads = std::min(count, 256u);
  sharedPool.reset();
}

unsigned threadCount() { return pool()->size(); }

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& task) {
  if (count == 0) return;
  const std::shared_ptr<Pool> shared = pool();
  if (count > 1 && shared->size() > 1 && shared->run(count, task)) return;
  for (std::size_t i = 0; i < count; ++i) task(i);
}

void parallelBlocks(std::size_t count, std::size_t blockSize,
                    const std::function<void(std::size_t, std::size_t)>& task) {
  const std::size_t blocks = (count + blockSize - 1) / blockSize;
  parallelFor(blocks, [&](std::size_t block) {
    const std::size_t begin = block * blockSize;
    task(begin, std::min(begin + blockSize, count));
  });
}

}  // namespace chartflood
