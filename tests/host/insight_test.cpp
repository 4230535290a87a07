// What stands behind plots and the Gauss sphere, against counts of its own: histograms, problems,
// normals of charts, figures as text.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <thread>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/actions/actions.h"
#include "app/host/insight/chart_csv.h"
#include "app/host/insight/histogram.h"
#include "app/host/insight/lazy_value.h"
#include "app/host/insight/problem_marks.h"
#include "app/host/insight/problems.h"
#include "app/host/insight/sphere_grid.h"
#include "app/host/insight/sphere_patch.h"
#include "app/host/insight/thickness.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/rng.h"
#include "core/gauss/spherical_polygon.h"
#include "core/model/build_mesh.h"
#include "core/param/border_overlaps.h"
#include "core/param/uv_overlaps.h"

namespace chartflood {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double kPi = std::numbers::pi;

/// In [0, 1).
double uniform(Rng& rng) { return rng.below(1u << 24) / static_cast<double>(1u << 24); }

ScalarRange rangeOf(double min, double max, ScalarScale scale) {
  ScalarRange range;
  range.min = min;
  range.max = max;
  range.scale = scale;
  return range;
}

TEST(Histogram, SharesSumToOneAndMatchACountByBorders) {
  Rng rng(7);
  std::vector<WeightedValue> values;
  for (int i = 0; i < 5000; ++i) values.push_back({0.2 + 9 * uniform(rng), uniform(rng)});
  for (const ScalarScale scale : {ScalarScale::Linear, ScalarScale::Root, ScalarScale::Log}) {
    const ScalarRange range = rangeOf(0.5, 8, scale);
    const Histogram h = binValues(values, range, 13);
    double sum = 0, total = 0;
    for (const double share : h.share) sum += share;
    for (const WeightedValue& v : values) total += v.weight;
    EXPECT_NEAR(sum, 1, 1e-12);
    for (std::size_t bin = 0; bin < 13; ++bin) {
      // The borders of the bin as values, then a plain count between them.
      const double low = bin == 0 ? -1e9 : valueAt(range, static_cast<double>(bin) / 13);
      const double high = bin == 12 ? 1e9 : valueAt(range, static_cast<double>(bin + 1) / 13);
      double weight = 0;
      for (const WeightedValue& v : values) {
        if (v.value >= low && v.value < high) weight += v.weight;
      }
      EXPECT_NEAR(h.share[bin], weight / total, 1e-9) << "bin " << bin;
    }
    EXPECT_GT(h.above, 0);
    EXPECT_GT(h.below, 0);
  }
}

TEST(Histogram, ValuesThatAreNoneAreSaidNotCounted) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Histogram h = binValues(std::vector<WeightedValue>{{1, 3}, {none, 1}, {2, 0}},
                                rangeOf(0, 2, ScalarScale::Linear), 4);
  EXPECT_DOUBLE_EQ(h.share[2], 1);
  EXPECT_DOUBLE_EQ(h.missing, 0.25);
  const Histogram empty = binValues({}, rangeOf(0, 2, ScalarScale::Linear), 4);
  EXPECT_DOUBLE_EQ(empty.share[0] + empty.share[1] + empty.share[2] + empty.share[3], 0);
}

TEST(Histogram, ValueAtIsTheInverseOfPlace) {
  for (const ScalarScale scale : {ScalarScale::Linear, ScalarScale::Root, ScalarScale::Log}) {
    const ScalarRange range = rangeOf(0.1, 30, scale);
    for (const double t : {0.0, 0.3, 0.8, 1.0})
      EXPECT_NEAR(range.place(valueAt(range, t)), t, 1e-12);
  }
}

/// A sample that was flooded once, worked out at once.
class Flooded {
 public:
  explicit Flooded(const char* sample, std::size_t triangles) : state(Session::Worker::Inline) {
    state.openSample(sample, triangles);
    state.playback.setSpeed(2 * Playback::kFastest);
    for (int i = 0; i < 8; ++i) state.update(0.1);
  }
  const Results& results() const { return state.results(); }
  /// Of the present moment, or after so many steps of the flood.
  std::shared_ptr<const std::vector<ModeHistogram>> histograms(const RenderSettings& settings,
                                                               std::size_t taken = ~0ull) {
    return state.insight().histograms(results(), {state.shownStats(), results().record, taken},
                                      settings);
  }

  AppState state;
  ActionRegistry actions = makeActionRegistry();
};

