#include "app/gui/picture_taker.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "app/host/file_name_template.h"
#include "app/host/standard_paths.h"
#include "core/base/error.h"
#include "render/image.h"
#include "render/offscreen_render.h"

namespace chartflood {

namespace {

constexpr const char* kNameTemplate = "{model}_{mode}_{n:3}.png";

/// Without helpers: the model alone.
void strip(RenderSettings& settings) {
  settings.background.transparent = true;
  settings.scalarBar = settings.seedMarks = settings.numbers = false;
  settings.selectedCharts.clear();
}

/// The charts in the texture, pixel by pixel as a texture image has them.
Image drawTexture(const AppState& state, SceneView& scene) {
  RenderSettings settings = sceneSettings(state, 1);
  strip(settings);
  settings.numbers = state.view.render.numbers;
  settings.hoverFace = kNone;
  const int side = state.results().atlas->textureSize;
  settings.pixelScale = std::max(0.5f, static_cast<float>(side) / 1024);
  return renderUvImage(scene.renderer(), UvCamera::exact(), settings, {.frame = false},
                       {.width = side, .height = side, .supersampling = 2});
}

std::filesystem::path targetOf(const PictureRequest& request, const std::string& model,
                               const std::string& mode) {
  if (!request.file.empty()) return request.file;
  const std::filesystem::path folder = picturesFolder();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw WriteError(folder.string(), error.message());
  return freeFileName(folder, kNameTemplate, model, mode);
}

}  // namespace

PictureTaker::PictureTaker(std::function<void()> wake) : wake_(std::move(wake)) {}

PictureTaker::~PictureTaker() {
  if (writing_.valid()) writing_.wait();
}

void PictureTaker::take(const AppState& state, SceneView& scene, const PictureRequest& request,
                        float pixelScale) {
  if (request.texture) {
    if (state.results().flat) write(state, request, drawTexture(state, scene));
    return;
  }
  RenderSettings settings = sceneSettings(state, pixelScale * static_cast<float>(request.scale));
  settings.hoverFace = kNone;
  if (request.bare) strip(settings);
  PictureSize size;
  size.width = scene.width() * request.scale;
  size.height = scene.height() * request.scale;
  write(state, request, renderImage(scene.renderer(), state.view.camera, settings, size));
}

void PictureTaker::write(const AppState& state, const PictureRequest& request, Image image) {
  ImageTexts texts = {{"Software", "chartflood " CHARTFLOOD_VERSION},
                      {"Description", commandLine(state)}};
  const std::string model = state.modelName(), mode = colorModeInfo(state.view.render.colorMode).id;
  writing_ =
      std::async(std::launch::async, [=, image = std::move(image), wake = wake_]() -> Outcome {
        Outcome outcome;
        try {
          const std::filesystem::path file = targetOf(request, model, mode);
          writePng(image, file, texts);
          outcome = {true, "Saved " + file.string()};
        } catch (const Error& error) {
          outcome = {false, error.what()};
        }
        wake();
        return outcome;
      });
}

void PictureTaker::report(AppState& state) {
  const Outcome outcome = writing_.get();
  state.notices.add(outcome.written ? Notice::Kind::Info : Notice::Kind::Error, outcome.sentence);
}

void PictureTaker::update(AppState& state, SceneView& scene, float pixelScale) {
  for (const PictureRequest& request : std::exchange(state.requests.pictures, {})) {
    if (writing_.valid()) report(state);  // names are given out one after the other
    take(state, scene, request, pixelScale);
  }
  const bool done =
      writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  if (done) report(state);
}

}  // namespace chartflood
