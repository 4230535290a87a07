#pragma once
/// The small interface that every segmentation method implements.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/progress.h"
#include "core/model/flood_graph.h"
#include "core/model/flood_record.h"
#include "core/model/flood_start.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
#include "core/model/seam_record.h"
#include "core/model/segmentation.h"
#include "core/segment/parts/chart_price.h"

namespace chartflood {

/// How far one call goes.
enum class StepUnit {
  Face,   ///< count incorporations; a finished flood goes on with the next one
  Flood,  ///< to the end of the present flood (of the next one when it is complete), count times
  Iteration,  ///< finish the present flood, move the seeds and flood again, count times
  Converged,  ///< until a stop rule fires, then refine the borders of the best round
};

enum class StepOutcome {
  Advanced,   ///< went as far as asked
  Finished,   ///< a stop rule fired: stopReason() says which
  Cancelled,  ///< asked to stop; the state is valid and can go on
};

/// A segmentation under way. One thread drives it; what it hands out is immutable (records grow)
/// and may be read by any thread. However the way is cut into calls, the results are equal.
class Stepper {
 public:
  virtual ~Stepper() = default;

  virtual StepOutcome advance(StepUnit unit, std::size_t count, Progress& progress) = 0;

  /// The labels as they are now; after Finished the final ones.
  virtual std::shared_ptr<const Segmentation> state() const = 0;
  /// Log of the present flood. Grows while advance() runs.
  virtual std::shared_ptr<const FloodRecord> record() const = 0;
  /// What the refinement of borders did; null before it is done and when there was none.
  virtual std::shared_ptr<const SeamRecord> seamRecord() const = 0;
  /// Finished rounds, oldest first.
  virtual std::span<const IterationSummary> history() const = 0;
  /// Index into history() of the best round so far; 0 when there is none yet.
  virtual std::size_t bestIteration() const = 0;
  virtual StopReason stopReason() const = 0;
  /// True once advance() has returned Finished: the state is the final one.
  virtual bool finished() const = 0;

  /// Floods a round of the history again and makes it the present state, as if it had just been
  /// finished; later rounds stay in the history.
  virtual StepOutcome adopt(std::size_t iteration, Progress& progress) = 0;
  /// Begins the present flood again: same seeds and offsets, nothing taken.
  virtual void restartFlood() = 0;
  /// The log of a finished round made once more, for looking at; the present state stays as it is.
  /// Null when cancelled.
  virtual std::shared_ptr<const FloodRecord> replay(std::size_t iteration, Progress& progress) = 0;
};

/// What every method starts from. The parts are shared, so steppers outlive a change of mesh.
struct SegmentInputs {
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const GaussArea> gaussArea;
  std::shared_ptr<const FloodGraph> floodGraph;
};

/// A flood that is about to begin.
struct FloodBegun {
  std::shared_ptr<const FloodRecord> record;  ///< null when none is kept
  std::size_t iteration = 0;                  ///< number of its round
  FloodStart start;
};

/// How t-flooding comes to its first seeds.
enum class SeedPlacement {
  Spread,    ///< all at once, far apart
  OneByOne,  ///< a flood before each, after which the seeds move: the paper's way (section 3.4)
};

/// What the methods that grow charts by normals even out between charts, beyond their papers.
enum class EvenGrowth {
  Off,
  Error,  ///< what the method itself lowers
  Area,   ///< surface
};

/// What makes a round of t-flooding better than another.
enum class RoundMeasure {
  Relative,  ///< standard deviation of Gauss area over its mean
  Printed,   ///< equation 3, steradians
};

/// What t-flooding floods round after round.
enum class SearchKind {
  Literal,  ///< the whole mesh: the paper's way
  Fast,     ///< a coarse graph, then a band around the seams: makeFastFlooding()
};

/// How variational shape approximation comes to its charts.
enum class VsaSeeding {
  OneByOne,  ///< the worst face of the worst chart is a new seed, one flood for each
  Doubling,  ///< the worst face of every chart is a new seed, a few floods for each doubling
  Random,    ///< all at once at random
};

/// Of variational shape approximation.
struct VsaOptions {
  VsaSeeding seeding = VsaSeeding::OneByOne;
  bool teleport = true;  ///< stuck charts are joined, the freed seed goes where it is worst
};

/// Of multi-chart geometry images.
struct McgimOptions {
  double lambda = 1;            ///< how much distance counts against planarity
  bool runningNormals = false;  ///< a chart's normal follows the faces that come in
  bool disks = false;           ///< charts refuse faces that would make them more than disks
};

/// How borders are refined once a method is done.
enum class RefineKind {
  None,
  Moves,  ///< single faces change sides: BorderMoves
  Cuts,   ///< minimum cuts between charts: SeamCuts
};

struct RefineOptions {
  RefineKind kind = RefineKind::Cuts;
  double balanceWeight = 1000;  ///< w of the cuts
  double creaseWeight = 0.3;    ///< length of a crease line against other edges', of the cuts
  double cleanUp = 1000;        ///< weight of balance of the moves
  bool sketch = false;          ///< cuts: few stages, for a look while values are dragged
  bool oneSided = false;        ///< cuts: only charts above their share of the whole cost
  /// Factor on the length of each side of the mesh, from hints; null: 1.
  std::shared_ptr<const std::vector<double>> sideFactor;
  /// What the method itself pays for a face in a chart, beside seams; null: nothing.
  std::shared_ptr<ChartPrice> price;
};

/// What the methods can be told; each uses what it knows.
struct SegmentOptions {
  std::size_t charts = 20;
  std::vector<Index> seeds;         ///< first seeds, may be fewer than charts
  std::vector<Index> locked;        ///< faces of those that stay where they are in all rounds
  std::vector<double> offsets;      ///< of the first round, one per seed; empty: zero
  std::vector<glm::dvec3> normals;  ///< of the first round, one per seed; empty: those of the faces
  std::uint32_t rngSeed = 1;
  bool creasesFirst = false;  ///< of a start from creases: they come before short seams
  SearchKind search = SearchKind::Literal;
  SeedPlacement placement = SeedPlacement::Spread;     ///< of the literal search
  RoundMeasure roundMeasure = RoundMeasure::Relative;  ///< of the literal search
  FastFlood fast;  ///< what the first flood of the fast search runs on, to go on from
  bool useOffsets = true;
  double offsetDamping = 0.3;
  bool lookahead = true;
  std::size_t maxIterations = 60;
  std::size_t patience = 10;
  bool detectCycles = true;
  std::size_t settle = 4;  ///< rounds without gain that end balancing with seeds at rest
  bool keepLast = false;   ///< the last round is kept at the end, not the best one
  RefineOptions refine;
  EvenGrowth even = EvenGrowth::Off;  ///< of the methods that grow by normals
  VsaOptions vsa;
  McgimOptions mcgim;
  bool record = true;  ///< keep a log of the present flood
  /// Told of each flood as it begins, on the thread that drives the stepper.
  std::function<void(const FloodBegun&)> onFlood;

  bool isLocked(Index seed) const {
    return std::find(locked.begin(), locked.end(), seed) != locked.end();
  }
};

}  // namespace chartflood
