// The first minute: a model is dropped on the window that was just started, and charts appear on
// it.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "app/gui/views/scene_view.h"
#include "render/gl/context.h"
#include "tests/gui/headless_frame.h"
#include "tests/support/run_program.h"

namespace chartflood {
namespace {

/// A bumpy square, written as a user's own file would be.
void writeOwnModel(const std::filesystem::path& file) {
  constexpr int kSide = 24;
  std::ofstream out(file);
  for (int y = 0; y <= kSide; ++y) {
    for (int x = 0; x <= kSide; ++x) {
      out << "v " << x << ' ' << y << ' ' << 3 * std::sin(0.5 * x) * std::sin(0.4 * y) << '\n';
    }
  }
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const int v = y * (kSide + 1) + x + 1;
      out << "f " << v << ' ' << v + 1 << ' ' << v + kSide + 2 << ' ' << v + kSide + 1 << '\n';
    }
  }
}

TEST(FirstSteps, DroppingAModelShowsColouredCharts) {
  const TemporaryFolder folder;
  writeOwnModel(folder.path() / "own.obj");
  HeadlessFrame ui;
  ui.frames(3);

  // What a drop on the window does. The first flood begins by itself; Space would hold it.
  ASSERT_TRUE(ui.state().perform(ui.actions(),
                                 "open " + quotedArgument((folder.path() / "own.obj").string())));
  ui.frames(3);
  EXPECT_TRUE(ui.state().playback.playing());
  ui.frames(400);

  EXPECT_EQ(ui.state().view.render.colorMode, ColorMode::Charts);
  std::set<Index> charts;
  for (Index f = 0; f < ui.state().results().mesh->faceCount(); ++f) {
    if (const Index chart = ui.state().chartOfFace(f); chart != kNone) charts.insert(chart);
  }
  EXPECT_EQ(charts.size(), 20u);
  EXPECT_FALSE(ui.state().playback.playing());

  // Space goes on from there.
  ui.key("Space");
  ui.frames(3);
  EXPECT_TRUE(ui.state().playback.playing());
}

}  // namespace
}  // namespace chartflood
