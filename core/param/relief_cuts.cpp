#include "core/param/relief_cuts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/charts/boundary_cut.h"
#include "core/charts/chart_surface.h"
#include "core/param/circle_map.h"
#include "core/param/coarse_chart.h"
#include "core/param/free_map.h"

namespace chartflood {

namespace {

using Boundary = UnwrapOptions::Boundary;

constexpr std::size_t kMostReliefCuts = 40;  // that stay
constexpr std::size_t kMostTightCuts = 8;   // of maps that cannot be tried loosely: each takes long
constexpr std::size_t kReliefPatience = 6;  // cuts in a row that may fail to help
constexpr std::size_t kMostEarnest = 4;     // maps in earnest of one chart
constexpr double kWorthwhile = 0.05;        // share of what it stretches that a cut has to save
constexpr double kDeepEnough = 0.1;         // of the greatest distance from the boundary
constexpr double kOtherPlace = 0.5;         // of a cut's length: places nearer to it are the same
/// Triangles from which on cuts are looked for on a coarse chart, and triangles of that.
constexpr std::size_t kLargeChart = 9000, kCoarseTriangles = 4000;

/// A chart with the cuts made so far, and how it lies: the map may cover itself.
struct ReliefTrial {
  CutChart chart;
  FlatAttempt flat;
};

/// What a chart stretches beyond none; endless with bad triangles.
double excessStretch(const FlatAttempt& attempt) {
  if (!attempt.flat() || attempt.bad > 0) return std::numeric_limits<double>::infinity();
  return attempt.stretch() - 1;
}

/// Whether a cut is worth its length.
bool clearlyBetter(const FlatAttempt& a, const FlatAttempt& b) {
  if (a.bad != b.bad || a.flat() != b.flat()) return better(a, b);
  return a.bad > 0 ? a.stretch() < (1 - kWorthwhile) * b.stretch()
                   : excessStretch(a) < (1 - kWorthwhile) * excessStretch(b);
}

/// The places of a surface's vertices after a cut gave some of them copies.
std::vector<glm::dvec2> carriedOver(const ChartSurface& before, std::span<const glm::dvec2> uv,
                                    const ChartSurface& cut) {
  std::vector<glm::dvec2> places(cut.vertexCount());
  for (std::size_t t = 0; t < before.triangleCount(); ++t) {
    for (int i = 0; i < 3; ++i) places[cut.triangles[t][i]] = uv[before.triangles[t][i]];
  }
  return places;
}

/// Surroundings from which a cut did not help.
struct RefusedPlace {
  glm::dvec3 center;
  double radius;
};

/// Which inner vertex to slit from next.
class ReliefPlace {
 public:
  ReliefPlace(const ReliefTrial& trial, const std::vector<RefusedPlace>& refused)
      : surface_(trial.chart.surface), flat_(trial.flat), refused_(refused),
        depth_(distanceToBoundary(surface_)) {}

  /// Of the triangle that shrank most, and not near the boundary. Where triangles vanished it is
  /// one of theirs wherever it lies, rather one with no others: two edges between the same two
  /// vertices leave no room for what is between them, until it is slit. kNone: there is none.
  Index find() const {
    double deepest = 0;
    for (const double d : depth_) {
      if (std::isfinite(d)) deepest = std::max(deepest, d);
    }
    const double least = flat_.bad > 0 ? 0 : kDeepEnough * deepest;
    const std::vector<bool> sound = flat_.bad > 0 ? soundVertices() : std::vector<bool>();
    Index best = kNone;
    double bestRatio = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < surface_.triangleCount(); ++i) {
      if (flat_.bad > 0 && !isBad(i)) continue;
      for (const Index v : surface_.triangles[i]) {
        if (!std::isfinite(depth_[v]) || !(depth_[v] > least)) continue;
        const double ratio = flat_.bad > 0 ? (sound[v] ? 1 : 0) : flat_.triangles[i].areaRatio;
        const bool first = ratio < bestRatio || (ratio == bestRatio && depth_[v] > depth_[best]);
        if (!first || isRefused(v)) continue;
        best = v;
        bestRatio = ratio;
      }
    }
    return best;
  }
  double depth(Index vertex) const { return depth_[vertex]; }

