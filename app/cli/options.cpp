#include "app/cli/options.h"

#include <algorithm>
#include <tuple>

#include "app/cli/compare_options.h"
#include "app/cli/option_table.h"
#include "app/cli/tokens.h"
#include "app/cli/values.h"
#include "app/host/files/picture_record.h"
#include "app/host/files/session_view.h"
#include "app/host/settings/preferences.h"
#include "app/host/settings/standard_paths.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/mesh_formats.h"
#include "core/samples/samples.h"
#include "render/scene/color_map.h"

namespace chartflood {

namespace {

constexpr std::size_t kLargestCount = 1'000'000'000;
constexpr int kLargestSide = 16384;  // pixels
constexpr std::size_t kMostThreads = 256;

PictureOptions::View viewFromId(const std::string& id) {
  using View = PictureOptions::View;
  return id == "uv" ? View::Uv : id == "both" ? View::Both : View::Model;
}

/// The picture is to be like the one that is the input, unless told otherwise.
void takeRecord(const PictureRecord& record, const ViewSettings& view, PictureOptions& picture) {
  picture.view = viewFromId(record.view);
  picture.width = record.width;
  picture.height = record.height;
  picture.supersampling = record.smooth;
  picture.lineScale = record.lineScale;
  picture.settings.playhead = record.playhead;
  picture.uvCamera = view.uvCamera;
  picture.uv = view.uv;
  picture.backgroundGiven = true;
}

/// A session as input, or a picture that holds one, is what everything else is changed from.
void readSessionInput(const Tokens& tokens, Invocation& call) {
  if (tokens.has("help") || tokens.has("version")) return;
  const bool file = tokens.files.size() == 1;
  const bool like = tokens.has("like");
  const bool picture = file && isPngFile(tokens.files[0]);
  if (like && file && (picture || isSessionFile(tokens.files[0]))) {
    throw UsageError("--like and " + tokens.files[0] +
                     " exclude each other: leave one out, or name a mesh.");
  }
  std::optional<PictureRecord> record;
  if (like || picture) {
    const std::string source = like ? tokens.text("like") : tokens.files[0];
    const std::string model = like && file ? tokens.files[0] : "";
    PictureSource read = readPictureSource(source, model);
    call.session = std::move(read.session);
    record = read.record;
  } else if (file && isSessionFile(tokens.files[0])) {
    call.sessionFile = tokens.files[0];
    call.session = readSession(call.sessionFile);
  } else {
    return;
  }
  call.parameters = call.session->parameters;
  ViewSettings view;
  view.render = call.picture.settings;
  call.warnings = applyViewValues(call.session->view, view, call.session->folder);
  call.picture.settings = view.render;
  call.picture.chartColors = view.chartColors;
  if (record) takeRecord(*record, view, call.picture);
  CameraOptions& camera = call.picture.camera;
  if (!view.frameWhenLoaded) camera.saved = view.camera;
  camera.orthographic = view.camera.orthographic;
  camera.up = view.camera.up;
}

void readParameters(const Tokens& tokens, Invocation& call) {
  if (tokens.has("preset")) {
    std::vector<std::string> names;
    for (const Preset& preset : presetTable()) names.push_back(preset.id);
    std::string ignored;  // settings that the preset does not need
    const Preferences likes = readPreferences(configFolder(), stateFolder(), ignored);
    for (const UserPreset& preset : likes.presets) names.push_back(preset.name);
    const std::string name = readChoice("preset", tokens.text("preset"), names);
    if (const Preset* preset = findPreset(name)) {
      call.parameters = applyPreset(call.parameters, *preset);
    } else {
      std::string warning;
      call.parameters =
          applyUserPreset(call.parameters, *findUserPreset(likes.presets, name), warning);
      if (!warning.empty()) call.warnings.push_back(warning);
    }
  }
  for (const ParameterInfo& info : parameterTable()) {
    if (!tokens.has(info.id)) continue;
    if (std::string_view(info.id) == "charts" && tokens.text(info.id) == "auto") {
      call.findsCharts = true;
      continue;
    }
    setParameterFromText(call.parameters, info, tokens.text(info.id));
  }
  call.chartsGiven = tokens.has("charts");
  if (tokens.has("hints")) call.hints = tokens.text("hints");
}

void readSteps(const Tokens& tokens, Invocation& call) {
  if (tokens.has("seeds")) call.seeds = readFaces("seeds", tokens.text("seeds"));
  if (tokens.has("steps")) call.steps = readCount("steps", tokens.text("steps"), 1, kLargestCount);
  if (tokens.has("iterations")) {
    call.iterations = readCount("iterations", tokens.text("iterations"), 1, kLargestCount);
  }
  if (call.steps && call.iterations) {
    throw UsageError("--steps and --iterations exclude each other: --steps stops within the first "
                     "round.");
  }
}

std::filesystem::path readFileName(const Tokens& tokens, const std::string& option,
                                   const std::vector<std::string>& endings) {
  std::filesystem::path file = tokens.text(option);
  if (!tokens.has(option)) return file;
  const std::string ending = fileEnding(file);
  if (std::find(endings.begin(), endings.end(), ending) != endings.end()) return file;
  throw UsageError("--" + option + "=" + file.string() +
                   " cannot be written: give a name that ends in " + listed(endings, "or") + ".");
}

void readFiles(const Tokens& tokens, Invocation& call) {
  call.output = readFileName(tokens, "output", {".png"});
  call.exportLabels = readFileName(tokens, "export-labels", {".txt"});
  call.exportMesh = readFileName(tokens, "export-mesh", writtenExtensions());
  call.exportUv = readFileName(tokens, "export-uv", {".png", ".svg"});
  call.exportSeams = readFileName(tokens, "export-seams", {".obj"});
  call.saveSession = readFileName(tokens, "save-session", {kSessionEnding});
  if (tokens.has("overwrite")) call.overwrite = readSwitch("overwrite", tokens.text("overwrite"));
  call.report = tokens.text("report");
  if (call.report != "-") readFileName(tokens, "report", {".json"});
}

void readColors(const Tokens& tokens, RenderSettings& settings) {
  // A comparison may show several, see readCompare.
  if (tokens.has("color-by") && !tokens.has("compare")) {
    settings.colorMode =
        findColorMode(readChoice("color-by", tokens.text("color-by"), colorModeIds()))->mode;
  }
  if (tokens.has("colormap")) {
    std::vector<std::string> names;
    for (const ColorMap& map : colorMapTable()) names.push_back(map.id);
    settings.colorMap = readChoice("colormap", tokens.text("colormap"), names);
  }
  if (tokens.has("range")) {
    const auto ends = readNumbers("range", tokens.text("range"), 2, "two numbers, MIN,MAX");
    if (ends[0] >= ends[1]) {
      throw UsageError("--range=" + tokens.text("range") +
                       " is empty: give the smaller number first.");
    }
    settings.range = {ends[0], ends[1]};
  }
}

int readColorSteps(const Tokens& tokens) {
  constexpr std::size_t kMostColors = 32;
  const std::size_t steps = readCount("color-steps", tokens.text("color-steps"), 0, kMostColors);
  if (steps == 1) {
    throw UsageError("--color-steps=1 is a single colour: give 2 to 32, or 0 for a smooth run.");
  }
  return static_cast<int>(steps);
}

/// How values become colours, as the legend of the window has it.
void readLegend(const Tokens& tokens, RenderSettings& settings) {
  if (tokens.has("color-scale")) {
    const std::vector<std::string> scales{"auto", "linear", "root", "log"};
    const std::string id = readChoice("color-scale", tokens.text("color-scale"), scales);
    const ColorMap* own = findColorMap(colorModeInfo(settings.colorMode).colorMap);
    if (id == "log" && own != nullptr && own->diverging) {
      throw UsageError("--color-scale=log has no place for values on both sides of 0: choose auto, "
                       "linear or root.");
    }
    settings.scale.reset();
    if (id == "linear") settings.scale = ScalarScale::Linear;
    if (id == "root") settings.scale = ScalarScale::Root;
    if (id == "log") settings.scale = ScalarScale::Log;
  }
  if (tokens.has("color-steps")) settings.colorSteps = readColorSteps(tokens);
}

void readBackground(const Tokens& tokens, RenderSettings& settings) {
  if (!tokens.has("background")) return;
  try {
    settings.background = backgroundFromText(tokens.text("background"));
  } catch (const UsageError& error) {
    throw UsageError(std::string("--background: ") + error.what());
  }
}

void readOverlays(const Tokens& tokens, RenderSettings& settings) {
  const auto read = [&](const char* option, bool& value) {
    if (tokens.has(option)) value = readSwitch(option, tokens.text(option));
  };
  read("seams", settings.seams);
  read("cuts", settings.cuts);
  read("edges", settings.edges);
  read("sharp-edges", settings.sharpEdges);
  read("problems", settings.problems);
  read("invert-colors", settings.invertColorMap);
  read("clamp-colors", settings.clampColors);
  read("seed-marks", settings.seedMarks);
  read("numbers", settings.numbers);
  read("scalar-bar", settings.scalarBar);
}

double readWithin(const Tokens& tokens, const std::string& option, double least, double most,
                  const std::string& allowed) {
  const double value = readNumber(option, tokens.text(option));
  if (!(value >= least && value <= most)) {
    throw UsageError("--" + option + "=" + tokens.text(option) +
                     " is out of range: give a number " + allowed + ".");
  }
  return value;
}

void readPicture(const Tokens& tokens, PictureOptions& picture) {
  readColors(tokens, picture.settings);
  readLegend(tokens, picture.settings);
  readBackground(tokens, picture.settings);
  picture.backgroundGiven = picture.backgroundGiven || tokens.has("background");
  readOverlays(tokens, picture.settings);
  if (tokens.has("resolution")) {
    std::tie(picture.width, picture.height) =
        readSize("resolution", tokens.text("resolution"), kLargestSide);
  }
  if (tokens.has("supersampling")) {
    const std::vector<std::string> allowed{"1", "2", "4"};
    picture.supersampling =
        readChoice("supersampling", tokens.text("supersampling"), allowed).front() - '0';
  }
  if (tokens.has("line-scale")) {
    picture.lineScale = readWithin(tokens, "line-scale", 0.01, 100, "from 0.01 to 100");
  }
  if (tokens.has("view")) {
    const std::vector<std::string> views{"3d", "uv", "both"};
    const std::string view = readChoice("view", tokens.text("view"), views);
    picture.view = viewFromId(view);
  }
}

void readFrames(const Tokens& tokens, Invocation& call) {
  constexpr std::size_t kMostFrames = 10'000;
  PictureOptions& picture = call.picture;
  const auto read = [&](const char* option, std::size_t& value) {
    if (!tokens.has(option)) return;
    value = readCount(option, tokens.text(option), 2, kMostFrames);
    if (call.output.empty()) {
      throw UsageError(std::string("--") + option +
                       " says how many pictures there are, not where: give --output=F.png, too.");
    }
    if (picture.view == PictureOptions::View::Uv && std::string_view(option) == "turntable") {
      throw UsageError("--turntable turns the model: leave --view=uv out.");
    }
  };
  read("turntable", picture.turntable);
  read("flood-film", picture.floodFilm);
  if (picture.turntable > 0 && picture.floodFilm > 0) {
    throw UsageError("--turntable and --flood-film exclude each other: leave one out.");
  }
}

void readCamera(const Tokens& tokens, CameraOptions& camera) {
  const auto vector = [&](const char* option, std::optional<glm::dvec3>& value, bool direction) {
    if (tokens.has(option)) value = readVector(option, tokens.text(option), direction);
  };
  vector("camera-direction", camera.direction, true);
  vector("camera-view-up", camera.viewUp, true);
  vector("camera-position", camera.position, false);
  vector("camera-focal-point", camera.focalPoint, false);
  if (tokens.has("camera-view-angle")) {
    camera.viewAngle = readWithin(tokens, "camera-view-angle", 1, 170, "from 1 to 170");
  }
  if (tokens.has("camera-zoom-factor")) {
    camera.zoomFactor = readWithin(tokens, "camera-zoom-factor", 1e-3, 1e3, "from 0.001 to 1000");
  }
  if (tokens.has("camera-azimuth-angle")) {
    camera.azimuthAngle = readWithin(tokens, "camera-azimuth-angle", -360, 360, "from -360 to 360");
  }
  if (tokens.has("camera-elevation-angle")) {
    camera.elevationAngle =
        readWithin(tokens, "camera-elevation-angle", -180, 180, "from -180 to 180");
  }
  if (tokens.has("camera-orthographic")) {
    camera.orthographic = readSwitch("camera-orthographic", tokens.text("camera-orthographic"));
  }
  if (tokens.has("up")) {
    const std::vector<std::string> axes{"auto", "+Y", "+Z"};
    const std::string axis = readChoice("up", tokens.text("up"), axes);
    camera.up.reset();
    if (axis != "auto") camera.up = axis == "+Z" ? UpAxis::Z : UpAxis::Y;
  }
  for (const OptionInfo& row : optionTable()) {
    camera.given = camera.given || (row.group == "Camera" && tokens.has(row.name));
  }
  if (camera.direction && camera.position && camera.focalPoint) {
    throw UsageError("--camera-direction, --camera-position and --camera-focal-point together say "
                     "too much: leave one out.");
  }
  if (camera.position && camera.focalPoint && *camera.position == *camera.focalPoint) {
    throw UsageError("--camera-position and --camera-focal-point are the same point: move one.");
  }
}

void readGeneral(const Tokens& tokens, Invocation& call) {
  if (tokens.has("sample")) call.sample = tokens.text("sample");
  if (tokens.has("triangles")) {
    call.triangles = readCount("triangles", tokens.text("triangles"), 1, kMostSampleTriangles);
  }
  if (tokens.has("threads")) {
    call.threads =
        static_cast<unsigned>(readCount("threads", tokens.text("threads"), 0, kMostThreads));
  }
  if (tokens.has("rendering-backend")) {
    const std::vector<std::string> backends{"auto", "osmesa", "egl"};
    call.renderingBackend =
        readChoice("rendering-backend", tokens.text("rendering-backend"), backends);
  }
  if (tokens.has("verbose")) {
    const std::vector<std::string> levels{"debug", "info", "warning", "error", "quiet"};
    const std::string level = readChoice("verbose", tokens.text("verbose"), levels);
    const auto place = std::find(levels.begin(), levels.end(), level) - levels.begin();
    call.verbose = static_cast<LogLevel>(place);
  }
}

/// Gives a row of settings the option's value. \throws UsageError
template <typename Owner>
void readSetting(const Tokens& tokens, const Setting<Owner>& row, Owner& owner) {
  const std::string text = tokens.text(row.id), reason = row.setText(owner, text);
  if (!reason.empty()) {
    throw UsageError("--" + refusalText(row.id, text, reason, row.value.domain));
  }
}

void readWindow(const Tokens& tokens, Invocation& call) {
  Preferences checked;
  for (const Setting<Preferences>& row : preferenceTable()) {
    if (!row.option || !tokens.has(row.id)) continue;
    readSetting(tokens, row, checked);
    call.preferences.emplace_back(row.id, tokens.text(row.id));
  }
}

void readInput(const Tokens& tokens, Invocation& call) {
  if (tokens.files.size() > 1) {
    throw UsageError("Only one file can be opened: " + tokens.files[1] + " is one too many.");
  }
  if (!tokens.files.empty()) {
    if (tokens.files[0].empty()) throw UsageError("The name of the file is empty: give its name.");
    if (tokens.has("sample")) {
      throw UsageError("--sample and " + tokens.files[0] + " exclude each other: leave one out.");
    }
    call.file = tokens.files[0];
  }
  if (!call.file.empty() && tokens.has("triangles")) {
    throw UsageError("--triangles is for samples only: leave it out, or give --sample=NAME.");
  }
  if (call.session) {
    call.file = call.session->model.file;
    if (call.file.empty()) call.sample = call.session->model.sample;
    call.triangles = call.session->model.triangles;
  }
}

/// --charts=auto beside what needs a number. \throws UsageError
void refuseUnfit(const Invocation& call) {
  if (call.task == Invocation::Task::Window) {
    throw UsageError(
        "--charts=auto needs an output option: in the window choose Run, Fewest charts.");
  }
  if (!call.seeds.empty() || call.steps || call.iterations || !call.compare.empty()) {
    throw UsageError("--charts=auto runs to the end with many numbers of charts: leave --seeds, "
                     "--steps, --iterations and --compare out.");
  }
}

/// The first task that is asked for wins in this order: the shorter answer first.
Invocation::Task readTask(const Tokens& tokens, const Invocation& call) {
  using Task = Invocation::Task;
  const std::pair<const char*, Task> tasks[] = {
      {"help", Task::Help},
      {"version", Task::Version},
      {"list-samples", Task::ListSamples},
      {"list-colormaps", Task::ListColormaps},
      {"list-bindings", Task::ListBindings},
      {"info", Task::Info},
  };
  for (const auto& [option, task] : tasks) {
    if (tokens.has(option) && readSwitch(option, tokens.text(option))) return task;
  }
  return outputFiles(call).empty() && call.report.empty() && call.compare.empty() ? Task::Window
                                                                                  : Task::Batch;
}

}  // namespace

std::vector<std::filesystem::path> outputFiles(const Invocation& call) {
  std::vector<std::filesystem::path> files{call.output,   call.exportLabels, call.exportMesh,
                                           call.exportUv, call.exportSeams,  call.saveSession};
  if (call.report != "-") files.emplace_back(call.report);
  std::erase_if(files, [](const std::filesystem::path& file) { return file.empty(); });
  return files;
}

Invocation readOptions(std::span<const std::string> words) {
  const Tokens tokens = readTokens(words, optionTable());
  Invocation call;
  readSessionInput(tokens, call);
  readParameters(tokens, call);
  readSteps(tokens, call);
  readFiles(tokens, call);
  readPicture(tokens, call.picture);
  readCompare(tokens, call);
  readFrames(tokens, call);
  readCamera(tokens, call.picture.camera);
  readGeneral(tokens, call);
  readWindow(tokens, call);
  readInput(tokens, call);
  call.task = readTask(tokens, call);
  if (call.findsCharts) refuseUnfit(call);
  return call;
}

}  // namespace chartflood
