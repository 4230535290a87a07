// A picture that the window saved, and the one that the command line makes of it: the same pixels.

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "app/cli/batch.h"
#include "app/cli/options.h"
#include "app/gui/views/picture_taker.h"
#include "app/host/actions/actions.h"
#include "app/host/actions/chart_swap.h"
#include "app/host/files/picture_record.h"
#include "app/host/film/film_frame.h"
#include "app/host/script/action_registry.h"
#include "core/base/error.h"
#include "core/io/write/file_output.h"
#include "render/gl/offscreen_context.h"
#include "render/scene/image.h"
#include "tests/support/run_program.h"

namespace chartflood {

namespace {

class SamePicture : public ::testing::Test {
 protected:
  SamePicture() {
    state.preferences.picture.smooth = 1;
    state.preferences.askUnsaved = false;
    state.panels.viewWidth = 180;
    state.panels.viewHeight = 130;
    state.playback.setSpeed(2 * Playback::kFastest);
    state.preferences.explore = false;
    state.view.render.background = backgroundFromText("#203040");
  }
  void settle() {
    for (int i = 0; i < 20; ++i) {
      state.update(1.0 / 60);
      live.catchUp(state);
      const std::vector<Index> numbers = live.chartColorNumbers(state);
      if (!numbers.empty()) state.view.chartColors = numbers;
    }
  }
  void run(std::string_view line) {
    ASSERT_TRUE(state.perform(actions, line)) << line;
    settle();
  }
  void openModel(const std::string& sample = "bumps") {
    const std::string file = (folder.path() / "model.obj").string();
    call({"--sample=" + sample, "--triangles=500", "--layout=square", "--export-mesh=" + file});
    run("open " + file);
    frameModel();
  }
  /// As the scene panel does.
  void frameModel() {
    state.view.camera.frame(state.results().mesh->positions(), 180.0 / 130);
    state.view.frameWhenLoaded = false;
  }
  /// The command line has a context of its own.
  void call(std::vector<std::string> words) {
    context->release();
    runBatch(readOptions(words));
    context->makeCurrent();
  }

  /// Takes a picture as set, makes it again, and looks at both.
  void expectTheSame(const std::string& how, std::vector<std::string> words = {}) {
    const std::string first = (folder.path() / (std::to_string(++count) + ".png")).string();
    const std::string again = (folder.path() / "again.png").string();
    ASSERT_TRUE(state.perform(actions, "screenshot " + how + " file=" + first));
    {
      PictureTaker taker([] {});
      taker.update(state, scene, 1);
    }  // waits for the file
    words.push_back("--output=" + again);
    if (words.size() == 1) words.insert(words.begin(), first);
    for (std::string& word : words) {
      if (word == "--like") word += "=" + first;
    }
    call(words);
    const Image before = readPng(first), after = readPng(again);
    ASSERT_EQ(before.width(), after.width());
    ASSERT_EQ(before.height(), after.height());
    EXPECT_EQ(compareImages(before, after).differentPixels, 0u) << how;
  }