/// The right half holds the surface of the charts above the mean.
void expectBalance(const ModeHistogram& plot, const ChartStats& stats) {
  double above = 0, area = 0;
  for (const ChartFigures& chart : stats.charts) {
    area += chart.area;
    if (chart.gaussArea > stats.gaussMean) above += chart.area;
  }
  double right = 0;
  const auto& share = plot.histogram.share;
  for (std::size_t i = share.size() / 2; i < share.size(); ++i) right += share[i];
  EXPECT_NEAR(right, above / area, 1e-9);
}

TEST(ModeHistograms, OneForEachKindOfElementsAndEqualWeights) {
  Flooded cube("cube", 300);
  RenderSettings settings;
  settings.colorMode = ColorMode::Gauss;
  const auto all = cube.histograms(settings);
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), 3u);
  EXPECT_EQ((*all)[0].range.unit, "sr/d\u00B2");
  // Every corner of a cube has pi / 2.
  double corners = 0;
  const Histogram& h = (*all)[2].histogram;
  for (std::size_t i = 0; i < h.share.size(); ++i) {
    const double high = valueAt((*all)[2].range, static_cast<double>(i + 1) / 48);
    const double low = valueAt((*all)[2].range, static_cast<double>(i) / 48);
    if (low <= kPi / 2 + 1e-6 && high >= kPi / 2 - 1e-6) corners += h.share[i];
  }
  EXPECT_NEAR(corners, 1, 1e-12);
}

TEST(ModeHistograms, FloodOrderOfAFinishedFloodIsAsWideAsTheSurface) {
  Flooded sphere("sphere", 2000);
  RenderSettings settings;
  settings.colorMode = ColorMode::FloodOrder;
  const auto plots = sphere.histograms(settings);
  ASSERT_EQ(plots->size(), 1u);
  // Faces of an even sphere are alike: each bin holds about its part.
  for (const double share : (*plots)[0].histogram.share) EXPECT_NEAR(share, 1.0 / 48, 0.01);
  settings.colorMode = ColorMode::Charts;
  EXPECT_TRUE(sphere.histograms(settings)->empty());
}

TEST(ModeHistograms, AnEarlierMomentHasTheBarsOfWhatIsTaken) {
  Flooded sphere("sphere", 2000);
  RenderSettings settings;
  settings.colorMode = ColorMode::FloodOrder;
  const Histogram whole = (*sphere.histograms(settings))[0].histogram;
  const Histogram half = (*sphere.histograms(settings, 1000))[0].histogram;
  for (std::size_t bin = 0; bin < 48; ++bin) {
    EXPECT_NEAR(half.share[bin], bin < 24 ? whole.share[bin] : 0, 1e-12) << bin;
  }
  EXPECT_NEAR(half.missing, 0.5, 0.02);
  settings.colorMode = ColorMode::FloodTime;
  double sum = 0;
  for (const double share : (*sphere.histograms(settings, 1000))[0].histogram.share) sum += share;
  EXPECT_NEAR(sum, 1 - half.missing, 1e-12);
}

TEST(ModeHistograms, BalanceFollowsTheMoment) {
  Flooded torus("torus", 1500);
  RenderSettings settings;
  settings.colorMode = ColorMode::Balance;
  torus.state.playback.seek(700);
  torus.state.update(0);
  const ChartStats& stats = *torus.state.shownStats();
  expectBalance((*torus.histograms(settings))[0], stats);
  const Mesh& mesh = *torus.results().mesh;
  double area = 0;
  for (std::size_t i = 0; i < 700; ++i) {
    const Index face = (*torus.results().record)[i].face;
    for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
      area += mesh.triangleArea()[t];
    }
  }
  EXPECT_NEAR(stats.surfaceArea, area, 1e-9 * area);
}

TEST(ModeHistograms, BalanceMatchesTheChartsByArea) {
  Flooded torus("torus", 1500);
  RenderSettings settings;
  settings.colorMode = ColorMode::Balance;
  const auto plots = torus.histograms(settings);
  ASSERT_EQ(plots->size(), 1u);
  expectBalance((*plots)[0], *torus.results().chartStats);
}

