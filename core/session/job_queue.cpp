#include "core/session/job_queue.h"

#include <chrono>
#include <utility>

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace chartflood {

namespace {

/// Lets threads that answer the user go first where cores are few; threads made from here inherit
/// it. Nothing depends on it, so a refusal needs no answer.
void workBehindTheWindow() {
#ifdef __linux__
  constexpr int kNiceness = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness);
#endif
}

double now() {
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(time).count();
}
}  // namespace

JobQueue::JobQueue(Thread thread) : threaded_(thread != Thread::Callers) {
  if (!threaded_) return;
  thread_ = std::thread([this, background = thread == Thread::OwnInBackground] {
    if (background) workBehindTheWindow();
    workerLoop();
  });
}

JobQueue::~JobQueue() {
  if (!threaded_) return;
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
    waiting_.clear();
    if (running_) running_->cancel();
  }
  wake_.notify_one();
  thread_.join();
}

void JobQueue::add(Kind kind, Job job) {
  if (!threaded_) {
    Progress progress;
    job(progress);
    return;
  }
  {
    std::lock_guard lock(mutex_);
    if (!running_ && waiting_.empty()) busySince_ = now();
    waiting_.push_back({kind, std::move(job)});
  }
  wake_.notify_one();
}

void JobQueue::cancel(Kind kind) {
  std::lock_guard lock(mutex_);
  std::erase_if(waiting_, [&](const Entry& entry) { return entry.kind == kind; });
  if (running_ && runningKind_ == kind) running_->cancel();
}

void JobQueue::drop(Kind kind) {
  std::lock_guard lock(mutex_);
  std::erase_if(waiting_, [&](const Entry& entry) { return entry.kind == kind; });
}

void JobQueue::cancelAll() {
  std::lock_guard lock(mutex_);
  std::erase_if(waiting_, [](const Entry& entry) {
    return entry.kind != Kind::Apply && entry.kind != Kind::Sketch;
  });
  if (running_) running_->cancel();
}

void JobQueue::waitIdle() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [this] { return waiting_.empty() && !running_; });
}

JobQueue::Status JobQueue::status() const {
  std::lock_guard lock(mutex_);
  Status status;
  status.busy = running_ || !waiting_.empty();
  status.progress = running_;
  status.kind = runningKind_;
  if (status.busy) status.seconds = now() - busySince_;
  return status;
}

void JobQueue::workerLoop() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (stopping_) return;
    Entry entry = std::move(waiting_.front());
    waiting_.pop_front();
    running_ = std::make_shared<Progress>();
    runningKind_ = entry.kind;
    const std::shared_ptr<Progress> progress = running_;
    lock.unlock();
    entry.job(*progress);
    entry.job = nullptr;
    lock.lock();
    running_.reset();
    if (waiting_.empty()) idle_.notify_all();
  }
}

}  // namespace chartflood
