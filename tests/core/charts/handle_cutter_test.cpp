// The HandleCutter: shortest loops against a search over all of them, and the wavefront's record.

#include "core/charts/handle_cutter.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "core/charts/handle_playback.h"
#include "tests/core/charts/cut_support.h"

namespace chartflood {
namespace {

using test::oneChart;

ChartSurface surfaceOf(const Mesh& mesh) {
  return extractCharts(mesh, oneChart(mesh).label, 1).front();
}

bool parts(const ChartSurface& surface, const std::vector<Index>& sides) {
  ChartSurface opened = surface;
  openAlong(opened, sides);
  return topologyOf(opened).pieces > 1;
}

/// The shortest simple closed walk that does not part a closed surface, by trying all of them.
class AllLoops {
 public:
  explicit AllLoops(const ChartSurface& surface) : surface_(surface) {}
  double shortest() {
    for (Index v = 0; v < surface_.vertexCount(); ++v) {
      base_ = v;
      used_.assign(surface_.vertexCount(), false);
      extend(v, 0);
    }
    return best_;
  }

 private:
  void extend(Index vertex, double length) {
    used_[vertex] = true;
    for (Index side = 0; side < surface_.opposite.size(); ++side) {
      if (surface_.sideStart(side) != vertex || surface_.isDiagonal(side)) continue;
      const Index end = surface_.sideEnd(side);
      const double way = length + sideLength(surface_, side);
      if (end < base_ || !(way < best_)) continue;
      sides_.push_back(side);
      if (end == base_ && sides_.size() > 2 && !parts(surface_, sides_)) best_ = way;
      if (!used_[end]) extend(end, way);
      sides_.pop_back();
    }
    used_[vertex] = false;
  }

  const ChartSurface& surface_;
  Index base_ = 0;
  std::vector<bool> used_;
  std::vector<Index> sides_;
  double best_ = 1e300;
};

TEST(HandleCutter, TheShortestLoopIsTheShortestOfAll) {
  for (const bool triangles : {false, true}) {
    for (const auto& [n, m] : {std::pair<Index, Index>{5, 4}, {4, 5}, {6, 3}}) {
      auto input = test::copyInput(*test::torusGrid(n, m, triangles));
      // Uneven, so that one loop is shorter than its neighbours.
      for (std::size_t i = 0; i < input.positions.size(); ++i) {
        const double shift = 0.15 * static_cast<double>(i * 7 % 5);
        input.positions[i] += glm::dvec3(shift, 0.1 * static_cast<double>(i * 3 % 4), shift / 2);
      }
      const auto mesh = test::rebuild(std::move(input));
      ChartSurface surface = surfaceOf(*mesh);
      const double expected = AllLoops(surface).shortest();
      const Progress progress;
      const auto cuts = cutHandles(surface, HandleSearch::Shortest, 1, progress);
      ASSERT_EQ(cuts.size(), 1u);
      EXPECT_NEAR(cuts[0].length, expected, 1e-12);
    }
  }
}

TEST(HandleCutter, ATubeIsCutAroundNotAlong) {
  // The tube of the torus is shorter on the inside of the ring than on the outside: every loop
  // around it has the same length, while the shortest one along it is the inner circle.
  const auto mesh = test::torusGrid(30, 10, false);
  ChartSurface surface = surfaceOf(*mesh);
  const Progress progress;
  const auto cuts = cutHandles(surface, HandleSearch::Shortest, 1, progress);
  ASSERT_EQ(cuts.size(), 1u);
  const double around = 10 * 2 * std::sin(std::numbers::pi / 10);
  const double along = 30 * 2 * std::sin(std::numbers::pi / 30);
  EXPECT_NEAR(cuts[0].length * mesh->scale(), std::min(around, along), 1e-9);
}

TEST(HandleCutter, BothWaysGiveTheSameForTheSameSeed) {
  const auto mesh = test::sampleMesh("double-torus", 2000);
  const Progress progress;
  for (const HandleSearch search : {HandleSearch::Shortest, HandleSearch::Wavefront}) {
    ChartSurface a = surfaceOf(*mesh), b = a;
    const auto first = cutHandles(a, search, 7, progress);
    const auto second = cutHandles(b, search, 7, progress);
    EXPECT_EQ(a.triangles, b.triangles);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].sides, second[i].sides);
  }
}

TEST(HandleCutter, ACancelledSearchStops) {
  const auto mesh = test::torusGrid(12, 6, true);
  ChartSurface surface = surfaceOf(*mesh);
  Progress progress;
  progress.cancel();
  EXPECT_TRUE(cutHandles(surface, HandleSearch::Shortest, 1, progress).empty());
  EXPECT_TRUE(cutHandles(surface, HandleSearch::Wavefront, 1, progress).empty());
  EXPECT_EQ(recordHandleCutter(surface, 1, progress).steps(), 0u);
}

// --- The record ---

std::vector<std::shared_ptr<const Mesh>> recordedMeshes() {
  return {test::torusGrid(12, 6, true),
          test::torusGrid(12, 6, false),
          test::torusGrid(12, 6, false, {0, 2, 4, 21, 23, 25}),
          test::sampleMesh("double-torus", 2000),
          test::sampleMesh("sphere", 300),
          test::tubeGrid(8, 5)};
}