TEST(Thickness, OfKnownOutlines) {
  using Points = std::vector<glm::dvec2>;
  const Points square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_NEAR(thickness(square, 100, 40), 10, 1e-12);
  const double c = std::cos(0.4), s = std::sin(0.4);
  Points strip;
  for (const glm::dvec2 p : {glm::dvec2{0, 0}, {100, 0}, {100, 3}, {0, 3}, {50, 3}}) {
    strip.push_back({c * p.x - s * p.y, s * p.x + c * p.y});
  }
  EXPECT_NEAR(thickness(strip, 300, 206), 3, 1e-9);
  // A thin ring that is open at one place: its hull is wide, yet it is thin.
  Points ring;
  for (int i = 0; i < 200; ++i) {
    const double t = 2 * kPi * i / 200;
    ring.push_back({20 * std::cos(t), 20 * std::sin(t)});
  }
  EXPECT_NEAR(thickness(ring, 2 * kPi * 20 * 2, 2 * 2 * kPi * 20), 4, 0.1);
  EXPECT_EQ(thickness({}, 0, 0), 0);
}

const Problem* find(const std::vector<Problem>& problems, ProblemKind kind) {
  for (const Problem& problem : problems) {
    if (problem.kind == kind) return &problem;
  }
  return nullptr;
}

TEST(Problems, SharpEdgesInsideChartsAreCountedByTheirLabels) {
  Flooded cube("cube", 300);
  // Charts from creases leave none.
  ASSERT_TRUE(cube.state.perform(cube.actions, "set start flood"));
  for (int i = 0; i < 8; ++i) cube.state.update(0.1);
  const Results& r = cube.results();
  std::size_t count = 0;
  for (const Index side : r.gaussArea->sharpEdges) {
    const auto label = [&](Index s) { return r.segmentation->label[r.mesh->faceOf(s / 3)]; };
    if (label(side) == label(r.mesh->opposite()[side])) ++count;
  }
  const std::vector<Problem> problems = findProblems(r);
  const Problem* open = find(problems, ProblemKind::OpenSharpEdges);
  ASSERT_NE(open, nullptr);
  EXPECT_EQ(open->count, count);
  // All edges of the sample's grid are equally long.
  const auto all = static_cast<double>(r.gaussArea->sharpEdges.size());
  EXPECT_NEAR(open->share, static_cast<double>(count) / all, 1e-6);
  EXPECT_THAT(problemText(*open), HasSubstr(std::to_string(count) + " sharp edge"));
}

/// A square of two triangles as one chart with the given corners in the texture.
Results flatSquare(std::vector<glm::dvec2> uv) {
  Flooded plane("cube", 12);
  Results r = plane.results();
  auto labels = std::make_shared<Segmentation>(*r.segmentation);
  auto stats = std::make_shared<ChartStats>(*r.chartStats);
  stats->charts.assign(1, ChartFigures{});
  stats->charts[0].disk = false;
  labels->chartCount = 1;
  std::fill(labels->label.begin(), labels->label.end(), 0);
  auto charts = std::make_shared<ChartSet>();
  CutChart chart;
  ChartSurface& surface = chart.surface;
  surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  surface.opposite = {kNone, kNone, 3, 2, kNone, kNone};
  surface.positions.assign(4, glm::dvec3(0));
  surface.meshTriangle = {0, 1};
  chart.topology = {1, 1, 1};
  charts->charts.push_back(std::move(chart));
  auto unwrap = std::make_shared<Unwrap>();
  unwrap->charts.resize(1);
  unwrap->charts[0].uv = uv;
  auto atlas = std::make_shared<Atlas>();
  atlas->uv = {uv};
  atlas->textureSize = 1000;
  r.segmentation = labels;
  r.chartStats = stats;
  r.charts = charts;
  r.unwrap = unwrap;
  r.atlas = atlas;
  r.flat = true;
  return r;
}

TEST(Problems, ThinChartsByThePixelsOfTheTexture) {
  const auto square = [](double height) {
    return std::vector<glm::dvec2>{{0, 0}, {0.5, 0}, {0.5, height}, {0, height}};
  };
  EXPECT_EQ(find(findProblems(flatSquare(square(0.02))), ProblemKind::ThinCharts), nullptr);
  const std::vector<Problem> thin = findProblems(flatSquare(square(0.007)));
  ASSERT_NE(find(thin, ProblemKind::ThinCharts), nullptr);
  EXPECT_EQ(find(thin, ProblemKind::ThinCharts)->places[0].chart, 0u);
}

