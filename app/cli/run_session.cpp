#include "app/cli/run_session.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include <unistd.h>

#include "core/base/log.h"
#include "core/base/spelling.h"
#include "core/io/read/read_hints.h"
#include "core/samples/samples.h"
#include "core/session/pipeline/run_set.h"

namespace chartflood {

namespace {

/// One line on standard error that is written over; nothing unless that is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) != 0) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() {
    if (drawn_) std::fputs("\r\033[K", stderr);
  }
  void show(const WorkStatus& status) {
    constexpr double kSilentSeconds = 0.3;
    if (!shown_ || status.seconds < kSilentSeconds) return;
    std::fprintf(stderr, "\r\033[K%s %.0f %%", status.phase,
                 100.0 * static_cast<double>(status.fraction));
    std::fflush(stderr);
    drawn_ = true;
  }

 private:
  bool shown_ = false;
  bool drawn_ = false;
};

/// Passes on what the session says. \throws Error for what failed
void passNotices(Session& session) {
  for (const Notice& notice : session.takeNotices()) {
    if (notice.kind == Notice::Kind::Error) throw Error(notice.text);
    const bool warning = notice.kind == Notice::Kind::Warning;
    logMessage(warning ? LogLevel::Warning : LogLevel::Info, notice.text);
  }
}

}  // namespace

void waitForSession(Session& session, const Invocation& call) {
  {
    ProgressLine line(call.verbose < LogLevel::Quiet);
    for (WorkStatus status = session.status(); status.busy; status = session.status()) {
      if (interrupted()) session.stop();
      line.show(status);
      std::this_thread::sleep_for(std::chrono::milliseconds(status.seconds < 0.1 ? 1 : 20));
    }
    session.waitIdle();
  }
  throwIfInterrupted();
  passNotices(session);
}

namespace {

void checkSample(const std::string& name) {
  std::vector<std::string> names;
  for (const SampleInfo& sample : sampleTable()) names.push_back(sample.id);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  const std::string near = nearestSpelling(name, names);
  throw UsageError("There is no sample " + name + ": " +
                   (near.empty() ? "--list-samples names all." : "did you mean " + near + "?"));
}

/// Faces of the mesh for faces of the input file.
std::vector<Index> meshFaces(const Mesh& mesh, const std::vector<Index>& inputFaces) {
  std::vector<Index> faces;
  for (const Index wanted : inputFaces) {
    const Index face = meshFace(mesh, wanted);
    if (face == kNone) {
      throw UsageError("--seeds names face " + std::to_string(wanted) +
                       ", which the mesh does not have: give faces from 0 to " +
                       std::to_string(mesh.input().faceCount() - 1) + " that were not dropped.");
    }
    faces.push_back(face);
  }
  return faces;
}

/// Whether the charts of the session are wanted as they were: nothing was asked for that would make
/// others.
bool keepsCharts(const Invocation& call) {
  Stage stage;
  const bool changed = firstDifference(call.parameters, call.session->parameters, stage);
  return !(changed && stage <= Stage::Refine) && call.seeds.empty() && call.hints.empty() &&
         call.parameters.bestOf == call.session->parameters.bestOf && !call.findsCharts &&
         !call.steps && !call.iterations;
}

/// Seeds and charts of the session that is the input. True when its charts are there again.
bool takeSession(Session& session, const Invocation& call) {
  const auto warn = [](const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) logMessage(LogLevel::Warning, sentence);
  };
  warn(call.warnings);
  if (!call.session) return false;
  const auto results = session.results();
  SessionContent content = sessionContent(*call.session, *results->mesh, results->checksum);
  warn(call.session->warnings);
  warn(content.warnings);
  if (!call.seeds.empty()) return false;
  Document document{call.parameters, content.document.seeds, content.document.hints};
  document = withFittingSeeds(content.document, document);
  const bool again = keepsCharts(call) && !content.moment.start.seeds.empty();
  if (again) {
    session.restore(document, content.moment);
  } else {
    session.setDocument(document, Session::Answer::Nothing);
  }
  waitForSession(session, call);
  return again;
}

