#pragma once
/// The running program without a window: mesh, parameters, seeds and results, with the work done by
/// one background worker (or inline, for batch runs and tests). The user interface and the command
/// line drive the same object.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/model/atlas.h"
#include "core/model/chart_set.h"
#include "core/model/chart_stats.h"
#include "core/model/flood_record.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
#include "core/model/seam_record.h"
#include "core/model/segmentation.h"
#include "core/model/unwrap.h"
#include "core/segment/segmenter.h"
#include "core/session/document.h"
#include "core/session/flood_history.h"

namespace chartflood {

/// How long each stage took, milliseconds; negative when it did not run.
struct Timing {
  double read = -1, gaussArea = -1, floodGraph = -1, segment = -1;
  double cut = -1, unwrap = -1, pack = -1;
};

struct RunSet;

/// Everything computed so far. Immutable; parts are shared between versions. Parts that a change
/// made stale stay until their new version is ready (`stale` says so).
struct Results {
  std::uint64_t version = 0;                        ///< grows with every publication
  std::uint64_t meshVersion = 0, gaussVersion = 0;  ///< grow when that part is a new one
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const GaussArea> gaussArea;
  std::shared_ptr<const Segmentation> segmentation;  ///< at the end of the last step
  std::shared_ptr<const ChartStats> chartStats;      ///< of `segmentation`
  /// The charts laid flat: all three or none. They stay while charts change; `flat` tells whether
  /// they belong to `segmentation` and the present parameters.
  std::shared_ptr<const ChartSet> charts;
  std::shared_ptr<const Unwrap> unwrap;
  std::shared_ptr<const Atlas> atlas;
  bool flat = false;
  /// The flood under way or last done; grows while the worker floods.
  std::shared_ptr<const FloodRecord> record;
  std::size_t recordIteration = 0;       ///< round that `record` belongs to
  std::vector<Index> seeds;              ///< of the round of `record`
  std::vector<double> offsets;           ///< of the round of `record`, one a seed or none
  std::vector<glm::dvec3> normals;       ///< of the round of `record`, one a seed or none
  std::optional<std::uint32_t> creases;  ///< as in FloodMoment
  std::optional<FastFlood> fast;         ///< as in FloodMoment
  /// Steps of the refinement from the flooded labels to the final ones; null when there was none.
  std::shared_ptr<const SeamRecord> seamRecord;
  std::vector<IterationSummary> history;
  /// Logs of the rounds of `history`; null where one was dropped, see recallRound().
  std::vector<std::shared_ptr<const FloodRecord>> floods;
  std::size_t bestIteration = 0;
  StopReason stopReason = StopReason::NotStopped;
  bool finished = false;                    ///< a stop rule has fired and the borders were finished
  std::shared_ptr<const RunSet> seedRuns;   ///< seeds tried for these charts; null: one
  std::shared_ptr<const RunSet> chartRuns;  ///< the last search for the number of charts
  bool stale = false;
  Timing timing;
  Parameters parameters;                                ///< that the results were made with
  std::size_t features = static_cast<std::size_t>(-1);  ///< of the mesh, see featureCount()
  std::vector<PlacedSeed> placed;  ///< the document's seeds that they were made with
  std::string checksum;            ///< of the mesh's file, see fileChecksum(); "" for others
};

/// Where the charts that are shown came from; without seeds when they are stale or there are none.
FloodMoment momentOf(const Results& results);

/// A sentence for the user, in the order of events.
struct Notice {
  enum class Kind { Info, Warning, Error } kind = Kind::Info;
  std::string text;
};

/// What the worker does right now.
struct WorkStatus {
  bool busy = false;
  const char* phase = "";   ///< name of the stage, "" when idle
  float fraction = 0;       ///< of the stage
  double seconds = 0;       ///< since the job began
  bool unwrapping = false;  ///< lays charts flat: the labels are final while it works
};

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
  /// Takes new values. What they make stale is recomputed: the Gauss area at once; when charts
  /// were shown, one flood from the present seeds with the new values (`live`), otherwise nothing
  /// more until a step is asked for.
  void setDocument(const Document& document, bool live = true);
  /// Takes new values and makes the charts of a moment again. Without seeds in the moment this is
  /// setDocument(document).
  void restore(const Document& document, const FloodMoment& moment);

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