TEST(Problems, CutChartsAreDisks) {
  Results r = flatSquare({{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}});
  EXPECT_EQ(find(findProblems(r), ProblemKind::NotDisks), nullptr);
  EXPECT_EQ(find(findProblems(r), ProblemKind::Flipped), nullptr);
  EXPECT_EQ(find(findProblems(r), ProblemKind::Overlapping), nullptr);
  // Without an unwrap of its own the chart counts as segmented.
  r.flat = false;
  ASSERT_NE(find(findProblems(r), ProblemKind::NotDisks), nullptr);
}

TEST(Problems, ATriangleThatIsTurnedOverIsNamedAndLiesOverItsNeighbour) {
  // The last corner is pulled across the diagonal.
  Results r = flatSquare({{0, 0}, {0.5, 0}, {0.5, 0.5}, {0.4, 0.1}});
  auto unwrap = std::make_shared<Unwrap>(*r.unwrap);
  unwrap->charts[0].distortion.flipped = 1;
  r.unwrap = unwrap;
  const std::vector<Problem> problems = findProblems(r);
  const Problem* flipped = find(problems, ProblemKind::Flipped);
  ASSERT_NE(flipped, nullptr);
  EXPECT_EQ(problemText(*flipped), "1 flipped triangle");
  EXPECT_EQ(flipped->triangles, std::vector<Index>{1});
  const Problem* overlapping = find(problems, ProblemKind::Overlapping);
  ASSERT_NE(overlapping, nullptr);
  EXPECT_EQ(overlapping->triangles, (std::vector<Index>{0, 1}));
  // The worse one is seen.
  const SurfaceMarks marks = problemMarks(*r.mesh, *r.segmentation, problems);
  EXPECT_EQ(marks.triangles[0], TriangleMark::Lattice);
  EXPECT_EQ(marks.triangles[1], TriangleMark::Stripes);
}

TEST(Problems, EdgesOfThreeFacesAreFoundWhereTheMeshWasSplit) {
  // Three squares of two triangles around one edge, 0 to 1.
  InputMesh input;
  input.positions = {{0, 0, 0},  {0, 0, 1},  {1, 0, 0},   {1, 0, 1},
                     {-1, 1, 0}, {-1, 1, 1}, {-1, -1, 0}, {-1, -1, 1}};
  for (const Index far : {2u, 4u, 6u}) {
    input.corners.insert(input.corners.end(), {0, far, far + 1, 0, far + 1, 1});
  }
  Results r;
  r.mesh = buildMesh(std::make_shared<const InputMesh>(std::move(input)));
  auto labels = std::make_shared<Segmentation>();
  labels->chartCount = 1;
  labels->label.assign(r.mesh->faceCount(), 0);
  r.segmentation = labels;
  auto stats = std::make_shared<ChartStats>();
  stats->charts.resize(1);
  stats->charts[0].disk = true;
  r.chartStats = stats;
  const std::vector<Problem> problems = findProblems(r);
  const Problem* found = find(problems, ProblemKind::NonManifoldEdges);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(problemText(*found), "1 edge of more than two faces");
  const SurfaceMarks marks = problemMarks(*r.mesh, *r.segmentation, problems);
  ASSERT_EQ(marks.lines.size(), 1u);
  ASSERT_EQ(marks.lines[0].sides.size(), 1u);
  const Index side = marks.lines[0].sides[0];
  EXPECT_EQ(r.mesh->inputVertex(r.mesh->sideStart(side)) +
                r.mesh->inputVertex(r.mesh->sideEnd(side)),
            1u);
}

TEST(UvOverlaps, AgreeWithACountOfPointsInTriangles) {
  Rng rng(11);
  std::vector<PlaneTriangle> triangles;
  const auto point = [&] { return glm::dvec2(uniform(rng), uniform(rng)); };
  for (int i = 0; i < 60; ++i) {
    const glm::dvec2 at = point();
    triangles.push_back({at, at + 0.1 * point(), at + 0.1 * point()});
  }
  const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  const auto inside = [&](const PlaneTriangle& t, const glm::dvec2& p) {
    int left = 0;
    for (std::size_t i = 0; i < 3; ++i) left += cross(t[(i + 1) % 3] - t[i], p - t[i]) > 0 ? 1 : 0;
    return left == 0 || left == 3;
  };
  std::vector<int> shared(triangles.size(), 0);
  for (int x = 0; x < 900; ++x) {
    for (int y = 0; y < 900; ++y) {
      std::vector<std::size_t> over;
      for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (inside(triangles[t], glm::dvec2(x, y) * (1.1 / 900))) over.push_back(t);
      }
      if (over.size() < 2) continue;
      for (const std::size_t t : over) ++shared[t];
    }
  }
  const std::vector<bool> found = findOverlaps(triangles, 1e-9);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (shared[t] > 0) {
      EXPECT_TRUE(found[t]) << t;
    }
    // What no point has found is at most a sliver.
    if (shared[t] == 0 && found[t]) {
      EXPECT_FALSE(findOverlaps(triangles, 4e-3)[t]) << t;
    }
  }
}

