#pragma once
/// What the views and plots show beside the results themselves, worked out when it is first asked
/// for and again only when the results change. Shared by all that draw.

#include <functional>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "app/host/insight/histogram.h"
#include "app/host/insight/lazy_value.h"
#include "app/host/insight/problem_marks.h"
#include "app/host/insight/problems.h"
#include "app/host/insight/sphere_patch.h"
#include "app/host/insight/surface_derived.h"
#include "core/model/triangle_tree.h"
#include "core/session/session.h"

namespace chartflood {

/// The moment of a flood that is shown.
struct ShownMoment {
  std::shared_ptr<const ChartStats> stats;
  std::shared_ptr<const FloodRecord> record;
  std::size_t taken = 0;  ///< entries of `record`
};

/// Each call gives what is ready now: null at first, and the older value while a new one is worked
/// out on a thread of its own. Call from one thread.
class Insight {
 public:
  /// `immediate`: everything is worked out within the call (scripts and tests).
  explicit Insight(bool immediate);
  /// One for other results, worked out in the same place and waking whom this one wakes.
  std::unique_ptr<Insight> beside() const;
  /// Where values are worked out; whom it wakes is always whom this one wakes.
  const WorkPlace& place() const { return place_; }
  /// Called from another thread when something new can be shown.
  /// When this returns the one before is not running and never will again.
  void setWake(std::function<void()> wake);

  /// Null until it belongs to the mesh of the results.
  std::shared_ptr<const SurfaceDerived> surface(const Results& results);
  /// For picking; null until it belongs to the mesh of the results.
  std::shared_ptr<const TriangleTree> tree(const Results& results);
  std::shared_ptr<const std::vector<Problem>> problems(const Results& results);
  /// True when both have the same problems, as far as can be told without looking for them.
  static bool sameProblems(const Results& one, const Results& other);
  /// The same as it is drawn; null until it belongs to the segmentation of the results.
  std::shared_ptr<const SurfaceMarks> problemMarks(const Results& results);
  /// Histograms of the present colour mode at a moment.
  std::shared_ptr<const std::vector<ModeHistogram>>
  histograms(const Results& results, const ShownMoment& moment, const RenderSettings& settings);
  /// Normals of a chart; null until it belongs to that chart of the present labels.
  std::shared_ptr<const SpherePatch> patch(const Results& results, Index chart);
  std::shared_ptr<const std::vector<SphereDot>> dots(const Results& results);

 private:
  /// What was found in one segmentation.
  struct ProblemReport {
    std::shared_ptr<const Segmentation> segmentation;
    std::vector<Problem> problems;
    SurfaceMarks marks;
  };
  using Histograms = std::vector<ModeHistogram>;
  using Dots = std::vector<SphereDot>;
  /// A patch with what it was made from.
  struct OwnedPatch {
    std::shared_ptr<const SurfaceDerived> surface;
    std::shared_ptr<const Segmentation> segmentation;
    std::shared_ptr<const SpherePatch> patch;
  };
  /// What a histogram depends on, and how it is cut.
  struct HistogramKey {
    ModeSource source;
    ColorMode mode{};
    std::optional<ScalarScale> scale;
    std::optional<std::pair<double, double>> range;

    bool operator==(const HistogramKey&) const = default;
  };

  /// What problems depend on.
  using ProblemKey =
      std::tuple<std::shared_ptr<const Segmentation>, std::shared_ptr<const ChartStats>,
                 std::shared_ptr<const GaussArea>, std::shared_ptr<const Atlas>, bool>;

  struct Waker;
  static ProblemKey problemKey(const Results& results);
  std::shared_ptr<const ProblemReport> problemReport(const Results& results);

  std::shared_ptr<Waker> waker_;
  WorkPlace place_;
  LazyValue<std::shared_ptr<const GaussArea>, SurfaceDerived> surface_;
  LazyValue<std::shared_ptr<const Mesh>, TriangleTree> trees_;
  LazyValue<ProblemKey, ProblemReport> problems_;
  LazyValue<HistogramKey, Histograms> histograms_;
  LazyValue<
      std::tuple<std::shared_ptr<const SurfaceDerived>, std::shared_ptr<const Segmentation>, Index>,
      OwnedPatch>
      patch_;
  LazyValue<std::shared_ptr<const SurfaceDerived>, Dots> dots_;
};

}  // namespace chartflood
