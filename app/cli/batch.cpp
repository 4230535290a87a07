#include "app/cli/batch.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "app/cli/camera_options.h"
#include "app/cli/info.h"
#include "app/cli/picture.h"
#include "app/cli/run_session.h"
#include "app/cli/values.h"
#include "app/host/files/export_files.h"
#include "app/host/files/session_view.h"
#include "core/base/error.h"
#include "core/base/process_memory.h"
#include "core/io/write/file_output.h"
#include "core/io/write/write_labels.h"
#include "core/io/write/write_report.h"
#include "core/session/pipeline/make_report.h"

namespace chartflood {

namespace {

std::string report(const Session& session) {
  Report report =
      makeReport(*session.results(), seedFaces(session.document().seeds), CHARTFLOOD_VERSION);
  report.peakMemoryBytes = peakMemoryBytes();
  return reportText(report);
}

std::string pictureBytes(const Results& results, const Invocation& call) {
  const Image image = drawPicture(results, call.picture, call.renderingBackend);
  const auto bytes = encodePng(image, pictureTexts(results));
  return {bytes.begin(), bytes.end()};
}

/// "out_007.png" for "out.png": numbers with as many digits as the last one has, 3 at least.
std::filesystem::path frameName(const std::filesystem::path& file, std::size_t number,
                                std::size_t count) {
  std::string digits = std::to_string(number);
  const std::size_t width = std::max<std::size_t>(3, std::to_string(count).size());
  digits.insert(0, width - std::min(width, digits.size()), '0');
  std::filesystem::path name = file;
  name.replace_filename(file.stem().string() + '_' + digits + file.extension().string());
  return name;
}

/// The picture, or every picture of a turntable or of a flood.
void stagePictures(const Results& results, const Invocation& call, std::vector<StagedFile>& files) {
  const std::size_t count = std::max(call.picture.turntable, call.picture.floodFilm);
  if (count == 0) {
    files.emplace_back(call.output, pictureBytes(results, call));
    return;
  }
  const ImageTexts texts = pictureTexts(results);
  drawFrames(results, call.picture, call.renderingBackend, [&](std::size_t i, const Image& image) {
    const auto bytes = encodePng(image, texts);
    files.emplace_back(frameName(call.output, i + 1, count),
                       std::string(bytes.begin(), bytes.end()));
    throwIfInterrupted();
  });
}

/// The texture, as SVG or as a picture by the name's ending.
std::string uvBytes(const Results& results, const Invocation& call) {
  const RenderSettings& look = call.picture.settings;
  if (fileEnding(call.exportUv) == ".svg")
    return exportedUvSvg(results, look.palette, call.picture.chartColors);
  const Image image = drawTexture(results, call.picture, call.renderingBackend);
  const auto bytes = encodePng(image, pictureTexts(results));
  return {bytes.begin(), bytes.end()};
}

std::string savedSession(const Session& session, const Invocation& call) {
  const std::shared_ptr<const Results> results = session.results();
  const SessionModel model{call.file, results->checksum, call.file.empty() ? call.sample : "",
                           call.triangles};
  SessionFile saved = sessionOf(model, session.document(), *results);
  const PictureOptions& picture = call.picture;
  ViewSettings view;
  if (call.session) {  // what no option turns
    applyViewValues(call.session->view, view, call.session->folder);
  }
  view.render = picture.settings;
  view.camera = cameraFromOptions(*results->mesh, picture.camera,
                                  static_cast<double>(picture.width) / picture.height);
  // Without a camera of its own the model is framed where it is opened.
  view.frameWhenLoaded = !picture.camera.given && !picture.camera.saved;
  saved.view = viewValues(view);
  if (call.session) saved.unknown = call.session->unknown;
  return sessionText(saved, call.saveSession);
}

/// All files wait beside their targets before the first one is put in place.
void writeOutputs(const Session& session, const Invocation& call) {
  const std::shared_ptr<const Results> results = session.results();
  std::vector<StagedFile> files;
  if (!call.output.empty()) stagePictures(*results, call, files);
  throwIfInterrupted();
  if (!call.exportLabels.empty()) {
    files.emplace_back(call.exportLabels, labelsText(*results->mesh, results->segmentation->label));
  }
  if (!call.exportMesh.empty()) {
    files.emplace_back(call.exportMesh, exportedMesh(*results, call.exportMesh));
  }
  if (!call.exportUv.empty()) files.emplace_back(call.exportUv, uvBytes(*results, call));
  if (!call.exportSeams.empty()) files.emplace_back(call.exportSeams, exportedSeams(*results));
  if (!call.saveSession.empty()) {
    files.emplace_back(call.saveSession, savedSession(session, call));
  }
  if (!call.report.empty() && call.report != "-") files.emplace_back(call.report, report(session));
  throwIfInterrupted();
  commitAll(files);
  if (call.report == "-") printOutput(report(session));
}

/// Pictures, which hold where their charts came from, and sessions need the log of the last flood.
FloodLogs neededLogs(const Invocation& call) {
  const bool last = !call.output.empty() || !call.exportUv.empty() || !call.saveSession.empty() ||
                    call.session || call.steps;
  return last ? FloodLogs::LastRound : FloodLogs::None;
}

}  // namespace

void checkTargets(const Invocation& call) {
  for (const std::filesystem::path& file : outputFiles(call)) {
    const bool input = isSameFile(file, call.file) || isSameFile(file, call.hints);
    if (input && !call.overwrite) {
      throw UsageError(file.string() + " is what the results are made from, and not all of it is "
                                       "in them: give another name, or --overwrite.");
    }
    StagedFile(file, "");
  }
}

void printOutput(std::string_view text) {
  const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
  if (written != text.size() || std::fflush(stdout) != 0) {
    throw WriteError("standard output", "it takes no more text");
  }
}

void runBatch(const Invocation& call) {
  catchInterruptions(removeStagedFiles);
  returnLargeBlocks();
  checkTargets(call);
  Session session(Session::Worker::Threaded);
  session.setFloodLogs(neededLogs(call));
  openInput(session, call);
  segment(session, call);
  unwrap(session, call);
  writeOutputs(session, call);
}

void runInfo(const Invocation& call) {
  catchInterruptions(removeStagedFiles);
  Session session(Session::Worker::Threaded);
  openInput(session, call);
  printOutput(infoText(*session.results()));
}

}  // namespace chartflood
