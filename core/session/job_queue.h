#pragma once
/// One worker, one running job, newest wins: the background work of a session.

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "core/base/progress.h"

namespace chartflood {

/// Runs jobs in order, on a thread of its own or on the caller's. Jobs must not throw.
class JobQueue {
 public:
  /// What a job is for: decides which jobs a new one makes pointless.
  enum class Kind { Open, Apply, Sketch, Step, Unwrap };
  using Job = std::function<void(Progress&)>;

  enum class Thread { Own, OwnInBackground, Callers };
  explicit JobQueue(Thread thread);
  /// Cancels everything and waits for the running job to end.
  ~JobQueue();
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  /// Adds a job. Inline queues run it before they return.
  void add(Kind kind, Job job);
  /// Cancels the running job and drops waiting ones, if their kind is `kind`.
  void cancel(Kind kind);
  /// Drops waiting jobs of a kind; a running one goes on.
  void drop(Kind kind);
  /// Cancels the running job and drops waiting ones. New values (Apply) still wait: whoever gave
  /// them goes on to count on them.
  void cancelAll();
  /// Blocks until nothing runs or waits.
  void waitIdle();

  struct Status {
    bool busy = false;
    std::shared_ptr<const Progress> progress;  ///< of the running job
    Kind kind = Kind::Open;                    ///< of the running job
    double seconds = 0;                        ///< since the queue became busy
  };
  Status status() const;

 private:
  struct Entry {
    Kind kind;
    Job job;
  };
  void workerLoop();

  mutable std::mutex mutex_;
  std::condition_variable wake_, idle_;
  std::deque<Entry> waiting_;
  std::shared_ptr<Progress> running_;
  Kind runningKind_ = Kind::Open;
  double busySince_ = 0;
  bool stopping_ = false;
  bool threaded_;
  std::thread thread_;
};

}  // namespace chartflood
