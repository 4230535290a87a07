#include "app/gui/picture_taker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <system_error>
#include <utility>

#include "app/gui/uv_view.h"
#include "app/host/file_name_template.h"
#include "app/host/standard_paths.h"
#include "core/base/error.h"
#include "render/image.h"
#include "render/offscreen_render.h"

namespace chartflood {

namespace {

/// Without helpers: the model alone.
void strip(RenderSettings& settings) {
  settings.background.transparent = true;
  settings.scalarBar = settings.seedMarks = settings.numbers = false;
  settings.selectedCharts.clear();
}

/// The charts in the texture, pixel by pixel as a texture image has them.
Image drawTexture(const AppState& state, CompareScene& scene) {
  RenderSettings settings = sceneSettings(state, 1);
  strip(settings);
  settings.numbers = state.view.render.numbers;
  settings.hoverFace = kNone;
  const int side = state.results().atlas->textureSize;
  settings.pixelScale = std::max(0.5f, static_cast<float>(side) / 1024);
  return renderUvImage(scene.live().renderer(), UvCamera::exact(), settings, {.frame = false},
                       {.width = side, .height = side, .supersampling = 2});
}

/// The settings of a picture of one view: nothing that the mouse points at.
RenderSettings pictureLook(const PictureRequest& request, RenderSettings settings) {
  settings.hoverFace = settings.hoverChart = kNone;
  if (request.bare) settings.selectedCharts.clear();
  applyPicture(request.settings, settings);
  return settings;
}

void copyInto(const Image& from, int left, Image& to) {
  for (int y = 0; y < from.height(); ++y) {
    std::copy_n(&from.at(0, y), from.width(), &to.at(left, y));
  }
}

/// All halves side by side, or the first two left and right of the wipe's line.
Image drawSides(const AppState& state, CompareScene& scene, const PictureRequest& request,
                const PictureSize& size, float pixelScale) {
  const std::vector<ComparePane> panes = state.compare.panes();
  const bool wipe = state.compare.layout == Compare::Layout::Wipe;
  const int line = static_cast<int>(std::lround(state.compare.wipe * size.width));
  const auto count = static_cast<int>(panes.size());
  Image image(size.width, size.height);
  for (int i = 0; i < count; ++i) {
    const ComparePane pane = panes[static_cast<std::size_t>(i)];
    SceneView& view = scene.view(state, pane);
    const RenderSettings look = pictureLook(request, view.settings(state, pixelScale));
    const Camera camera = paneCamera(state, pane);
    const int left = wipe ? 0 : size.width * i / count;
    PictureSize part = size;
    if (!wipe) part.width = size.width * (i + 1) / count - left;
    const Image drawn = renderImage(view.renderer(), camera, look, part);
    if (!wipe) {
      copyInto(drawn, left, image);
      continue;
    }
    for (int y = 0; y < size.height; ++y) {
      const int from = i == 0 ? 0 : line, to = i == 0 ? line : size.width;
      std::copy_n(&drawn.at(0, y) + from, to - from, &image.at(0, y) + from);
    }
  }
  return image;
}

/// The view that the settings ask for. Without charts laid flat, or nothing stored, the model.
Image drawView(const AppState& state, CompareScene& scene, const PictureRequest& request,
               float pixelScale) {
  const PictureSettings& wanted = request.settings;
  SceneView& live = scene.live();
  const PictureExtent extent =
      pictureExtent(wanted, state.panels.viewWidth, state.panels.viewHeight);
  const PictureSize size{
      .width = extent.width, .height = extent.height, .supersampling = wanted.smooth};
  const float scale = pixelScale * extent.scale;
  if (wanted.view == "ab" && state.compare.showing()) {
    return drawSides(state, scene, request, size, scale);
  }
  live.prepare(state);
  const RenderSettings look = pictureLook(request, sceneSettings(state, scale));
  const bool flat = live.renderer().hasUv();
  RenderSettings texture = pictureLook(request, uvSettings(state, scale));
  if (wanted.view == "uv" && flat) {
    return renderUvImage(live.renderer(), state.view.uvCamera, texture, state.view.uv, size);
  }
  if (wanted.view == "both" && flat) {
    return renderBothImage(live.renderer(), state.view.camera, state.view.uvCamera, look,
                           state.view.uv, size);
  }
  return renderImage(live.renderer(), state.view.camera, look, size);
}

std::filesystem::path targetOf(const PictureRequest& request, const std::string& model,
                               const std::string& mode) {
  if (!request.file.empty()) return request.file;
  const PictureSettings& settings = request.settings;
  const std::filesystem::path folder =
      settings.folder.empty() ? picturesFolder() : std::filesystem::path(settings.folder);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw WriteError(folder.string(), error.message());
  std::string pattern = settings.name.empty() ? PictureSettings{}.name : settings.name;
  if (!pattern.ends_with(".png")) pattern += ".png";
  return freeFileName(folder, pattern, model, mode);
}

}  // namespace

PictureTaker::PictureTaker(std::function<void()> wake) : wake_(std::move(wake)) {}

PictureTaker::~PictureTaker() {
  if (writing_.valid()) writing_.wait();
}

void PictureTaker::take(const AppState& state, CompareScene& scene, const PictureRequest& request,
                        float pixelScale) {
  if (request.texture) {
    if (state.results().flat) write(state, request, drawTexture(state, scene));
    return;
  }
  write(state, request, drawView(state, scene, request, pixelScale));
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

void PictureTaker::update(AppState& state, CompareScene& scene, float pixelScale) {
  for (const PictureRequest& request : std::exchange(state.requests.pictures, {})) {
    if (writing_.valid()) report(state);  // names are given out one after the other
    take(state, scene, request, pixelScale);
  }
  const bool done =
      writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  if (done) report(state);
}

}  // namespace chartflood
