#include <numeric>

#include "core/base/error.h"
#include "tests/render/scene.h"

namespace chartflood {
namespace {

class FloodPixels : public test::GlTest {
 protected:
  /// Takes the faces in the order of their number, those of a cube's side for one chart.
  std::shared_ptr<FloodRecord> cubeRecord() const {
    auto record = std::make_shared<FloodRecord>(mesh_->faceCount());
    fill(*record, 0, mesh_->faceCount());
    return record;
  }
  void fill(FloodRecord& record, std::size_t begin, std::size_t end) const {
    const std::size_t perSide = mesh_->faceCount() / 6;
    for (std::size_t f = begin; f < end; ++f) {
      record.append(static_cast<Index>(f), static_cast<Index>(f / perSide),
                    static_cast<float>(f % perSide));
    }
    record.publish();
  }
};

TEST_F(FloodPixels, LaterFacesAreDryEarlierOnesHaveTheirChart) {
  show(test::cube(6));
  setFlood(cubeRecord());
  RenderSettings settings = flat(ColorMode::Charts);
  const auto seen = seenTriangles();
  for (const std::size_t playhead : {0u, 100u, 250u, 432u}) {
    settings.playhead = playhead;
    const Image image = draw(settings);
    for (const auto& [triangle, pixel] : seen) {
      const Rgba8 color = image.at(pixel.x, pixel.y);
      if (triangle >= playhead) {
        EXPECT_EQ(color, (Rgba8{0x6A, 0x6A, 0x6A, 255})) << triangle << " at " << playhead;
      } else if (triangle + 5 < playhead) {  // the newest 1 % (5 of 432) are bright
        test::expectColor(color, renderer_->chartColor(triangle / 72, settings));
      } else {
        EXPECT_GT(color[0] + color[1] + color[2],
                  255 * (renderer_->chartColor(triangle / 72, settings).r +
                         renderer_->chartColor(triangle / 72, settings).g +
                         renderer_->chartColor(triangle / 72, settings).b));
      }
    }
  }
}

TEST_F(FloodPixels, AGrowingRecordGivesTheSamePictureAsAFinishedOne) {
  show(test::cube(6));
  RenderSettings settings = flat(ColorMode::FloodOrder);
  settings.seams = true;
  settings.playhead = 300;
  setFlood(cubeRecord());
  const Image whole = draw(settings);
  auto growing = std::make_shared<FloodRecord>(mesh_->faceCount());
  setFlood(growing);
  for (std::size_t f = 0; f < mesh_->faceCount(); f += 48) {
    fill(*growing, f, f + 48);
    updateFlood();
  }
  EXPECT_EQ(draw(settings), whole);
}

TEST_F(FloodPixels, ScrubbingBackEqualsSteppingForward) {
  show(test::cube(6));
  setFlood(cubeRecord());
  RenderSettings settings = flat(ColorMode::Charts);
  settings.seams = true;
  settings.playhead = 200;
  const Image before = draw(settings);
  settings.playhead = 432;
  EXPECT_NE(draw(settings), before);
  settings.playhead = 200;
  EXPECT_EQ(draw(settings), before);
}

/// Whatever the way to a moment: the same picture in every colour mode that a flood has.
TEST_F(FloodPixels, EveryMomentLooksTheSameOnTheWayBack) {
  show(test::cube(6));
  const auto log = std::make_shared<FloodRecord>(mesh_->faceCount());
  setFlood(log);
  for (const ColorMode mode : {ColorMode::Charts, ColorMode::FloodOrder, ColorMode::FloodTime}) {
    RenderSettings settings = flat(mode);
    settings.seams = settings.edges = true;
    std::vector<Image> forward;
    for (std::size_t step = 0; step <= 432; step += 48) {
      // The first time the log is still growing.
      if (log->size() < step) fill(*log, log->size(), step);
      updateFlood();
      settings.playhead = step;
      if (mode != ColorMode::FloodTime || log->size() == 432) forward.push_back(draw(settings));
    }
    for (std::size_t i = forward.size(); i-- > 0;) {
      settings.playhead = 48 * i;
      EXPECT_EQ(draw(settings), forward[i]) << "after " << 48 * i;
    }
  }
}

TEST_F(FloodPixels, OtherLabelsAndBackGiveTheSamePicture) {
  show(test::cube(6));
  const Segmentation labels = cubeSides();
  setCharts(labels);
  RenderSettings settings = flat(ColorMode::Charts);
  settings.seams = true;
  const Image before = draw(settings);
  std::vector<Index> other = labels.label;
  const auto seen = seenTriangles();
  const auto [moved, pixel] = seen[seen.size() / 2];
  other[moved] = (other[moved] + 1) % 6;
  setLabels(other);
  const Image changed = draw(settings);
  EXPECT_NE(changed, before);
  settings.seams = false;
  test::expectColor(draw(settings).at(pixel.x, pixel.y),
                    renderer_->chartColor(other[moved], settings));
  settings.seams = true;
  setLabels(labels.label);
  EXPECT_EQ(draw(settings), before);
  EXPECT_THROW(setLabels(std::vector<Index>(3)), Error);
}

TEST_F(FloodPixels, GoingToAnotherRoundAndBackGivesTheSamePicture) {
  show(test::cube(6));
  auto other = std::make_shared<FloodRecord>(mesh_->faceCount());
  for (std::size_t i = mesh_->faceCount(); i-- > 0;) {
    other->append(static_cast<Index>(i), static_cast<Index>(i / 72), 0);
  }
  other->publish();
  const auto first = cubeRecord();
  RenderSettings settings = flat(ColorMode::Charts);
  settings.seams = true;
  settings.playhead = 200;
  setFlood(first);
  const Image before = draw(settings);
  setFlood(other);
  EXPECT_NE(draw(settings), before);
  setFlood(first, 50);
  while (!updateFlood(50)) continue;
  EXPECT_EQ(draw(settings), before);
}

TEST_F(FloodPixels, WithoutAFrontAWholeFloodLooksLikeItsLabels) {
  show(test::cube(6));
  setFlood(cubeRecord());
  const Segmentation labels = cubeSides();
  setCharts(labels);
  RenderSettings settings = flat(ColorMode::Charts);
  const Image final = draw(settings);
  settings.playhead = mesh_->faceCount();
  EXPECT_NE(draw(settings), final);
  settings.front = false;
  EXPECT_EQ(draw(settings), final);
}

TEST_F(FloodPixels, TheFlashMarksOneFace) {
  show(test::cube(6));
  setFlood(cubeRecord());
  RenderSettings settings = flat(ColorMode::Charts);
  settings.playhead = 200;
  const auto seen = seenTriangles();
  const auto [triangle, pixel] = seen[seen.size() / 2];
  settings.flashFace = triangle;
  EXPECT_EQ(draw(settings).at(pixel.x, pixel.y), (Rgba8{255, 204, 26, 255}));
}

TEST_F(FloodPixels, TheMomentsAreasColourTheBalance) {
  show(test::cube(6));
  const Segmentation labels = cubeSides();
  setCharts(labels);
  const RenderSettings settings = flat(ColorMode::Balance);
  const Image even = draw(settings);
  ChartStats stats;
  for (const double area : {1, 2, 3, 1, 2, 3}) stats.charts.push_back({.gaussArea = area});
  setStats(stats);
  EXPECT_NE(draw(settings), even);
  for (ChartFigures& chart : stats.charts) chart.gaussArea = 1;
  setStats(stats);
  EXPECT_EQ(draw(settings), even);
}

TEST_F(FloodPixels, SeamsAppearWithTheirSecondFace) {
  show(test::cube(6));
  setFlood(cubeRecord());
  RenderSettings settings = flat(ColorMode::Shaded);
  const Image plain = draw(settings);
  settings.seams = true;
  settings.playhead = 72;  // one side alone: no seam yet
  const auto darkPixels = [](const Image& image) {
    return std::accumulate(
        image.pixels().begin(), image.pixels().end(), 0,
        [](int sum, const Rgba8& p) { return sum + (p[0] < 40 && p[0] > 5 ? 1 : 0); });
  };
  EXPECT_EQ(darkPixels(draw(settings)), 0);
  settings.playhead = 432;
  const int all = darkPixels(draw(settings));
  EXPECT_GT(all, 100);
  settings.playhead = 300;
  const int some = darkPixels(draw(settings));
  EXPECT_LT(some, all);
}

TEST_F(FloodPixels, OrderRunsAlongTheColourMap) {
  show(test::cube(6));
  setFlood(cubeRecord());
  RenderSettings settings = flat(ColorMode::FloodOrder);
  settings.colorMap = "grey";
  const Image image = draw(settings);
  for (const auto& [triangle, pixel] : seenTriangles()) {
    const double t = triangle / 432.0;
    const double grey = 0x1E + t * (0xF5 - 0x1E);
    // Bands make every second twentieth a tenth darker.
    EXPECT_LE(image.at(pixel.x, pixel.y)[0], grey + 2);
    EXPECT_GE(image.at(pixel.x, pixel.y)[0], 0.9 * grey - 2);
  }
}

TEST_F(FloodPixels, TimeIsScaledByItsOwnChart) {
  show(test::cube(6));
  setFlood(cubeRecord());
  RenderSettings settings = flat(ColorMode::FloodTime);
  settings.colorMap = "grey";
  const Image image = draw(settings);
  for (const auto& [triangle, pixel] : seenTriangles()) {
    const double grey = 0x1E + (triangle % 72) / 71.0 * (0xF5 - 0x1E);
    EXPECT_LE(image.at(pixel.x, pixel.y)[0], grey + 2);
    EXPECT_GE(image.at(pixel.x, pixel.y)[0], 0.9 * grey - 2);
  }
}

TEST_F(FloodPixels, AllTrianglesOfAPolygonAreTakenTogether) {
  show(test::quadCube(4));
  auto record = std::make_shared<FloodRecord>(mesh_->faceCount());
  for (Index f = 0; f < 48; ++f) record->append(f, 0, 0);
  record->publish();
  setFlood(record);
  RenderSettings settings = flat(ColorMode::Charts);
  settings.playhead = 48;
  const Image image = draw(settings);
  int wet = 0, dry = 0;
  for (const auto& [triangle, pixel] : seenTriangles()) {
    const bool isDry = image.at(pixel.x, pixel.y) == Rgba8{0x6A, 0x6A, 0x6A, 255};
    EXPECT_EQ(isDry, mesh_->faceOf(triangle) >= 48);
    ++(isDry ? dry : wet);
  }
  EXPECT_GT(wet, 10);
  EXPECT_GT(dry, 10);
}

}  // namespace
}  // namespace chartflood