void placeSeeds(Session& session, const Invocation& call) {
  if (call.seeds.empty()) return;
  Document document = session.document();
  document.seeds.clear();
  for (const Index face : meshFaces(*session.results()->mesh, call.seeds)) {
    document.seeds.push_back({face});
  }
  const int count = static_cast<int>(document.seeds.size());
  if (!call.chartsGiven) askCharts(document.parameters, count);
  if (document.parameters.charts < count) {
    throw UsageError("--seeds names " + std::to_string(count) +
                     " faces, but --charts=" + std::to_string(document.parameters.charts) +
                     " asks for fewer charts: leave --charts out or raise it.");
  }
  session.setDocument(document, Session::Answer::Nothing);
  waitForSession(session, call);
}

void takeHints(Session& session, const Invocation& call) {
  if (call.hints.empty()) return;
  Document document = session.document();
  document.hints = readHints(call.hints, *session.results()->mesh);
  session.setDocument(document, Session::Answer::Nothing);
  waitForSession(session, call);
}

/// Looks for the number of charts and makes it the document's. True when its charts are there.
bool findChartCount(Session& session, const Invocation& call) {
  if (!call.findsCharts) return false;
  session.findChartCount();
  waitForSession(session, call);
  const std::shared_ptr<const RunSet> set = session.results()->chartRuns;
  const Run& chosen = set->runs[set->chosen];
  Document document = session.document();
  askCharts(document.parameters, chosen.parameters.charts);
  document.parameters.reliefStretch = chosen.parameters.reliefStretch;
  const bool again = document.parameters.bestOf > 1;  // generator seeds are tried for that number
  if (again) {
    session.setDocument(document, Session::Answer::Nothing);
  } else {
    session.restore(document, chosen.moment);
  }
  waitForSession(session, call);
  return !again;
}

/// The option that cannot do without flat charts; "" when there is none.
std::string needsFlatCharts(const Invocation& call) {
  if (!call.exportMesh.empty()) return "--export-mesh";
  if (!call.exportUv.empty()) return "--export-uv";
  if (!call.exportSeams.empty()) return "--export-seams";
  if (call.output.empty()) return "";
  if (call.picture.view != PictureOptions::View::Model) return "--view";
  return needsUnwrap(call.picture.settings.colorMode) ? "--color-by" : "";
}

}  // namespace

void openInput(Session& session, const Invocation& call) {
  Document document;
  document.parameters = call.parameters;
  session.setDocument(document, Session::Answer::Nothing);
  if (call.file.empty()) {
    checkSample(call.sample);
    session.openSample(call.sample, call.triangles);
  } else {
    session.open(call.file);
  }
  waitForSession(session, call);
  if (!session.results()->mesh) throw Error("Nothing was loaded.");
}

void segment(Session& session, const Invocation& call) {
  if (takeSession(session, call)) return;
  takeHints(session, call);
  if (findChartCount(session, call)) return;
  placeSeeds(session, call);
  if (call.steps) {
    session.step(StepUnit::Face, std::min(*call.steps, session.results()->mesh->faceCount()));
  } else if (call.iterations) {
    session.step(StepUnit::Flood, *call.iterations);
  } else {
    session.step(StepUnit::Converged);
  }
  waitForSession(session, call);
}

void unwrap(Session& session, const Invocation& call) {
  const std::string needed = needsFlatCharts(call);
  if (needed.empty() && call.output.empty() && call.report.empty()) return;
  if (session.results()->segmentation->complete) {
    session.unwrap();
    waitForSession(session, call);
  } else if (!needed.empty()) {
    throw Error(needed + " needs complete charts: leave --steps out.");
  }
}

}  // namespace chartflood