 private:
  bool isBad(std::size_t triangle) const {
    const auto& t = surface_.triangles[triangle];
    const auto& uv = flat_.chart.uv;
    return !(signedArea(uv[t[0]], uv[t[1]], uv[t[2]]) > 0);
  }
  /// Those with a counter-clockwise triangle.
  std::vector<bool> soundVertices() const {
    std::vector<bool> sound(surface_.vertexCount(), false);
    for (std::size_t i = 0; i < surface_.triangleCount(); ++i) {
      if (isBad(i)) continue;
      for (const Index v : surface_.triangles[i]) sound[v] = true;
    }
    return sound;
  }
  bool isRefused(Index vertex) const {
    return std::any_of(refused_.begin(), refused_.end(), [&](const RefusedPlace& place) {
      return glm::distance(surface_.positions[vertex], place.center) < place.radius;
    });
  }

  const ChartSurface& surface_;
  const FlatAttempt& flat_;
  const std::vector<RefusedPlace>& refused_;
  std::vector<double> depth_;
};

class Relief {
 public:
  Relief(double limit, const CutChart& chart, Boundary boundary, const Progress& progress)
      : limit_(limit), boundary_(boundary), progress_(progress) {
    now_.chart = chart;
  }

  RelievedChart run() {
    RelievedChart best;
    if (begin()) best = {now_.flat, now_.chart};
    while (!best.flat.keeps(limit_) && now_.flat.flat() && earnest_ < kMostEarnest) {
      if (!cutUntilWithin() && !changed_) break;
      if (progress_.cancelled()) return best;
      FlatAttempt flat = now_.flat;
      if (loose_) flat = inEarnest();
      if (!best.flat.flat() || better(flat, best.flat)) best = {flat, now_.chart};
      // What holds the chart back where it would cover itself is to be seen in this map only.
      if (loose_ && flat.flat()) now_.flat = std::move(flat);
      loose_ = loose_ && now_.flat.bad == 0;
      changed_ = false;
    }
    return best;
  }

  /// Cuts that keep the limit as far as loose maps tell, by the vertices they begin at, as
  /// `meshVertex` names them; none where the chart keeps it without.
  std::vector<Index> looseCuts() {
    if (beginLoosely() && !now_.flat.keeps(limit_)) cutUntilWithin();
    return from_;
  }

 private:
  /// Lays the chart flat as it is. False where that is not in earnest, because even a loose map is
  /// beyond the limit.
  bool begin() {
    if (boundary_ == Boundary::Circle) {
      now_.flat = layFlat(ChartShape(now_.chart.surface), boundary_, progress_);
      return true;
    }
    {
      const ChartShape shape(now_.chart.surface);
      std::vector<glm::dvec2> direct = directMap(shape, progress_);
      if (!direct.empty()) return settle(flatOrCircle(shape, std::move(direct)));
    }
    if (progress_.cancelled()) return true;
    if (now_.chart.surface.triangleCount() >= kLargeChart && cutAsCoarse()) {
      return settle(layFlat(ChartShape(now_.chart.surface), boundary_, progress_));
    }
    if (beginLoosely() && now_.flat.stretch() > limit_) {
      changed_ = true;
      return false;
    }
    const ChartShape shape(now_.chart.surface);
    return settle(flatOrCircle(shape, guardedMap(shape, progress_)));
  }

  bool settle(FlatAttempt flat) {
    now_.flat = std::move(flat);
    loose_ = now_.flat.flat() && now_.flat.bad == 0;
    return true;
  }

