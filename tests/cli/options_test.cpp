// Reading of the command line: forms, order, refusals.

#include "app/cli/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include <string>
#include <vector>

#include "app/cli/help.h"
#include "app/cli/option_table.h"
#include "core/base/error.h"
#include "core/io/mesh_formats.h"

namespace chartflood {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

using Words = std::vector<std::string>;

Invocation read(const Words& words) { return readOptions(words); }

std::string refusal(const Words& words) {
  try {
    readOptions(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  ADD_FAILURE() << "was taken: " << testing::PrintToString(words);
  return "";
}

TEST(Options, NothingMeansTheWindowOnTheFirstSample) {
  const Invocation call = read({});
  EXPECT_EQ(call.task, Invocation::Task::Window);
  EXPECT_EQ(call.file, "");
  EXPECT_EQ(call.sample, "rocket");
  EXPECT_EQ(call.parameters, Parameters{});
}

TEST(Options, ValuesWithAndWithoutEqualsSign) {
  EXPECT_EQ(read({"--charts=7", "a.obj"}).parameters.charts, 7);
  EXPECT_EQ(read({"--charts", "7", "a.obj"}).parameters.charts, 7);
  EXPECT_EQ(read({"a.obj", "--charts", "7"}).file, "a.obj");
  EXPECT_EQ(read({"--charts=7", "--charts=9"}).parameters.charts, 9) << "the last one counts";
}

TEST(Options, Switches) {
  EXPECT_FALSE(read({"--offsets=false"}).parameters.offsets);
  EXPECT_FALSE(read({"--offsets=off"}).parameters.offsets);
  EXPECT_TRUE(read({"--offsets"}).parameters.offsets);
  EXPECT_EQ(read({"--offsets", "off"}).file, "off") << "a switch takes no word after it";
  EXPECT_TRUE(read({"--edges"}).picture.settings.edges);
  EXPECT_FALSE(read({"--seams=false"}).picture.settings.seams);
}

TEST(Options, EveryParameterHasItsOption) {
  for (const ParameterInfo& info : parameterTable()) {
    const std::string text = parameterText(parameterDefault(info));
    Parameters expected;
    if (std::string_view(info.id) == "charts") askCharts(expected, expected.charts);
    EXPECT_EQ(read({"--" + std::string(info.id) + "=" + text}).parameters, expected) << info.id;
  }
}

TEST(Options, BesideAPresetWinInAnyOrder) {
  const Parameters before = read({"--speed-power=2", "--preset=paper-happy"}).parameters;
  const Parameters after = read({"--preset=paper-happy", "--speed-power=2"}).parameters;
  EXPECT_EQ(before, after);
  EXPECT_EQ(before.speedPower, 2);
  EXPECT_EQ(before.offsetDamping, 0.9);
  EXPECT_EQ(read({"--preset=few-large", "--charts=3"}).parameters.charts, 3);
}

TEST(Options, FilesAfterTwoDashes) {
  EXPECT_EQ(read({"--", "-dash.obj"}).file, "-dash.obj");
  EXPECT_EQ(read({"--charts=3", "--", "--charts=4"}).file, "--charts=4");
  EXPECT_EQ(read({"--charts=3", "--", "--charts=4"}).parameters.charts, 3);
}

TEST(Options, OutputsMeanNoWindow) {
  EXPECT_EQ(read({"--output=a.png"}).task, Invocation::Task::Batch);
  EXPECT_EQ(read({"--output=A.PNG"}).task, Invocation::Task::Batch);
  EXPECT_EQ(read({"--report=-"}).task, Invocation::Task::Batch);
  EXPECT_EQ(read({"--export-labels=a.txt"}).task, Invocation::Task::Batch);
  for (const char* word : {"--export-mesh=a.obj", "--export-mesh=a.ply", "--export-mesh=a.GLB",
                           "--export-uv=a.png", "--export-uv=a.svg", "--export-seams=a.obj"}) {
    EXPECT_EQ(read({word}).task, Invocation::Task::Batch) << word;
  }
  EXPECT_EQ(read({"--charts=3"}).task, Invocation::Task::Window);
  EXPECT_EQ(read({"--info"}).task, Invocation::Task::Info);
  EXPECT_EQ(read({"--info=false"}).task, Invocation::Task::Window);
  EXPECT_EQ(read({"-h"}).task, Invocation::Task::Help);
}

TEST(Options, OfThePicture) {
  const PictureOptions picture = read({"--resolution=640,480", "--supersampling=4",
                                       "--color-by=gauss-face", "--colormap=magma", "--range=-1,2",
                                       "--background=transparent", "--numbers", "--seed-marks=off"})
                                     .picture;
  EXPECT_EQ(picture.width, 640);
  EXPECT_EQ(picture.height, 480);
  EXPECT_EQ(picture.supersampling, 4);
  EXPECT_EQ(picture.settings.colorMode, ColorMode::GaussFace);
  EXPECT_EQ(picture.settings.colorMap, "magma");
  EXPECT_EQ(picture.settings.range, std::pair(-1.0, 2.0));
  EXPECT_TRUE(picture.settings.background.transparent);
  EXPECT_TRUE(picture.settings.numbers);
  EXPECT_FALSE(picture.settings.seedMarks);
}

TEST(Options, OfTheLegend) {
  const RenderSettings settings =
      read({"--color-by=gauss-face", "--color-scale=root", "--color-steps=8", "--invert-colors",
            "--clamp-colors=off", "--problems", "--cuts=off", "--sharp-edges"})
          .picture.settings;
  EXPECT_EQ(settings.scale, ScalarScale::Root);
  EXPECT_EQ(settings.colorSteps, 8);
  EXPECT_TRUE(settings.invertColorMap);
  EXPECT_FALSE(settings.clampColors);
  EXPECT_TRUE(settings.problems);
  EXPECT_FALSE(settings.cuts);
  EXPECT_TRUE(settings.sharpEdges);
  EXPECT_EQ(read({"--color-scale=auto"}).picture.settings.scale, std::nullopt);
  EXPECT_THAT(refusal({"--color-scale=roots"}), HasSubstr("root"));
  EXPECT_THAT(refusal({"--color-by=balance", "--color-scale=log"}), HasSubstr("both sides of 0"));
  EXPECT_THAT(refusal({"--color-steps=1"}), HasSubstr("2 to 32"));
  EXPECT_THAT(refusal({"--color-steps=33"}), HasSubstr("32"));
}

TEST(Options, OfCutsAndTexture) {
  const Invocation call = read({"--cut-tips=off", "--tip=0.8", "--relief-stretch=0",
                                "--unwrap=circle", "--layout=square", "--texture-size=2048",
                                "--margin=3", "--view=both", "--color-by=checkerboard"});
  EXPECT_FALSE(call.parameters.cutTips);
  EXPECT_EQ(call.parameters.tip, 0.8);
  EXPECT_EQ(call.parameters.reliefStretch, 0);
  EXPECT_EQ(call.parameters.unwrap, "circle");
  EXPECT_EQ(call.parameters.layout, "square");
  EXPECT_EQ(call.parameters.textureSize, 2048);
  EXPECT_EQ(call.parameters.margin, 3);
  EXPECT_EQ(call.picture.view, PictureOptions::View::Both);
  EXPECT_EQ(call.picture.settings.colorMode, ColorMode::Checkerboard);
}

TEST(Options, OfTheCamera) {
  const CameraOptions camera =
      read({"--camera-direction", "-1,0.5,0", "--camera-view-angle=40", "--camera-orthographic",
            "--camera-azimuth-angle=-30", "--camera-zoom-factor=2", "--up=+Z"})
          .picture.camera;
  EXPECT_EQ(camera.direction, glm::dvec3(-1, 0.5, 0));
  EXPECT_EQ(camera.viewAngle, 40);
  EXPECT_TRUE(camera.orthographic);
  EXPECT_EQ(camera.azimuthAngle, -30);
  EXPECT_EQ(camera.zoomFactor, 2);
  EXPECT_EQ(camera.up, UpAxis::Z);
}

TEST(Options, OfTheRun) {
  EXPECT_EQ(read({"--seeds=3,0,12"}).seeds, (std::vector<Index>{3, 0, 12}));
  EXPECT_EQ(read({"--steps=100"}).steps, 100u);
  EXPECT_EQ(read({"--iterations=2"}).iterations, 2u);
  EXPECT_EQ(read({"--threads=3"}).threads, 3u);
  EXPECT_EQ(read({"--verbose=debug"}).verbose, LogLevel::Debug);
  EXPECT_EQ(read({"--sample=cube", "--triangles=500"}).triangles, 500u);
  EXPECT_EQ(read({"--rendering-backend=egl"}).renderingBackend, "egl");
}

TEST(OptionRefusal, OfUnknownOptionsNamesTheNearest) {
  EXPECT_EQ(refusal({"--chart=3"}), "There is no option --chart: did you mean --charts?");
  EXPECT_EQ(refusal({"--colour-by=charts"}),
            "There is no option --colour-by: did you mean --color-by?");
  EXPECT_EQ(refusal({"a.obj", "-x"}), "There is no option -x: --help lists all.");
  EXPECT_EQ(refusal({"--xyzzy"}), "There is no option --xyzzy: --help lists all.");
}

TEST(OptionRefusal, OfMissingValues) {
  EXPECT_EQ(refusal({"a.obj", "--charts"}), "--charts needs a value: --charts=N.");
  EXPECT_EQ(refusal({"--charts=", "a.obj"}), "--charts needs a value: --charts=N.");
  EXPECT_EQ(refusal({"--offsets="}), "--offsets= needs a value: --offsets=on or off.");
}

TEST(OptionRefusal, OfSearchesThatAreNone) {
  EXPECT_EQ(read({"--search=fast"}).parameters.search, "fast");
  EXPECT_EQ(refusal({"--search=quick"}).find("--search"), 0u) << refusal({"--search=quick"});
}

TEST(OptionRefusal, OfChartsThatTheProgramCounts) {
  EXPECT_TRUE(read({"a.obj", "--charts=auto", "--report=-"}).findsCharts);
  EXPECT_THAT(refusal({"a.obj", "--charts=auto"}), HasSubstr("needs an output option"));
  EXPECT_THAT(refusal({"a.obj", "--charts=auto", "--steps=4", "--report=-"}),
              HasSubstr("leave --seeds, --steps"));
}

TEST(OptionRefusal, OfValuesThatCannotBe) {
  EXPECT_THAT(refusal({"--range=2,1"}), StartsWith("--range=2,1 is empty"));
  EXPECT_THAT(refusal({"--range=1"}), HasSubstr("MIN,MAX"));
  EXPECT_THAT(refusal({"--range=nan,1"}), HasSubstr("MIN,MAX"));
  EXPECT_THAT(refusal({"--resolution=0,5"}), HasSubstr("out of range"));
  EXPECT_THAT(refusal({"--resolution=100000,5"}), HasSubstr("out of range"));
  EXPECT_THAT(refusal({"--resolution=5"}), HasSubstr("W,H"));
  EXPECT_THAT(refusal({"--resolution=5x5"}), HasSubstr("W,H"));
  EXPECT_THAT(refusal({"--supersampling=3"}), HasSubstr("one of 1, 2, 4"));
  EXPECT_THAT(refusal({"--background=#12"}), StartsWith("--background: "));
  EXPECT_THAT(refusal({"--colormap=viridia"}), HasSubstr("nearest: viridis"));
  EXPECT_THAT(refusal({"--color-by=gaus"}), HasSubstr("nearest: gauss)"));
  EXPECT_THAT(refusal({"--preset=papr"}), HasSubstr("nearest: paper)"));
  EXPECT_THAT(refusal({"--seeds=1,1"}), HasSubstr("twice"));
  EXPECT_THAT(refusal({"--seeds=1,,2"}), HasSubstr("is not a list of faces"));
  EXPECT_THAT(refusal({"--seeds=-1"}), HasSubstr("is not a list of faces"));
  EXPECT_THAT(refusal({"--steps=-1"}), HasSubstr("a whole number"));
  EXPECT_THAT(refusal({"--steps=0"}), HasSubstr("out of range"));
  EXPECT_THAT(refusal({"--iterations=0"}), HasSubstr("out of range"));
  EXPECT_THAT(refusal({"--threads=1000"}), HasSubstr("out of range"));
  EXPECT_THAT(refusal({"--camera-direction=0,0,0"}), HasSubstr("is no direction"));
  EXPECT_THAT(refusal({"--camera-view-angle=0"}), HasSubstr("from 1 to 170"));
  EXPECT_THAT(refusal({"--camera-zoom-factor=nan"}), HasSubstr("is not a number"));
  EXPECT_THAT(refusal({"--up=X"}), HasSubstr("one of auto, +Y, +Z"));
  EXPECT_THAT(refusal({"--verbose=loud"}), HasSubstr("quiet"));
  EXPECT_THAT(refusal({"--output=a.jpg"}), HasSubstr(".png"));
  EXPECT_THAT(refusal({"--report=a.txt"}), HasSubstr(".json"));
  EXPECT_THAT(refusal({"--export-labels=a.json"}), HasSubstr(".txt"));
  EXPECT_EQ(refusal({"--export-mesh=a.fbx"}),
            "--export-mesh=a.fbx cannot be written: give a name that ends in .obj, .ply or .glb.");
  EXPECT_THAT(refusal({"--export-uv=a.jpg"}), HasSubstr(".png or .svg"));
}

TEST(OptionRefusal, OfCombinationsThatCannotBe) {
  EXPECT_THAT(refusal({"a.obj", "b.obj"}), HasSubstr("b.obj is one too many"));
  EXPECT_THAT(refusal({"a.obj", "--sample=cube"}), HasSubstr("exclude each other"));
  EXPECT_THAT(refusal({"a.obj", "--triangles=5"}), HasSubstr("for samples only"));
  EXPECT_THAT(refusal({"--steps=5", "--iterations=5"}), HasSubstr("exclude each other"));
  EXPECT_THAT(refusal({"--output=a.png", "--report=a.png"}), HasSubstr(".json"));
  EXPECT_THAT(refusal({""}), HasSubstr("empty"));
}

TEST(Help, ListsEveryOptionWithItsGroupAndEndsWithExamples) {
  const std::string help = helpText();
  for (const OptionInfo& option : optionTable()) {
    EXPECT_THAT(help, HasSubstr("\n  --" + option.name));
  }
  for (const char* group : {"Segmentation", "Results", "Picture", "Camera", "General"}) {
    EXPECT_THAT(help, HasSubstr("\n" + std::string(group)));
  }
  std::string unbroken = help;
  std::replace(unbroken.begin(), unbroken.end(), '\n', ' ');
  EXPECT_THAT(unbroken, HasSubstr("Reads " + extensionList(FormatReader::Own) + "."));
  EXPECT_THAT(unbroken, HasSubstr("(Assimp), " + extensionList(FormatReader::Library) + "."));
  EXPECT_GT(help.find("Examples"), help.find("--version"));
}

TEST(Help, FitsAHundredColumns) {
  std::istringstream lines(helpText());
  for (std::string line; std::getline(lines, line);) {
    const auto columns = std::count_if(line.begin(), line.end(), [](char c) {
      return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    });
    EXPECT_LE(columns, 100) << line;
  }
}

}  // namespace
}  // namespace chartflood
