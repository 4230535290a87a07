#include "app/gui/picture_taker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <system_error>
#include <utility>

#include <glm/gtc/constants.hpp>

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
  settings.hoverFace = settings.hoverChart = settings.flashFace = kNone;
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

/// True when a session leads to what is shown: it holds no earlier rounds, no borders on their way,
/// no marks and no picture on the checkerboard.
bool comesBack(const AppState& state) {
  if (state.film.ready() || state.playback.inBorders() || state.view.render.problems) return false;
  if (!state.view.checkerFile.empty()) return false;
  return state.showsFinal() || state.playback.onWorkersRound();
}

ImageTexts textsOf(const AppState& state, const PictureTaker::Taken& taken, const Image& image) {
  if (!taken.look) {
    return {{"Software", "chartflood " CHARTFLOOD_VERSION},
            {"Description", commandLine(state, false)}};
  }
  ViewSettings shown = state.view;
  shown.render = *taken.look;
  PictureRecord record = taken.record;
  record.width = image.width();
  record.height = image.height();
  record.lineScale = static_cast<double>(taken.look->pixelScale);
  record.playhead = taken.look->playhead;
  const std::filesystem::path file = state.results().mesh->input().file;
  if (state.modelIsFile()) record.model = file.filename().string();
  return pictureTexts(state.sessionTextLike(shown), record, commandLine(state, false));
}

/// The view that the settings ask for. Without charts laid flat, or nothing stored, the model.
Image drawView(const AppState& state, CompareScene& scene, const PictureRequest& request,
               float pixelScale, PictureTaker::Taken& taken) {
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
  texture.textSize = look.textSize;  // letters are as large in all pictures
  taken.record.smooth = wanted.smooth;
  taken.look = look;
  if (wanted.view == "uv" && flat) {
    taken.record.view = "uv";
    taken.look = texture;
    return renderUvImage(live.renderer(), state.view.uvCamera, texture, state.view.uv, size);
  }
  if (wanted.view == "both" && flat) {
    taken.record.view = "both";
    return renderBothImage(live.renderer(), state.view.camera, state.view.uvCamera, look,
                           state.view.uv, size);
  }
  return renderImage(live.renderer(), state.view.camera, look, size);
}

/// Moment and camera of one picture of a row. The last one of a film shows the charts.
Image drawOfRow(const AppState& state, CompareScene& scene, const PictureRequest& request,
                Camera camera, int number, float pixelScale) {
  const PictureSettings& wanted = request.settings;
  SceneView& live = scene.live();
  live.prepare(state);
  const PictureExtent extent =
      pictureExtent(wanted, state.panels.viewWidth, state.panels.viewHeight);
  const PictureSize size{
      .width = extent.width, .height = extent.height, .supersampling = wanted.smooth};
  const float scale = pixelScale * extent.scale;
  RenderSettings look = pictureLook(request, sceneSettings(state, scale));
  RenderSettings texture = pictureLook(request, uvSettings(state, scale));
  if (request.row == PictureRequest::Row::Turntable) {
    camera.orbit(2 * glm::pi<double>() * number / wanted.frames, 0);
  } else {
    look.playhead.reset();
    if (number + 1 < wanted.frames) {
      const double share = static_cast<double>(number) / (wanted.frames - 1);
      look.playhead =
          static_cast<std::size_t>(share * static_cast<double>(state.playback.recorded()));
    }
    texture.playhead = look.playhead;
  }
  const bool flat = live.renderer().hasUv();
  if (wanted.view == "uv" && flat) {
    return renderUvImage(live.renderer(), state.view.uvCamera, texture, state.view.uv, size);
  }
  if (wanted.view == "both" && flat) {
    return renderBothImage(live.renderer(), camera, state.view.uvCamera, look, state.view.uv, size);
  }
  return renderImage(live.renderer(), camera, look, size);
}

std::filesystem::path folderOf(const PictureSettings& settings) {
  return settings.folder.empty() ? picturesFolder() : std::filesystem::path(settings.folder);
}

