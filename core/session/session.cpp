#include "core/session/session.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <utility>

#include "core/base/failure.h"
#include "core/io/read/file_checksum.h"
#include "core/io/read_mesh.h"
#include "core/model/build_mesh.h"
#include "core/samples/samples.h"
#include "core/session/job_queue.h"
#include "core/session/pipeline/pipeline.h"

namespace chartflood {

namespace {
JobQueue::Thread threadFor(Session::Worker worker) {
  switch (worker) {
  case Session::Worker::Threaded:
    return JobQueue::Thread::Own;
  case Session::Worker::Background:
    return JobQueue::Thread::OwnInBackground;
  case Session::Worker::Inline:
    break;
  }
  return JobQueue::Thread::Callers;
}
}  // namespace

/// The parts behind a Session: what the caller's thread owns, what the worker owns, and between
/// them, under one mutex, what is published.
class Session::Engine {
 public:
  explicit Engine(Worker worker)
      : pipeline_({[this](const FloodBegun& begun) { publishFlood(begun); },
                   [this](Notice notice) { post(std::move(notice)); }}),
        results_(std::make_shared<const Results>()), queue_(threadFor(worker)) {}

  // Called from the caller's thread.

  const Document& document() {
    if (dropSeeds_.exchange(false)) {
      document_.seeds.clear();
      document_.hints.clear();
    }
    return document_;
  }

  struct Opened {
    std::shared_ptr<const Mesh> mesh;  ///< null: was stopped
    std::string checksum = {};
  };
  /// Mesh from a source, on the worker; the old one stays when that throws or returns null.
  void open(std::function<Opened(Progress&)> source) {
    queue_.cancelAll();
    add(JobQueue::Kind::Open, [this, source = std::move(source)](Progress& progress) {
      const auto start = std::chrono::steady_clock::now();
      Opened opened = source(progress);
      if (!opened.mesh) {
        post({Notice::Kind::Info, "Opening was stopped; nothing was changed."});
        return;
      }
      const std::chrono::duration<double, std::milli> took =
          std::chrono::steady_clock::now() - start;
      pipeline_.setMesh(std::move(opened.mesh), took.count(), progress);
      dropSeeds_ = true;
      {
        std::lock_guard lock(mutex_);
        Results fresh;
        fresh.version = results_->version;
        fresh.checksum = std::move(opened.checksum);
        results_ = std::make_shared<const Results>(std::move(fresh));
      }
      publish(false);
    });
  }

  void setDocument(const Document& document, Answer answer) {
    takeValues(document, answer);
    if (answer == Answer::Sketch || answer == Answer::Finished) return explore(document, answer);
    const bool live = answer == Answer::Flood;
    add(JobQueue::Kind::Apply, [this, document, live](Progress& progress) {
      const bool changed = pipeline_.apply(document, live, progress);
      if (pipeline_.takeVoidSeeds()) dropSeeds_ = true;
      publish(changed && !pipeline_.stale());
      if (live) unwrapWhenDue(progress);
    });
  }

  void explore(const Document& document, Answer answer) {
    const bool sketch = answer == Answer::Sketch;
    const auto kind = sketch ? JobQueue::Kind::Sketch : JobQueue::Kind::Apply;
    const Depth depth = sketch ? Depth::Sketch : Depth::Whole;
    add(kind, [this, document, depth](Progress& progress) {
      pipeline_.explore(document, depth, progress);
      if (pipeline_.takeVoidSeeds()) dropSeeds_ = true;
      publish(false);
      unwrapWhenDue(progress);
    });
  }

  void unwrap() {
    queue_.cancel(JobQueue::Kind::Unwrap);
    add(JobQueue::Kind::Unwrap, [this](Progress& progress) {
      if (!requireMesh()) return;
      if (!pipeline_.complete()) {
        post({Notice::Kind::Error, "There are no complete charts yet: finish a flood first."});
        return;
      }
      if (pipeline_.unwrap(progress)) publish(false);
    });
  }

  void setAutoUnwrap(bool on) { autoUnwrap_ = on; }
  void setFloodLogs(FloodLogs logs) { pipeline_.setFloodLogs(logs); }

  void restore(const Document& document, const FloodMoment& moment, Answer otherwise) {
    if (moment.start.seeds.empty()) return setDocument(document, otherwise);
    takeValues(document, otherwise);
    add(JobQueue::Kind::Apply, [this, document, moment](Progress& progress) {
      const bool made = pipeline_.restore(document, moment, progress);
      if (pipeline_.takeVoidSeeds()) dropSeeds_ = true;
      publish(made);
      unwrapWhenDue(progress);
    });
  }