TEST(UvOverlaps, LongThinTrianglesAreHeldByTheCellsThatTheyReach) {
  // Slivers across the whole square, side by side, and one that crosses them all.
  std::vector<PlaneTriangle> triangles;
  constexpr int kSlivers = 300;
  for (int i = 0; i < kSlivers; ++i) {
    const double x = i / double{kSlivers};
    triangles.push_back({glm::dvec2(x, 0), {x + 0.9 / kSlivers, 0}, {x + 0.4, 1}});
  }
  std::vector<bool> found = findOverlaps(triangles, 1e-9);
  EXPECT_EQ(std::count(found.begin(), found.end(), true), 0);
  triangles.push_back({glm::dvec2(-0.1, 0.5), {1.5, 0.5}, {1.5, 0.501}});
  found = findOverlaps(triangles, 1e-9);
  EXPECT_EQ(std::count(found.begin(), found.end(), true), kSlivers + 1);
}

/// A regular polygon about `center`.
FlatBorder ring(const glm::dvec2& center, double radius, int corners) {
  FlatBorder border;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * glm::pi<double>() * i / corners;
    border.push_back(center + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return border;
}

TEST(BorderOverlaps, ChartsMeetByCrossingOrHolding) {
  const std::vector<FlatBorder> borders = {
      ring({0, 0}, 1, 50),                   // crossed by the next
      ring({1.5, 0}, 1, 60),                 //
      ring({10, 0}, 1, 40),                  // holds the next
      ring({10.2, 0.1}, 0.1, 7),             //
      ring({20, 0}, 1, 30),                  // alone
      {},                                    // nothing
      {{30, 0}, {31, 0}, {30, 1}, {31, 1}},  // crosses itself
      {{40, 0}, {41, 0}, {41, 1}, {40, 1}},  // touches the next along a side
      {{41, 0}, {42, 0}, {42, 1}, {41, 1}},  //
  };
  EXPECT_EQ(findMeetingCharts(borders),
            (std::vector<bool>{true, true, true, true, false, false, true, false, false}));
}

TEST(UvOverlaps, NeighboursOnlyTouch) {
  std::vector<PlaneTriangle> triangles;
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < 12; ++y) {
      const auto at = [&](int dx, int dy) {
        return glm::dvec2(x + dx, y + dy) * 0.1 + 0.03 * glm::dvec2(std::sin(x + dx), (y + dy) % 3);
      };
      triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
      triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  }
  const auto count = [&] {
    const std::vector<bool> found = findOverlaps(triangles, 1e-9);
    return std::count(found.begin(), found.end(), true);
  };
  EXPECT_EQ(count(), 0);
  triangles.push_back({glm::dvec2(0.41, 0.41), {0.42, 0.41}, {0.41, 0.42}});
  EXPECT_GE(count(), 2);
  triangles.back()[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(count(), 0);
}

TEST(Problems, NothingWithoutResults) { EXPECT_TRUE(findProblems(Results{}).empty()); }

TEST(SpherePatch, AreaIsTheChartsGaussArea) {
  for (const char* sample : {"sphere", "cube", "torus", "bumps"}) {
    Flooded model(sample, 1200);
    const ChartStats& stats = *model.results().chartStats;
    for (Index c = 0; c < stats.charts.size(); ++c) {
      const auto patch = model.state.insight().patch(model.results(), c);
      ASSERT_TRUE(patch);
      EXPECT_NEAR(patch->area(), stats.charts[c].gaussArea, 1e-6) << sample << " chart " << c;
    }
  }
}

TEST(SpherePatch, FacetsCoverTheFacesOfASphere) {
  Flooded sphere("sphere", 1200);
  double sum = 0, whole = 0;
  for (Index c = 0; c < sphere.results().chartStats->charts.size(); ++c) {
    const auto patch = sphere.state.insight().patch(sphere.results(), c);
    EXPECT_FALSE(patch->sampled);
    whole += patch->faceArea;
    for (const SphereFacet& f : patch->facets) {
      sum += std::abs(signedTriangleArea(f.corner[0], f.corner[1], f.corner[2]));
    }
  }
  EXPECT_NEAR(sum, whole, 1e-4);
  EXPECT_NEAR(whole, 4 * kPi, 0.05);
}

TEST(SpherePatch, ManyTrianglesAreSampledWithTheSameArea) {
  Flooded sphere("sphere", 20000);
  auto labels = std::make_shared<Segmentation>(*sphere.results().segmentation);
  std::fill(labels->label.begin(), labels->label.end(), 0);
  const auto surface = sphere.state.insight().surface(sphere.results());
  const SpherePatch patch = spherePatch(*surface, *labels, 0);
  EXPECT_TRUE(patch.sampled);
  double layers = 0;
  for (const SphereFacet& f : patch.facets) layers += static_cast<double>(f.layers);
  // The whole sphere once.
  EXPECT_NEAR(layers / static_cast<double>(patch.facets.size()), 1, 0.05);
  EXPECT_EQ(patch.facets.size(), std::size_t{6 * SphereGrid::kCells * SphereGrid::kCells});
}

TEST(SphereGrid, CellsAreAlikeAndFillTheSphere) {
  SphereGrid grid;
  Rng rng(3);
  for (int i = 0; i < 400'000; ++i) {
    const glm::vec3 d(uniform(rng) - 0.5, uniform(rng) - 0.5, uniform(rng) - 0.5);
    grid.add(d, 1e-5f);
  }
  EXPECT_NEAR(grid.reached(), 4 * kPi, 0.01);
}

TEST(ChartCsv, HasAHeadingAndALineAChartThatReadBack) {
  Flooded torus("torus", 1000);
  std::istringstream lines(chartsCsv(torus.results()));
  std::string line;
  std::getline(lines, line);
  EXPECT_THAT(line, StartsWith("chart,faces,area,gauss_area_sr,"));
  const auto columns = std::count(line.begin(), line.end(), ',');
  const ChartStats& stats = *torus.results().chartStats;
  for (std::size_t c = 0; c < stats.charts.size(); ++c) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
    std::istringstream cells(line);
    std::string chart, faces, area, gauss;
    std::getline(cells, chart, ',');
    std::getline(cells, faces, ',');
    std::getline(cells, area, ',');
    std::getline(cells, gauss, ',');
    EXPECT_EQ(chart, std::to_string(c));
    EXPECT_EQ(faces, std::to_string(stats.charts[c].faces));
    EXPECT_DOUBLE_EQ(std::stod(gauss), stats.charts[c].gaussArea);
  }
  EXPECT_FALSE(std::getline(lines, line));
  EXPECT_EQ(chartsCsv(Results{}), "");
}