/// What the fronts must be together: sides of taken triangles towards free ones, and sides of free
/// triangles on borders that a taken triangle touches.
std::set<Index> borderOfTaken(const ChartSurface& surface, const std::set<Index>& taken) {
  const auto isTaken = [&](Index side) { return taken.count(surface.meshTriangle[side / 3]) != 0; };
  std::set<Index> sides;
  for (Index side = 0; side < surface.opposite.size(); ++side) {
    const Index other = surface.opposite[side];
    if (other != kNone && isTaken(side) && !isTaken(other)) sides.insert(surface.meshSide(side));
  }
  for (const auto& loop : boundaryLoops(surface)) {
    if (std::none_of(loop.begin(), loop.end(), isTaken)) continue;
    for (const Index side : loop) {
      if (!isTaken(side)) sides.insert(surface.meshSide(side));
    }
  }
  return sides;
}

TEST(HandleRecord, FrontsAreTheBoundaryOfWhatIsTakenAtEveryStep) {
  for (const auto& mesh : recordedMeshes()) {
    const ChartSurface surface = surfaceOf(*mesh);
    const Progress progress;
    const HandleRecord record = recordHandleCutter(surface, 3, progress);
    ASSERT_EQ(record.triangles.size(), surface.triangleCount());
    ASSERT_EQ(record.steps(), mesh->faceCount());
    HandlePlayback playback(surface, record);
    const std::size_t stride = record.steps() / 150 + 1;
    for (std::size_t n = 1; n <= record.steps(); n += stride) {
      playback.seek(n);
      const std::set<Index> taken(playback.taken().begin(), playback.taken().end());
      EXPECT_EQ(taken.size(), record.stepEnd[n - 1]);
      std::set<Index> sides;
      for (const FrontPicture& front : playback.fronts()) {
        double length = 0;
        for (const Index side : front.sides) {
          EXPECT_TRUE(sides.insert(side).second) << "a side on two fronts";
          if (taken.count(side / 3) == 0) continue;
          length += glm::length(mesh->positions()[mesh->sideEnd(side)] -
                                mesh->positions()[mesh->sideStart(side)]);
        }
        EXPECT_NEAR(front.length, length, 1e-9);
        EXPECT_LE(front.keptLength, front.length);
      }
      ASSERT_EQ(sides, borderOfTaken(surface, taken)) << "step " << n;
    }
    playback.seek(record.steps());
    EXPECT_TRUE(playback.fronts().empty()) << "the whole chart is taken";
  }
}

TEST(HandleRecord, FrontsMeetOncePerHandleAndTheCutsAreRememberedLoops) {
  for (const auto& mesh : recordedMeshes()) {
    const ChartSurface surface = surfaceOf(*mesh);
    const long genus = topologyOf(surface).genus();
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
      const Progress progress;
      const HandleRecord record = recordHandleCutter(surface, seed, progress);
      HandlePlayback playback(surface, record);
      long touches = 0;
      for (const HandleEvent& event : record.events) {
        if (event.kind == HandleEventKind::Touch) ++touches;
        if (event.kind != HandleEventKind::Cut) continue;
        playback.seek(event.step);
        std::set<Index> kept;
        for (const FrontPicture& front : playback.fronts()) {
          if (front.number != event.fronts[0]) continue;
          for (const Index side : front.kept) kept.insert(mesh->edgeOfSide(side));
        }
        for (Index c = event.firstCut; c < event.endCut; ++c) {
          for (const Index side : record.cuts[c].sides) {
            EXPECT_EQ(kept.count(mesh->edgeOfSide(side)), 1u) << "not on the remembered loop";
          }
        }
        playback.seek(event.step + 1);
        EXPECT_EQ(playback.cuts().size(), event.endCut);
      }
      EXPECT_EQ(touches, genus);
    }
  }
}

TEST(HandleRecord, PlayingItRebuildsTheSameCuts) {
  for (const auto& mesh : recordedMeshes()) {
    const ChartSurface surface = surfaceOf(*mesh);
    const Progress progress;
    const HandleRecord record = recordHandleCutter(surface, 5, progress);
    ChartSurface opened = surface;
    const auto cuts = cutHandles(opened, HandleSearch::Wavefront, 5, progress);
    HandlePlayback playback(surface, record);
    playback.seek(record.steps());
    ASSERT_EQ(playback.cuts().size(), cuts.size());
    ChartSurface replayed = surface;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      EXPECT_EQ(playback.cuts()[i].sides, cuts[i].sides);
      EXPECT_EQ(playback.cuts()[i].reason, cuts[i].reason);
      // One chart that is the whole mesh has the mesh's numbers.
      openAlong(replayed, playback.cuts()[i].sides);
    }
    EXPECT_EQ(replayed.opposite, opened.opposite);
    EXPECT_EQ(topologyOf(replayed).genus(), 0);
  }
}

TEST(HandleRecord, SeekingBackShowsTheSameAsPlayingOn) {
  const auto mesh = test::sampleMesh("double-torus", 2000);
  const ChartSurface surface = surfaceOf(*mesh);
  const Progress progress;
  const HandleRecord record = recordHandleCutter(surface, 1, progress);
  HandlePlayback back(surface, record);
  back.seek(record.steps());
  for (const std::size_t n : {record.steps() / 2, record.steps() / 5, std::size_t{0}}) {
    back.seek(n);
    HandlePlayback there(surface, record);
    there.seek(n);
    const auto a = there.fronts(), b = back.fronts();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].sides, b[i].sides);
      EXPECT_EQ(a[i].kept, b[i].kept);
    }
    EXPECT_EQ(there.cuts().size(), back.cuts().size());
  }
}

}  // namespace
}  // namespace chartflood