  void step(StepUnit unit, std::size_t count) {
    queue_.cancel(JobQueue::Kind::Unwrap);
    add(JobQueue::Kind::Step, [this, unit, count](Progress& progress) {
      if (!requireMesh()) return;
      // From charts that are no batch run's the way to the end is one.
      if (unit == StepUnit::Converged && pipeline_.unsettled()) {
        const Document document = pipeline_.document();
        pipeline_.explore(document, Depth::Whole, progress);
        publish(false);
        return unwrapWhenDue(progress);
      }
      if (unit == StepUnit::Converged && pipeline_.triesSeeds()) {
        const StepOutcome outcome = pipeline_.stepWithSeeds(progress);
        publish(outcome != StepOutcome::Cancelled);
        return unwrapWhenDue(progress);
      }
      // Whole rounds are taken one by one, so that each can be seen when it is done.
      const bool untilEnd = unit == StepUnit::Converged;
      const bool byRounds = unit != StepUnit::Face;
      const StepUnit each = untilEnd ? StepUnit::Flood : unit;
      std::size_t left = byRounds ? count : 1;
      StepOutcome outcome = StepOutcome::Advanced;
      while (outcome == StepOutcome::Advanced && (untilEnd || left > 0)) {
        outcome = pipeline_.step(each, byRounds ? 1 : count, progress);
        --left;
        const bool more = outcome == StepOutcome::Advanced && (untilEnd || left > 0);
        publish(!more);
      }
      unwrapWhenDue(progress);
    });
  }

  void findChartCount() {
    queue_.cancel(JobQueue::Kind::Step);
    add(JobQueue::Kind::Step, [this](Progress& progress) {
      if (requireMesh() && pipeline_.findChartCount(progress)) publish(false);
    });
  }

  void withCharts(std::function<void(Progress&)> change) {
    queue_.cancel(JobQueue::Kind::Step);
    queue_.cancel(JobQueue::Kind::Unwrap);
    add(JobQueue::Kind::Step, [this, change = std::move(change)](Progress& progress) {
      if (!requireMesh()) return;
      change(progress);
      publish(true);
    });
  }

  void recall(std::size_t iteration) {
    add(JobQueue::Kind::Step, [this, iteration](Progress& progress) {
      pipeline_.recall(iteration, progress);
      publish(false);
    });
  }

  Pipeline& pipeline() { return pipeline_; }
  void stop() { queue_.cancelAll(); }
  void waitIdle() { queue_.waitIdle(); }

  std::shared_ptr<const Results> results() const {
    std::lock_guard lock(mutex_);
    return results_;
  }

  WorkStatus status() const {
    const JobQueue::Status status = queue_.status();
    WorkStatus work;
    work.busy = status.busy;
    work.seconds = status.seconds;
    work.unwrapping = status.progress && status.kind == JobQueue::Kind::Unwrap;
    if (status.progress) {
      work.phase = status.progress->phase();
      work.fraction = status.progress->fraction();
    }
    return work;
  }

  std::vector<Notice> takeNotices() {
    std::lock_guard lock(mutex_);
    return std::exchange(notices_, {});
  }

  void setWake(void (*call)()) { wake_ = call; }

 private:
  /// On the caller's thread: older values, and what would be done with them, are void.
  void takeValues(const Document& document, Answer answer) {
    dropSeeds_ = false;
    document_ = document;
    queue_.cancel(JobQueue::Kind::Step);
    queue_.cancel(JobQueue::Kind::Apply);
    queue_.cancel(JobQueue::Kind::Unwrap);
    // While a value is dragged, what is shown must come to an end now and then.
    if (answer == Answer::Sketch) return queue_.drop(JobQueue::Kind::Sketch);
    queue_.cancel(JobQueue::Kind::Sketch);
  }

  /// Adds a job whose failures become notices.
  void add(JobQueue::Kind kind, JobQueue::Job job) {
    queue_.add(kind, [this, job = std::move(job)](Progress& progress) {
      try {
        job(progress);
      } catch (const std::exception& failure) {
        post({Notice::Kind::Error, failureSentence(failure)});
      }
      wake();
    });
  }

  /// On the worker: has finished charts laid flat after the running job, unless that was stopped at
  /// its very end: whoever wants the worker to rest means what would follow, too.
  void unwrapWhenDue(const Progress& job) {
    if (job.cancelled() || !autoUnwrap_ || !pipeline_.awaitsUnwrap()) return;
    add(JobQueue::Kind::Unwrap, [this](Progress& progress) {
      if (pipeline_.awaitsUnwrap() && pipeline_.unwrap(progress)) publish(false);
    });
  }

