#include "app/gui/views/picture_taker.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "app/gui/views/picture_pieces.h"
#include "app/host/files/checker_picture.h"
#include "app/host/files/file_name_template.h"
#include "app/host/film/film_frame.h"
#include "app/host/settings/standard_paths.h"
#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/io/write/file_output.h"
#include "render/passes/offscreen_render.h"
#include "render/scene/image.h"

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

/// How these pieces were made, so that they can be made again.
void note(const AppState& state, std::span<const PicturePiece> pieces, int smooth,
          PictureTaker::Taken& taken) {
  const PicturePiece& first = pieces.front();
  taken.record.view = pieces.size() > 1 ? "both" : first.texture ? "uv" : "3d";
  taken.record.smooth = smooth;
  taken.shown = state.view;
  taken.shown->render = first.look;
  taken.shown->camera = first.camera;
}

/// Charts that will be others in a moment are not what a picture was asked of.
bool awaitsCharts(const AppState& state) {
  return state.preferences.explore && !state.playback.playing() &&
         (state.changing() || state.results().sketch);
}

/// What of the picture a session does not lead back to, as words; "" where all of it is held.
std::string notHeld(const AppState& state) {
  const bool moment = !state.showsFinal() && !state.playback.onWorkersRound();
  if (state.film.ready()) return "the film of the handle";
  if (state.playback.inBorders() || moment) return "this moment of the run";
  if (!state.view.checkerFile.empty()) return "the picture on the charts";
  if (state.view.render.problems && !state.results().flat) return "the marks of problems";
  return "";
}

/// The same for the moments of a flood that is played.
std::string notHeldOfFilm(const AppState& state) {
  const std::string missing = notHeld(state);
  return missing.empty() && !state.playback.onWorkersRound() ? "this moment of the run" : missing;
}

/// What each half of a comparison was made with.
ImageTexts sideTexts(const AppState& state) {
  ImageTexts texts;
  for (const ComparePane& pane : state.compare.panes()) {
    const Document& document =
        pane.live() ? state.document() : state.compare.stored[pane.stored].document;
    texts.emplace_back("Side " + paneName(state.compare, pane),
                       commandLine(state, document, paneResults(state, pane), false));
  }
  return texts;
}

ImageTexts textsOf(const AppState& state, const PictureTaker::Taken& taken, const Image& image) {
  if (!taken.shown) {
    ImageTexts texts = {{"Software", "chartflood " CHARTFLOOD_VERSION},
                        {"Description", commandLine(state, false)}};
    texts.insert(texts.end(), taken.sides.begin(), taken.sides.end());
    return texts;
  }
  const RenderSettings& look = taken.shown->render;
  ViewSettings shown = *taken.shown;
  // A picture names no files of its maker's.
  if (!shown.checkerFile.empty()) dropCheckerPicture(shown);
  PictureRecord record = taken.record;
  record.width = image.width();
  record.height = image.height();
  record.lineScale = static_cast<double>(look.pixelScale);
  if (taken.notHeld.empty()) record.playhead = look.playhead;
  const std::filesystem::path file = state.results().mesh->input().file;
  if (state.modelIsFile()) record.model = file.filename().string();
  return pictureTexts(state.sessionTextLike(shown), record, commandLine(state, false));
}

/// Pixels of lines and letters in a picture of this size.
float lineScale(const PictureExtent& extent, float pixelScale) { return pixelScale * extent.scale; }

/// The view that the settings ask for, and how it was made.
Image drawView(const AppState& state, CompareScene& scene, const PictureRequest& request,
               float pixelScale, PictureTaker::Taken& taken) {
  const PictureSettings& wanted = request.settings;
  const PictureExtent extent = wantedExtent(state, wanted);
  const auto pieces = picturePieces(state, scene, request, extent.width, extent.height,
                                    lineScale(extent, pixelScale));
  const bool sides = wanted.view == "ab" && state.compare.showing();
  if (!sides) note(state, pieces, wanted.smooth, taken);
  return drawPieces(pieces, extent.width, extent.height, wanted.smooth);
}

