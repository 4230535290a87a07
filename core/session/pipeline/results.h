#pragma once
/// What a session has computed so far, what it says about it, and how far the work is.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/atlas.h"
#include "core/model/chart_set.h"
#include "core/model/chart_stats.h"
#include "core/model/flood_record.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
#include "core/model/seam_record.h"
#include "core/model/segmentation.h"
#include "core/model/unwrap.h"
#include "core/segment/parts/segmenter.h"
#include "core/session/pipeline/document.h"
#include "core/session/pipeline/flood_history.h"

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
  /// they belong to `segmentation` and the present parameters, or are to be looked at only.
  std::shared_ptr<const ChartSet> charts;
  std::shared_ptr<const Unwrap> unwrap;
  std::shared_ptr<const Atlas> atlas;
  bool flat = false;
  /// The flood under way or last done; grows while the worker floods.
  std::shared_ptr<const FloodRecord> record;
  std::size_t recordIteration = 0;  ///< round that `record` belongs to
  FloodStart start;                 ///< of the round of `record`
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
  bool unsettled =
      false;            ///< finished charts that a batch run of the present values would not give
  bool sketch = false;  ///< charts made in a hurry while a value is dragged: no batch run's
  Timing timing;
  Parameters parameters;                                ///< that the results were made with
  std::size_t features = static_cast<std::size_t>(-1);  ///< of the mesh, see featureCount()
  std::vector<PlacedSeed> placed;  ///< the document's seeds that they were made with
  std::string checksum;            ///< of the mesh's file, see fileChecksum(); "" for others
};

/// Where the charts that are shown came from; without seeds when they are stale or a sketch, or
/// there are none.
FloodMoment momentOf(const Results& results);

/// Whether the charts are those of the parameters beside them: neither stale nor a sketch.
bool settled(const Results& results);

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

}  // namespace chartflood