  bool requireMesh() {
    if (pipeline_.hasMesh()) return true;
    post({Notice::Kind::Error, "There is no model to cut: open one first."});
    return false;
  }

  /// Makes the present state visible; with `measured`, with new labels and figures.
  void publish(bool measured) {
    if (measured) pipeline_.measure();
    {
      std::lock_guard lock(mutex_);
      auto next = std::make_shared<Results>(*results_);
      pipeline_.report(*next);
      ++next->version;
      results_ = std::move(next);
    }
    wake();
  }

  /// Makes the log of a flood visible before it begins to grow.
  void publishFlood(const FloodBegun& begun) {
    {
      std::lock_guard lock(mutex_);
      auto next = std::make_shared<Results>(*results_);
      next->record = begun.record;
      next->start = begun.start;
      pipeline_.reportRounds(*next);
      next->recordIteration = begun.iteration;
      next->finished = false;
      ++next->version;
      results_ = std::move(next);
    }
    wake();
  }

  void post(Notice notice) {
    {
      std::lock_guard lock(mutex_);
      notices_.push_back(std::move(notice));
    }
    wake();
  }

  void wake() const {
    void (*const call)() = wake_;
    if (call != nullptr) call();
  }

  Document document_;                   // the caller's
  Pipeline pipeline_;                   // the worker's
  std::atomic<bool> dropSeeds_{false};  ///< a new mesh came: seeds and hints of the old are void
  std::atomic<bool> autoUnwrap_{false};
  std::atomic<void (*)()> wake_{nullptr};
  mutable std::mutex mutex_;
  std::shared_ptr<const Results> results_;
  std::vector<Notice> notices_;
  JobQueue queue_;  // last: its thread ends before what it uses
};

Session::Session(Worker worker) : engine_(std::make_unique<Engine>(worker)) {}
Session::~Session() = default;

void Session::open(const std::filesystem::path& file) {
  const double weld = weldDistance(document().parameters);
  engine_->open([file, weld](Progress& progress) -> Engine::Opened {
    progress.beginPhase("Reading");
    std::shared_ptr<const InputMesh> input = readMesh(file, &progress);
    if (!input) return {nullptr};
    std::string checksum = fileChecksum(file);
    progress.beginPhase("Gluing faces");
    return {buildMesh(std::move(input), weld), std::move(checksum)};
  });
}

void Session::openSample(const std::string& name, std::size_t triangles) {
  const double weld = weldDistance(document().parameters);
  engine_->open([name, triangles, weld](Progress& progress) -> Engine::Opened {
    progress.beginPhase("Making the sample");
    return {buildMesh(makeSample(name, triangles), weld)};
  });
}

void Session::openMesh(std::shared_ptr<const Mesh> mesh) {
  engine_->open([mesh = std::move(mesh)](Progress&) -> Engine::Opened { return {mesh}; });
}

const Document& Session::document() const { return engine_->document(); }

void Session::setDocument(const Document& document, Answer answer) {
  engine_->setDocument(document, answer);
}

void Session::restore(const Document& document, const FloodMoment& moment, Answer otherwise) {
  engine_->restore(document, moment, otherwise);
}

void Session::step(StepUnit unit, std::size_t count) { engine_->step(unit, count); }

void Session::findChartCount() { engine_->findChartCount(); }

void Session::unwrap() { engine_->unwrap(); }

void Session::setFloodLogs(FloodLogs logs) { engine_->setFloodLogs(logs); }
void Session::setAutoUnwrap(bool on) { engine_->setAutoUnwrap(on); }

void Session::stop() { engine_->stop(); }

void Session::resetFlood() {
  engine_->withCharts([engine = engine_.get()](Progress&) { engine->pipeline().restartFlood(); });
}

void Session::resetSeeds() {
  engine_->withCharts([engine = engine_.get()](Progress&) { engine->pipeline().resetSeeds(); });
}

void Session::adoptIteration(std::size_t iteration) {
  engine_->withCharts([engine = engine_.get(), iteration](Progress& progress) {
    engine->pipeline().adopt(iteration, progress);
  });
}

void Session::recallRound(std::size_t iteration) { engine_->recall(iteration); }

std::shared_ptr<const Results> Session::results() const { return engine_->results(); }
WorkStatus Session::status() const { return engine_->status(); }
std::vector<Notice> Session::takeNotices() { return engine_->takeNotices(); }
void Session::setWake(void (*wake)()) { engine_->setWake(wake); }
void Session::waitIdle() { engine_->waitIdle(); }

}  // namespace chartflood
