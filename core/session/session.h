#pragma once
/// The running program without a window: mesh, parameters, seeds and results, with the work done by
/// one background worker (or inline, for batch runs and tests). The user interface and the command
/// line drive the same object.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/session/pipeline/results.h"

namespace chartflood {

/// All calls come from one thread (the window's or the batch runner's) and return at once when the
/// worker is threaded; with an inline worker they return when the work is done. A new request
/// replaces the one that waits; one that makes the running one pointless cancels it.
class Session {
 public:
  enum class Worker {
    Threaded,    ///< a thread of its own
    Background,  ///< the same, behind threads that answer the user where cores are few
    Inline,      ///< the caller's thread
  };
  explicit Session(Worker worker);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Replaces the mesh. On failure the old one stays and a notice says why.
  void open(const std::filesystem::path& file);
  /// Replaces the mesh by a sample of about `triangles` triangles (0: the sample's own number).
  void openSample(const std::string& name, std::size_t triangles = 0);
  /// Replaces the mesh by one at hand.
  void openMesh(std::shared_ptr<const Mesh> mesh);

  const Document& document() const;
  /// What new values are answered with.
  enum class Answer {
    Nothing,   ///< more than what they make stale before the flood, until a step is asked for
    Flood,     ///< where charts were shown, one flood from the present seeds
    Sketch,    ///< finished charts of less depth, soon: for values that are still being dragged
    Finished,  ///< the finished charts of a batch run with the same values, the same bytes
  };
  /// Takes new values. Old charts stay until the answer is there. A newer value cancels the answer
  /// to an older one, but for sketches, of which the one that is being made is shown.
  void setDocument(const Document& document, Answer answer = Answer::Flood);
  /// Takes new values and makes the charts of a moment again. Without seeds in the moment this is
  /// setDocument(document, otherwise).
  void restore(const Document& document, const FloodMoment& moment,
               Answer otherwise = Answer::Flood);

  /// Lays the present charts flat: cuts, unwraps and packs what is not up to date. Needs complete
  /// charts; a notice says so where there are none.
  void unwrap();
  /// Whether charts are laid flat by themselves whenever a stop rule has fired or a change made a
  /// flat result stale. Off at first.
  void setAutoUnwrap(bool on);
  /// Which logs of floods are kept; all by default. Labels are the same. Without any, charts have
  /// no moment to be made again from. Call it before anything is asked for.
  void setFloodLogs(FloodLogs logs);

  /// Advances the segmentation; steps asked for while one runs are queued after it.
  void step(StepUnit unit, std::size_t count = 1);
  /// Looks for the shortest seams with which no chart stretches more than the parameter's, over
  /// numbers of charts and relief cuts: Results::chartRuns. The present charts stay as they are.
  void findChartCount();
  /// Stops the running step at the next face and drops waiting ones. The state stays.
  void stop();
  /// Begins the present flood again with the same seeds, nothing taken.
  void resetFlood();
  /// Begins again with the first seeds.
  void resetSeeds();
  /// Adopts the labels of a finished round as the state (they are flooded again: floods are
  /// deterministic), so that stepping goes on from there.
  void adoptIteration(std::size_t iteration);
  /// Floods a finished round whose log was dropped once more, so that it can be looked at; the
  /// state stays.
  void recallRound(std::size_t iteration);

  /// The newest results, never null. Cheap; call once a frame.
  std::shared_ptr<const Results> results() const;
  WorkStatus status() const;
  /// Sentences since the last call.
  std::vector<Notice> takeNotices();
  /// Called from the worker whenever something new can be seen, to wake an event loop.
  void setWake(void (*wake)());
  /// Waits until nothing runs or waits (for scripts and tests).
  void waitIdle();

 private:
  class Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace chartflood