  TemporaryFolder folder;
  std::unique_ptr<gl::Context> context =
      gl::createOffscreenContext(gl::offscreenBackendFromId("auto"));
  gl::CurrentScope current{*context};
  AppState state{Session::Worker::Inline};
  ActionRegistry actions = makeActionRegistry();
  SceneView live{[] {}};
  CompareScene scene{live, [] {}};
  int count = 0;
};

TEST_F(SamePicture, OfChartsWhoseSeedsWereMoved) {
  openModel();
  run("set charts 7");
  run("add-seed 40");
  run("seeds on");
  run("numbers on");
  expectTheSame("view=3d");
}

TEST_F(SamePicture, WithTheColoursThatChartsHaveKept) {
  openModel();
  for (const char* more : {"set charts 30", "set charts 9", "set charts 14"}) run(more);
  expectTheSame("view=3d");
}

TEST_F(SamePicture, OfValuesFromAnotherSide) {
  openModel();
  state.view.camera.orbit(0.7, 0.3);
  run("color-mode gauss-face");
  run("seams off");
  expectTheSame("view=3d scale=2");
}

TEST_F(SamePicture, WithColoursThatWereSwapped) {
  openModel();
  for (Index chart = 0; chart < state.view.chartColors.size(); ++chart) {
    const std::vector<Index> partners = colorPartners(state, chart);
    if (partners.empty()) continue;
    run("swap-colors " + std::to_string(chart) + ' ' + std::to_string(partners.back()));
    break;
  }
  ASSERT_GT(state.view.recolored, 0u);
  expectTheSame("view=3d");
}

TEST_F(SamePicture, OfAFloodUnderWay) {
  openModel();
  run("seek 200");
  ASSERT_FALSE(state.showsFinal());
  expectTheSame("view=3d");
}

TEST_F(SamePicture, WithProblemsMarked) {
  openModel("rocket");
  run("set charts 3");
  run("unwrap");
  run("problems on");
  expectTheSame("view=3d");
  expectTheSame("view=uv");
}

TEST_F(SamePicture, WhereOptionsSayWhatTheLegendDoes) {
  openModel("rocket");
  run("set charts 3");
  run("unwrap");
  run("color-mode gauss-face");
  const std::string plain = (folder.path() / "plain.png").string();
  const std::string edited = (folder.path() / "edited.png").string();
  const std::string again = (folder.path() / "again.png").string();
  const auto take = [&](const std::string& file) {
    ASSERT_TRUE(state.perform(actions, "screenshot view=3d file=" + file));
    PictureTaker taker([] {});
    taker.update(state, scene, 1);
  };
  take(plain);
  std::vector<std::string> words = {"--like=" + plain, "--output=" + again,
                                    (folder.path() / "model.obj").string()};
  // Each one more changes the picture, in the window and by its option in the same way.
  const std::pair<const char*, const char*> changes[] = {
      {"legend-scale root", "--color-scale=root"},
      {"legend-steps 5", "--color-steps=5"},
      {"invert-colors on", "--invert-colors"},
      {"colormap magma", "--colormap=magma"},
      {"legend-range 0 0.02", "--range=0,0.02"},
      {"legend-clamp off", "--clamp-colors=off"},
      {"problems on", "--problems"},
      {"sharp-edges on", "--sharp-edges"}};
  Image before = readPng(plain);
  for (const auto& [line, option] : changes) {
    run(line);
    take(edited);
    words.emplace_back(option);
    call(words);
    const Image wanted = readPng(edited);
    EXPECT_EQ(compareImages(wanted, readPng(again)).differentPixels, 0u) << option;
    EXPECT_GT(compareImages(wanted, before).differentPixels, 0u) << option;
    before = wanted;
  }
}

TEST_F(SamePicture, HoldsItsRecipeEvenWhereAMomentIsNotHeld) {
  openModel();
  run("run");
  ASSERT_GT(state.results().history.size(), 1u);
  run("go-to-round 1 100");
  ASSERT_FALSE(state.showsFinal());
  const std::string file = (folder.path() / "moment.png").string();
  ASSERT_TRUE(state.perform(actions, "screenshot view=3d file=" + file));
  {
    PictureTaker taker([] {});
    taker.update(state, scene, 1);
    while (state.notices.toasts().empty() ||
           state.notices.toasts().back().text.find("moment.png") == std::string::npos) {
      taker.update(state, scene, 1);
    }
  }
  EXPECT_TRUE(holdsSession(file));
  EXPECT_NE(state.notices.toasts().back().text.find("but not this moment of the run"),
            std::string::npos);
  const PictureSource source = readPictureSource(file, folder.path() / "model.obj");
  EXPECT_EQ(source.session.parameters, state.document().parameters);
  EXPECT_TRUE(source.session.charts.finished);
}

TEST_F(SamePicture, OfTheTexture) {
  openModel();
  run("unwrap");
  ASSERT_TRUE(state.results().flat);
  state.view.uvCamera.zoom(2, {0.1, 0.2}, {180, 130});
  expectTheSame("view=uv");
}

TEST_F(SamePicture, OfModelAndTexture) {
  openModel();
  run("unwrap");
  expectTheSame("view=both");
}

TEST_F(SamePicture, OfAChartAlone) {
  openModel();
  run("select-chart 3");
  run("isolate on");
  expectTheSame("view=3d");
}

TEST_F(SamePicture, OfEveryPictureOfARow) {
  openModel();
  run("set charts 6");
  state.preferences.picture.folder = folder.path().string();
  PictureTaker taker([] {});
  for (const char* row : {"turntable 3", "flood-film 3"}) {
    ASSERT_TRUE(state.perform(actions, row));
    for (int i = 0; i < 500 && (state.pictureRow.running() || i == 0); ++i) {
      taker.update(state, scene, 1);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  for (const char* name : {"model_turntable", "model_flood"}) {
    for (const char* number : {"1", "2", "3"}) {
      const std::filesystem::path file =
          folder.path() / name / (std::string(name) + "_00" + number + ".png");
      const std::string again = (folder.path() / "again.png").string();
      call(
          {(folder.path() / "model.obj").string(), "--like=" + file.string(), "--output=" + again});
      EXPECT_EQ(compareImages(readPng(file), readPng(again)).differentPixels, 0u) << file;
    }
  }
}

TEST_F(SamePicture, OfAWholeFilm) {
  // A number of pictures by which the faces cannot be divided evenly.
  constexpr int kFrames = 12;
  openModel();
  run("set charts 6");
  state.preferences.picture.folder = folder.path().string();
  PictureTaker taker([] {});
  ASSERT_TRUE(state.perform(actions, "flood-film " + std::to_string(kFrames)));
  for (int i = 0; i < 2000 && (state.pictureRow.running() || i == 0); ++i) {
    taker.update(state, scene, 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  const auto frame = [&](const std::string& begin, int number) {
    return begin + (number < 10 ? "_00" : "_0") + std::to_string(number) + ".png";
  };
  const std::string window = (folder.path() / "model_flood" / "model_flood").string();
  call({(folder.path() / "model.obj").string(), "--like=" + frame(window, kFrames),
        "--flood-film=" + std::to_string(kFrames),
        "--output=" + (folder.path() / "batch.png").string()});
  for (int i = 1; i <= kFrames; ++i) {
    const Image batch = readPng(frame((folder.path() / "batch").string(), i));
    EXPECT_EQ(compareImages(readPng(frame(window, i)), batch).differentPixels, 0u) << i;
  }
}

TEST(FilmFrame, MomentsRunEvenlyFromNoneToAll) {
  for (const std::size_t recorded : {0u, 1u, 500u, 1'000'003u}) {
    for (const std::size_t frames : {2u, 7u, 49u, 300u}) {
      EXPECT_EQ(filmPlayhead(recorded, 0, frames), 0u);
      EXPECT_EQ(filmPlayhead(recorded, frames - 1, frames), std::nullopt);
      for (std::size_t i = 0; i + 1 < frames; ++i) {
        // The largest whole number that is not above the exact share.
        const std::size_t at = *filmPlayhead(recorded, i, frames);
        EXPECT_LE(at * (frames - 1), recorded * i);
        EXPECT_GT((at + 1) * (frames - 1), recorded * i);
      }
    }
  }
}

TEST_F(SamePicture, OfAComparisonSaysHowEachSideWasMade) {
  openModel();
  run("set charts 6");
  run("store A");
  run("set charts 9");
  const std::string file = (folder.path() / "1.png").string();
  run("screenshot view=ab file=" + file);
  {
    PictureTaker taker([] {});
    taker.update(state, scene, 1);
  }
  ImageTexts texts;
  readPng(file, &texts);
  const auto text = [&](const std::string& key) {
    for (const auto& [name, value] : texts) {
      if (name == key) return value;
    }
    return std::string();
  };
  EXPECT_NE(text("Side A").find("--charts=6 "), std::string::npos) << text("Side A");
  EXPECT_NE(text("Side Live").find("--charts=9 "), std::string::npos) << text("Side Live");
  EXPECT_EQ(text("Side A").find(folder.path().string()), std::string::npos);
}

TEST_F(SamePicture, OfASample) {
  run("sample bumps 600");
  frameModel();
  expectTheSame("view=3d");
}

TEST_F(SamePicture, OfAModelThatWasMoved) {
  openModel();
  run("set charts 5");
  std::filesystem::create_directory(folder.path() / "elsewhere");
  const std::string moved = (folder.path() / "elsewhere" / "model.obj").string();
  writeFileAtomically(moved, readAll(folder.path() / "model.obj"));
  expectTheSame("view=3d", {moved, "--like"});
}

TEST_F(SamePicture, SaysNothingOfTheUsersFolders) {
  openModel();
  const std::string file = (folder.path() / "1.png").string();
  run("screenshot file=" + file);
  {
    PictureTaker taker([] {});
    taker.update(state, scene, 1);
  }
  ImageTexts texts;
  readPng(file, &texts);
  ASSERT_GE(texts.size(), 4u);
  for (const auto& [key, value] : texts) {
    EXPECT_EQ(value.find(folder.path().string()), std::string::npos) << key << ": " << value;
  }
}

TEST_F(SamePicture, OpensInTheWindowAsTheStateThatItShows) {
  openModel();
  run("set charts 6");
  run("color-mode balance");
  const std::string file = (folder.path() / "1.png").string();
  run("screenshot file=" + file);
  {
    PictureTaker taker([] {});
    taker.update(state, scene, 1);
  }
  const std::vector<Index> labels = state.results().segmentation->label;
  run("set charts 11");
  run("color-mode charts");
  run("open " + file);
  EXPECT_EQ(state.document().parameters.charts, 6);
  EXPECT_EQ(state.results().segmentation->label, labels);
  EXPECT_EQ(state.view.render.colorMode, ColorMode::Balance);
  EXPECT_TRUE(state.keeper.file().empty());
}

TEST_F(SamePicture, NotOfPicturesFromElsewhere) {
  const std::string file = (folder.path() / "other.png").string();
  writePng(Image(4, 4), file);
  EXPECT_THROW(readOptions(std::vector<std::string>{file}), ReadError);
  EXPECT_FALSE(holdsSession(file));
}

}  // namespace

}  // namespace chartflood