const char* rowName(PictureRequest::Row row) {
  return row == PictureRequest::Row::Turntable ? "turntable" : "flood";
}

std::filesystem::path targetOf(const PictureRequest& request, const std::string& model,
                               const std::string& mode) {
  if (!request.file.empty()) return request.file;
  const PictureSettings& settings = request.settings;
  const std::filesystem::path folder = folderOf(settings);
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
    if (state.results().flat) write(state, request, drawTexture(state, scene), {});
    return;
  }
  Taken taken;
  Image image = drawView(state, scene, request, pixelScale, taken);
  if (!comesBack(state)) taken.look.reset();
  write(state, request, std::move(image), taken);
}

void PictureTaker::write(const AppState& state, const PictureRequest& request, Image image,
                         const Taken& taken) {
  const ImageTexts texts = textsOf(state, taken, image);
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

void PictureTaker::beginRow(AppState& state, const PictureRequest& request) {
  const PictureSettings& settings = request.settings;
  const std::string model = state.modelName();
  try {
    const std::filesystem::path folder =
        freeFileName(folderOf(settings), std::string("{model}_") + rowName(request.row), model, "");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw WriteError(folder.string(), error.message());
    row_ = Row{request, state.view.camera, state.sharedResults(), folder, 0};
    state.pictureRow = {request.row, 0, settings.frames};
    state.requests.stopPictures = false;
  } catch (const Error& error) {
    state.notices.add(Notice::Kind::Error, error.what());
  }
}

/// Says what became of the row: all pictures, or why there are no more.
void PictureTaker::endRow(AppState& state, const std::string& why) {
  const int taken = row_->next;
  const std::string folder = row_->folder.string();
  const std::string number = std::to_string(taken);
  if (why.empty()) {
    state.notices.add(Notice::Kind::Info, "Saved " + number + " pictures in " + folder);
  } else {
    state.notices.add(Notice::Kind::Warning, why + " " + number + " of " +
                                                 std::to_string(row_->request.settings.frames) +
                                                 " pictures are in " + folder);
  }
  row_.reset();
  state.pictureRow = {};
}

/// The next picture of the row, when the last one is written.
void PictureTaker::goOn(AppState& state, CompareScene& scene, float pixelScale) {
  if (writing_.valid()) {
    if (writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    const Outcome outcome = writing_.get();
    if (!outcome.written) return endRow(state, outcome.sentence);
    state.pictureRow.done = ++row_->next;
  }
  if (row_->next == row_->request.settings.frames) return endRow(state, "");
  if (std::exchange(state.requests.stopPictures, false)) return endRow(state, "Stopped.");
  const Results &now = state.results(), &then = *row_->results;
  if (now.segmentation != then.segmentation || now.record != then.record) {
    return endRow(state, "Stopped, because the charts changed.");
  }
  PictureRequest request = row_->request;
  std::string digits = std::to_string(row_->next + 1);
  const std::size_t width =
      std::max<std::size_t>(3, std::to_string(row_->request.settings.frames).size());
  digits.insert(0, width - std::min(width, digits.size()), '0');
  request.file = row_->folder / (row_->folder.filename().string() + '_' + digits + ".png");
  write(state, request, drawOfRow(state, scene, request, row_->camera, row_->next, pixelScale), {});
}

void PictureTaker::update(AppState& state, CompareScene& scene, float pixelScale) {
  if (row_) return goOn(state, scene, pixelScale);
  auto& waiting = state.requests.pictures;
  while (!waiting.empty() && !row_) {
    const PictureRequest request = waiting.front();
    waiting.erase(waiting.begin());
    if (writing_.valid()) report(state);  // names are given out one after the other
    if (request.row == PictureRequest::Row::Single) {
      take(state, scene, request, pixelScale);
    } else {
      beginRow(state, request);
    }
  }
  if (row_) return goOn(state, scene, pixelScale);
  const bool done =
      writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  if (done) report(state);
}

}  // namespace chartflood