/// One picture of a row, at its own moment or seen from its own side. The last one of a film shows
/// the charts.
Image drawOfRow(const AppState& state, CompareScene& scene, const PictureRequest& request,
                Camera camera, int number, float pixelScale, PictureTaker::Taken& taken) {
  const PictureSettings& wanted = request.settings;
  const PictureExtent extent = wantedExtent(state, wanted);
  auto pieces = picturePieces(state, scene, request, extent.width, extent.height,
                              lineScale(extent, pixelScale));
  const bool turns = request.row == PictureRequest::Row::Turntable;
  if (turns) camera.orbit(2 * glm::pi<double>() * number / wanted.frames, 0);
  for (PicturePiece& piece : pieces) {
    piece.camera = camera;
    if (turns) continue;
    piece.look.playhead = filmPlayhead(state.playback.recorded(), static_cast<std::size_t>(number),
                                       static_cast<std::size_t>(wanted.frames));
    if (piece.look.playhead) piece.look.problems = false;  // they belong to the finished charts
  }
  note(state, pieces, wanted.smooth, taken);
  return drawPieces(pieces, extent.width, extent.height, wanted.smooth);
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

PictureTaker::PictureTaker(std::function<void()> wake, std::function<Image()> window)
    : wake_(std::move(wake)), window_(std::move(window)) {}

PictureTaker::~PictureTaker() {
  if (writing_.valid()) writing_.wait();
}

void PictureTaker::take(const AppState& state, CompareScene& scene, const PictureRequest& request,
                        float pixelScale) {
  if (request.texture) {
    if (state.results().flat) write(state, request, drawTexture(state, scene), {});
    return;
  }
  scene.catchUp(state);
  Taken taken;
  if (request.settings.view == "window") {
    if (window_) write(state, request, window_(), taken);
    return;
  }
  Image image = drawView(state, scene, request, pixelScale, taken);
  taken.notHeld = notHeld(state);
  if (request.settings.view == "ab") taken.sides = sideTexts(state);
  write(state, request, std::move(image), taken);
}

void PictureTaker::write(const AppState& state, const PictureRequest& request, Image image,
                         const Taken& taken) {
  const ImageTexts texts = textsOf(state, taken, image);
  const std::string model = state.modelName(), mode = colorModeInfo(state.view.render.colorMode).id;
  const std::string missing = taken.shown ? taken.notHeld : "";
  writing_ =
      std::async(std::launch::async, [=, image = std::move(image), wake = wake_]() -> Outcome {
        Outcome outcome;
        try {
          const std::filesystem::path file = targetOf(request, model, mode);
          const std::vector<std::uint8_t> bytes = encodePng(image, texts);
          writeFileAtomically(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
          outcome = {true, "Saved " + file.string()};
          if (!missing.empty()) {
            outcome.sentence += ". It holds charts and view, but not " + missing + '.';
          }
        } catch (const std::exception& failure) {
          outcome = {false, failureSentence(failure)};
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
  } catch (const std::exception& failure) {
    state.notices.add(Notice::Kind::Error, failureSentence(failure));
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
  Taken taken;
  Image image = drawOfRow(state, scene, request, row_->camera, row_->next, pixelScale, taken);
  // The moments of a film belong to the flood that the session knows, the last picture to its end.
  const bool film = row_->request.row == PictureRequest::Row::FloodFilm;
  taken.notHeld = film ? notHeldOfFilm(state) : notHeld(state);
  write(state, request, std::move(image), taken);
}

void PictureTaker::update(AppState& state, CompareScene& scene, float pixelScale) {
  if (row_) return goOn(state, scene, pixelScale);
  auto& waiting = state.requests.pictures;
  while (!waiting.empty() && !row_ && !awaitsCharts(state)) {
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
