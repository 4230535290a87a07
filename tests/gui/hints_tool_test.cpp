// The brush of hints: strokes with the mouse in the 3D view, and the actions behind them.

#include <algorithm>
#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/host/actions/hint_edits.h"
#include "render/passes/renderer.h"
#include "tests/gui/headless_frame.h"
#include "tests/gui/pointer_source.h"

namespace chartflood {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class HintsTool : public testing::Test {
 protected:
  HintsTool() {
    ui_.setSource(&source_);
    ui_.openFlooded("sphere", 1200);
    ui_.key("Shift+G");
    ui_.frames(2);
  }
  AppState& state() { return ui_.state(); }
  const Mesh& mesh() { return *state().results().mesh; }
  const EdgeHints& hints() { return state().document().hints; }
  std::size_t steps() { return state().undoHistory().size(); }
  std::vector<Index> labels() { return state().results().segmentation->label; }

  /// At shares of the view's width and height.
  ImVec2 inView(float x, float y) {
    const ProbedItem view = ui_.item("view");
    return {view.min.x + x * (view.max.x - view.min.x), view.min.y + y * (view.max.y - view.min.y)};
  }
  ImVec2 placeOf(const glm::dvec3& point) {
    const ProbedItem view = ui_.item("view");
    const double width = view.max.x - view.min.x, height = view.max.y - view.min.y;
    const glm::dvec3 ndc = state().view.camera.project(point, width / height, BoundingSphere{});
    return inView(static_cast<float>((ndc.x + 1) / 2), static_cast<float>((1 - ndc.y) / 2));
  }
  Pick pickAt(ImVec2 place) {
    const ImVec2 low = ui_.item("view").min;
    return source_.pick(static_cast<int>(place.x - low.x), static_cast<int>(place.y - low.y));
  }
  Index vertexAt(ImVec2 place) {
    const Pick pick = pickAt(place);
    EXPECT_TRUE(pick.hit());
    return pick.hit() ? nearestCorner(mesh(), pick.triangle, pick.point) : kNone;
  }
  /// Paints from place to place with the left button.
  void stroke(ImVec2 from, ImVec2 to) {
    ui_.frames(40);  // long enough not to be a double click
    ui_.moveTo(from);
    ui_.press();
    for (int i = 1; i <= 10; ++i) {
      const float t = static_cast<float>(i) / 10;
      ui_.moveTo({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
    }
    ui_.release();
    ui_.frames(2);
  }
  std::size_t count(HintKind kind) {
    return static_cast<std::size_t>(std::count_if(
        hints().begin(), hints().end(), [&](const EdgeHint& hint) { return hint.kind == kind; }));
  }
  /// A side between two charts whose ends and middle are in full view, in the middle of it.
  Index shownSeam() {
    for (Index s = 0; s < mesh().opposite().size(); ++s) {
      const Index other = mesh().opposite()[s];
      if (other == kNone || !crossed(s)) continue;
      const Index a = mesh().sideStart(s), b = mesh().sideEnd(s);
      const glm::dvec3 from = mesh().positions()[a], to = mesh().positions()[b];
      const Pick pick = pickAt(placeOf((from + to) / 2.0));
      const bool central = length(placeOf(from), inView(0.5f, 0.5f)) < 120;
      if (!central || !pick.hit() || glm::length(pick.point - (from + to) / 2.0) > 0.05) continue;
      if (vertexAt(placeOf(from)) == a && vertexAt(placeOf(to)) == b) return s;
    }
    ADD_FAILURE() << "no seam in view";
    return 0;
  }
  bool crossed(Index side) {
    const auto label = labels();
    return label[mesh().faceOf(side / 3)] != label[mesh().faceOf(mesh().opposite()[side] / 3)];
  }
  static float length(ImVec2 a, ImVec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

  HeadlessFrame ui_;
  PointerSource source_;
};

TEST_F(HintsTool, KeysAndButtonsSwitchIt) {
  EXPECT_EQ(state().panels.tool, PanelState::Tool::Hints);
  EXPECT_TRUE(ui_.has("brush cut"));
  ui_.click("brush never");
  EXPECT_EQ(state().panels.brush, HintBrush::Never);
  ui_.click("brush erase");
  EXPECT_EQ(state().panels.brush, HintBrush::Erase);
  ui_.key("V");
  ui_.frames(2);
  EXPECT_FALSE(ui_.has("brush cut"));
  ui_.click("tool hints");
  EXPECT_EQ(state().panels.tool, PanelState::Tool::Hints);
}

TEST_F(HintsTool, AStrokePaintsAChainOfEdgesInOneStep) {
  const ImVec2 from = inView(0.42f, 0.5f), to = inView(0.58f, 0.55f);
  const Index first = vertexAt(from), last = vertexAt(to);
  const double turned = state().view.camera.azimuthDegrees();
  stroke(from, to);
  ASSERT_GT(hints().size(), 2u);
  EXPECT_EQ(count(HintKind::Cut), hints().size()) << "the brush begins with cuts";
  EXPECT_THAT(ui_.lastLine(),
              StartsWith("paint cut path=" + std::to_string(mesh().inputVertex(first)) + ","));
  EXPECT_THAT(ui_.lastLine(), testing::EndsWith("," + std::to_string(mesh().inputVertex(last))));
  EXPECT_EQ(hintSides(mesh(), hints(), HintKind::Cut).size(), hints().size())
      << "every hint is an edge";
  // Without turning back the chain has two ends.
  std::map<Index, int> touched;
  for (const EdgeHint& hint : hints()) ++touched[hint.a], ++touched[hint.b];
  EXPECT_EQ(touched[mesh().inputVertex(first)], 1);
  EXPECT_EQ(touched[mesh().inputVertex(last)], 1);
  EXPECT_EQ(steps(), 1u);
  EXPECT_EQ(state().undoHistory().undoName(), "Paint hints");
  EXPECT_EQ(state().view.camera.azimuthDegrees(), turned) << "the camera stays";
  const EdgeHints painted = hints();
  ui_.key("Ctrl+Z");
  ui_.frames(2);
  EXPECT_TRUE(hints().empty());
  ui_.key("Ctrl+Shift+Z");
  ui_.frames(2);
  EXPECT_EQ(hints(), painted);
}

TEST_F(HintsTool, TheOtherBrushesRepaintAndErase) {
  const ImVec2 from = inView(0.42f, 0.5f), to = inView(0.58f, 0.5f);
  stroke(from, to);
  const std::size_t painted = hints().size();
  ui_.click("brush never");
  stroke(from, to);
  EXPECT_EQ(hints().size(), painted) << "an edge has one hint";
  EXPECT_EQ(count(HintKind::Never), painted);
  ui_.click("brush erase");
  stroke(from, to);
  EXPECT_TRUE(hints().empty());
  EXPECT_EQ(state().undoHistory().undoName(), "Erase hints");
  EXPECT_EQ(steps(), 3u);
}

TEST_F(HintsTool, SeamsLeaveWhatIsPaintedAndComeBackByUndo) {
  state().perform(ui_.actions(), "run");
  ui_.frames(3);
  const std::vector<Index> before = labels();
  const Index seam = shownSeam();
  ASSERT_TRUE(crossed(seam));
  ui_.click("brush never");
  stroke(placeOf(mesh().positions()[mesh().sideStart(seam)]),
         placeOf(mesh().positions()[mesh().sideEnd(seam)]));
  ASSERT_EQ(hints().size(), 1u);
  EXPECT_FALSE(crossed(seam));
  EXPECT_TRUE(state().results().finished) << "the charts are finished in the new way";
  ui_.key("Ctrl+Z");
  ui_.frames(2);
  EXPECT_EQ(labels(), before);
}

TEST_F(HintsTool, BesideTheModelAndWithAltTheCameraTurns) {
  const double turned = state().view.camera.azimuthDegrees();
  ASSERT_FALSE(pickAt(inView(0.03f, 0.5f)).hit());
  stroke(inView(0.03f, 0.5f), inView(0.2f, 0.5f));
  const double then = state().view.camera.azimuthDegrees();
  EXPECT_GT(std::abs(then - turned), 5);
  ImGui::GetIO().KeyAlt = true;
  stroke(inView(0.45f, 0.5f), inView(0.6f, 0.5f));
  ImGui::GetIO().KeyAlt = false;
  EXPECT_GT(std::abs(state().view.camera.azimuthDegrees() - then), 5);
  EXPECT_TRUE(hints().empty());
}

TEST_F(HintsTool, AClickPaintsNothing) {
  ui_.frames(40);
  ui_.moveTo(inView(0.5f, 0.5f));
  ui_.press();
  ui_.release();
  ui_.frames(2);
  EXPECT_TRUE(hints().empty());
  EXPECT_EQ(steps(), 0u);
}

TEST_F(HintsTool, InTheSelectToolADragPaintsNothing) {
  ui_.key("V");
  stroke(inView(0.42f, 0.5f), inView(0.58f, 0.5f));
  EXPECT_TRUE(hints().empty());
}

TEST_F(HintsTool, RefusalsSayWhatIsWrong) {
  const auto refusal = [&](const std::string& line) {
    EXPECT_FALSE(state().perform(ui_.actions(), line)) << line;
    return state().notices.toasts().back().text;
  };
  EXPECT_THAT(refusal("clear-hints"), HasSubstr("No edge has a hint"));
  EXPECT_THAT(refusal("paint cut path=7"), HasSubstr("two vertices"));
  EXPECT_THAT(refusal("paint cut path=1,x"), HasSubstr("no list of vertices"));
  EXPECT_THAT(refusal("paint cut path=0,999999"), HasSubstr("no edge between vertices 0 and"));
  EXPECT_THAT(refusal("paint red path=0,1"), HasSubstr("red"));
  EXPECT_TRUE(hints().empty());
  stroke(inView(0.42f, 0.5f), inView(0.58f, 0.5f));
  ASSERT_FALSE(hints().empty());
  EXPECT_TRUE(state().perform(ui_.actions(), "clear-hints"));
  EXPECT_TRUE(hints().empty());
  EXPECT_EQ(state().undoHistory().undoName(), "Clear hints");
}

}  // namespace
}  // namespace chartflood