  /// False when the chart has no map without flips.
  bool beginLoosely() {
    const ChartShape shape(now_.chart.surface);
    std::vector<glm::dvec2> circle = bestCircleMap(shape);
    if (circle.empty()) return false;
    settle(measuredMap(shape, looseMap(shape, std::move(circle), progress_)));
    return loose_;
  }

  /// Makes the cuts that a coarse chart of the same shape needs. False when it needs none.
  bool cutAsCoarse() {
    CutChart coarse;
    coarse.surface = coarseChart(now_.chart.surface, kCoarseTriangles);
    coarse.topology = topologyOf(coarse.surface);
    if (!coarse.disk()) return false;  // two edges between the same two vertices
    const std::vector<Index> from = Relief(limit_, coarse, boundary_, progress_).looseCuts();
    for (const Index vertex : from) {
      if (isOnBoundary(now_.chart.surface, vertex)) continue;
      if (cutToBoundary(now_.chart, vertex, CutReason::Relief)) ++cuts_;
    }
    return !from.empty();
  }

  /// Cuts until the chart, perhaps covering itself, is within the limit. False when it is not.
  bool cutUntilWithin() {
    while (!progress_.cancelled() && cuts_ < (loose_ ? kMostReliefCuts : kMostTightCuts) &&
           refusals_ < kReliefPatience) {
      if (cutOnce() && now_.flat.keeps(limit_)) return true;
    }
    return false;
  }

  /// Tries one cut. False when there is no place for one, or when it did not help.
  bool cutOnce() {
    const ReliefPlace place(now_, refused_);
    const Index vertex = place.find();
    ReliefTrial next{now_.chart, {}};
    if (vertex == kNone || !cutToBoundary(next.chart, vertex, CutReason::Relief)) {
      refusals_ = kReliefPatience;
      return false;
    }
    const ChartShape shape(next.chart.surface);
    if (loose_) {
      std::vector<glm::dvec2> places =
          carriedOver(now_.chart.surface, now_.flat.chart.uv, next.chart.surface);
      scaleToUnitArea(shape.rest, places);
      next.flat = measuredMap(shape, looseMap(shape, std::move(places), progress_));
    } else {
      next.flat = layFlat(shape, boundary_, progress_);
    }
    if (!clearlyBetter(next.flat, now_.flat)) {
      refused_.push_back({now_.chart.surface.positions[vertex], kOtherPlace * place.depth(vertex)});
      ++refusals_;
      return false;
    }
    from_.push_back(now_.chart.surface.meshVertex[vertex]);
    now_ = std::move(next);
    loose_ = loose_ || (boundary_ == Boundary::Free && now_.flat.bad == 0);
    changed_ = true;
    refused_.clear();
    refusals_ = 0;
    ++cuts_;
    return true;
  }

  /// The chart as it is cut now, not covering itself.
  FlatAttempt inEarnest() {
    ++earnest_;
    const ChartShape shape(now_.chart.surface);
    std::vector<glm::dvec2> places = now_.flat.chart.uv;
    scaleToUnitArea(shape.rest, places);
    places = settledMap(shape, std::move(places), progress_);
    if (places.empty() && !progress_.cancelled()) places = guardedMap(shape, progress_);
    return flatOrCircle(shape, std::move(places));
  }

  double limit_;
  Boundary boundary_;
  const Progress& progress_;
  ReliefTrial now_;
  bool loose_ = false;    ///< now_ has a map without flips to go on from
  bool changed_ = false;  ///< since the last map in earnest
  std::vector<RefusedPlace> refused_;
  std::vector<Index> from_;  ///< where the cuts that stay begin
  std::size_t cuts_ = 0, refusals_ = 0, earnest_ = 0;
};

}  // namespace

RelievedChart layFlatWithin(double limit, const CutChart& chart, Boundary boundary,
                            const Progress& progress) {
  RelievedChart done = Relief(limit, chart, boundary, progress).run();
  if (done.chart && done.chart->cuts.size() == chart.cuts.size()) done.chart.reset();
  return done;
}

}  // namespace chartflood
