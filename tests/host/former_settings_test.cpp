// Files and scripts in the words of the version before settings had tables still open: every
// setting away from its default, read and compared value by value.

#include <fstream>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/actions/actions.h"
#include "app/host/files/picture_record.h"
#include "app/host/files/session_view.h"
#include "app/host/state/app_state.h"

namespace chartflood {
namespace {

const std::filesystem::path kFormer =
    std::filesystem::path(CHARTFLOOD_CASES).parent_path() / "data" / "former-settings";

void expectLegends(const ViewSettings& view) {
  const RenderSettings& render = view.render;
  EXPECT_EQ(render.colorMode, ColorMode::GaussFace);
  EXPECT_EQ(presentLegend(render),
            (LegendChoice{"magma", true, 8, false, ScalarScale::Root, std::pair(-1.0, 2.5)}));
  ASSERT_EQ(view.legends.size(), 1u);
  EXPECT_EQ(view.legends.at(ColorMode::Balance),
            (LegendChoice{"paper", false, 4, true, std::nullopt, std::pair(-20.0, 20.5)}));
}

void expectOverlays(const RenderSettings& render) {
  EXPECT_FALSE(render.seams);
  EXPECT_FALSE(render.cuts);
  EXPECT_TRUE(render.edges);
  EXPECT_TRUE(render.sharpEdges);
  EXPECT_FALSE(render.seedMarks);
  EXPECT_TRUE(render.numbers);
  EXPECT_FALSE(render.scalarBar);
  EXPECT_FALSE(render.smoothNormals);
  EXPECT_TRUE(render.problems);
}

void expectChecker(const RenderSettings& render) {
  EXPECT_EQ(render.checkerSquares, 55);
  EXPECT_EQ(render.checkerKind, CheckerKind::Circles);
  EXPECT_EQ(render.checkerRepeats, 3);
  EXPECT_TRUE(render.checkerInTexture);
  EXPECT_EQ(render.checkerTint, 0);
}

/// What a session and a script both set.
void expectView(const ViewSettings& view) {
  expectLegends(view);
  expectOverlays(view.render);
  expectChecker(view.render);
  EXPECT_FALSE(view.uv.fill);
  EXPECT_FALSE(view.uv.frame);
  EXPECT_TRUE(view.camera.orthographic);
  EXPECT_EQ(view.camera.up, UpAxis::Z);
  EXPECT_FALSE(view.sphereLinked);
}

/// What a session alone holds.
void expectSessionView(const SessionView& values) {
  ViewSettings view;
  EXPECT_THAT(applyViewValues(values, view), testing::IsEmpty());
  expectView(view);
  EXPECT_EQ(view.render.background, backgroundFromText("#102030"));
  EXPECT_EQ(view.render.selectedCharts, (std::vector<Index>{1, 3}));
  EXPECT_EQ(view.render.hiddenCharts, (std::vector<Index>{0, 2}));
  EXPECT_EQ(view.chartColors, (std::vector<Index>{4, 3, 2}));
  EXPECT_EQ(view.camera.target, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(view.camera.distance, 3.25);
  EXPECT_EQ(view.camera.fieldOfView, 0.75);
  EXPECT_EQ(view.uvCamera.span, 0.5);
  EXPECT_EQ(view.sphereCamera.orientation, glm::dquat(0.5, 0.5, 0.5, 0.5));
}

/// Parameters that the former version did not have: its files leave them at their defaults.
const std::set<std::string> kSince = {"even", "seeding"};

/// The parameters of that version were all moved off their defaults.
void expectParameters(const Parameters& parameters) {
  for (const ParameterInfo& info : parameterTable()) {
    EXPECT_EQ(isDefault(parameters, info), kSince.contains(info.id)) << info.id;
  }
  EXPECT_EQ(parameters.method, "mcgim");
  EXPECT_EQ(parameters.charts, 21);
  EXPECT_EQ(parameters.sharpAngle, 47.8125);
  EXPECT_FALSE(parameters.cutTips);
}

void expectPreferences(const Preferences& read) {
  EXPECT_EQ(read.theme, ThemeKind::Light);
  EXPECT_EQ(read.uiScale, 1.5);
  EXPECT_EQ(read.navigation, NavigationStyle::Maya);
  EXPECT_EQ(read.live, LiveMode::Off);
  EXPECT_TRUE(read.invertZoom);
  EXPECT_TRUE(read.invertTurnX);
  EXPECT_TRUE(read.invertTurnY);
  EXPECT_TRUE(read.trackball);
  EXPECT_FALSE(read.askUnsaved);
  EXPECT_EQ(read.film.many, ManyFaces::OneAChart);
  EXPECT_TRUE(read.film.reducedMotion);
  PictureSettings picture;
  picture.view = "uv";
  picture.size = "own";
  picture.width = 800;
  picture.height = 300;
  picture.lockRatio = false;
  picture.smooth = 4;
  picture.ground = "white";
  picture.legend = picture.seeds = picture.seams = picture.numbers = false;
  picture.frames = 24;
  picture.name = "{model}_{n:4}.png";
  picture.folder = "/pictures";
  EXPECT_EQ(read.picture, picture);
}

TEST(FormerSettings, OfASession) {
  const SessionFile session = readSession(kFormer / "all.chartflood");
  EXPECT_THAT(session.warnings, testing::IsEmpty());
  expectParameters(session.parameters);
  expectSessionView(session.view);
}

TEST(FormerSettings, OfAPicture) {
  const PictureSource source = readPictureSource(kFormer / "picture.png", {});
  expectParameters(source.session.parameters);
  expectSessionView(source.session.view);
  PictureRecord record;
  record.view = "both";
  record.width = 640;
  record.height = 200;
  record.smooth = 4;
  record.lineScale = 1.5;
  record.playhead = 17;
  EXPECT_EQ(source.record, record);
}

TEST(FormerSettings, OfPreferences) {
  std::string warning;
  const Preferences read = readPreferences(kFormer, kFormer, warning);
  EXPECT_EQ(warning, "");
  expectPreferences(read);
  EXPECT_FALSE(read.firstCard);
  EXPECT_EQ(read.windowWidth, 1001);
  EXPECT_EQ(read.windowHeight, 702);
  EXPECT_THAT(read.recentFiles, testing::ElementsAre("/models/bunny.obj", "/models/cow.ply"));
  ASSERT_EQ(read.presets.size(), 1u);
  Parameters base;
  base.rngSeed = 2;
  const Parameters preset = applyUserPreset(base, read.presets[0], warning);
  EXPECT_EQ(warning, "");
  expectParameters(preset);
}

TEST(FormerSettings, OfAScript) {
  AppState state(Session::Worker::Inline);
  const ActionRegistry actions = makeActionRegistry();
  std::ifstream script(kFormer / "script.txt");
  int lines = 0;
  for (std::string line; std::getline(script, line); ++lines) {
    EXPECT_TRUE(state.perform(actions, line)) << line;
  }
  EXPECT_EQ(lines, 58);
  expectView(state.view);
  EXPECT_EQ(state.view.vision, ColorVision::GreenBlind);
  expectPreferences(state.preferences);
}

}  // namespace
}  // namespace chartflood