TEST(ChartCsv, CopiedByActions) {
  Flooded sphere("sphere", 500);
  EXPECT_TRUE(sphere.state.perform(sphere.actions, "copy-charts"));
  EXPECT_EQ(sphere.state.requests.clipboard, chartsCsv(sphere.results()));
  EXPECT_TRUE(sphere.state.perform(sphere.actions, "copy-figures 2"));
  EXPECT_THAT(*sphere.state.requests.clipboard, StartsWith("chart: 2\n"));
  EXPECT_FALSE(sphere.state.perform(sphere.actions, "copy-figures 999"));
  EXPECT_FALSE(sphere.state.perform(sphere.actions, "copy-figures"));  // none is selected
}

TEST(LazyValue, IsMadeOnceAKeyAndKeepsTheOldOneMeanwhile) {
  LazyValue<int, int> value;
  std::atomic<int> made = 0, woken = 0;
  const WorkPlace place{false, [&] { ++woken; }};
  const auto get = [&](int key) {
    return value.get(key, place, [&made, key] {
      ++made;
      return 10 * key;
    });
  };
  const auto await = [&](int key) {
    for (int i = 0; i < 2000; ++i) {
      const auto now = get(key);
      if (now && *now == 10 * key) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  };
  ASSERT_TRUE(await(1));
  ASSERT_TRUE(get(2));  // the old one or the new
  ASSERT_TRUE(await(2));
  ASSERT_TRUE(await(2));
  EXPECT_EQ(made, 2);
  EXPECT_GE(woken, 1);
}

}  // namespace
}  // namespace chartflood
