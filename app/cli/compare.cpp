#include "app/cli/compare.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/batch.h"
#include "app/cli/comparison_text.h"
#include "app/cli/picture.h"
#include "app/cli/run_session.h"
#include "app/cli/side_by_side.h"
#include "core/base/error.h"
#include "core/base/process_memory.h"
#include "core/io/write/file_output.h"
#include "core/io/write/write_report.h"
#include "core/session/pipeline/compared_methods.h"
#include "core/session/pipeline/make_report.h"

namespace chartflood {

namespace {

using ResultsPtr = std::shared_ptr<const Results>;

/// One method with borders finished in one way.
struct MethodRun {
  ResultsPtr shown;  ///< unwrapped as the call asks
  ComparisonRow row;
};

/// Lays the present charts flat with the outline. Where nobody looks at the texture, each chart
/// goes into a square of its own: packing takes longer than all the rest.
ResultsPtr laidFlat(Session& session, const Invocation& call, const std::string& outline,
                    bool shown) {
  Document document = session.document();
  document.parameters.unwrap = outline;
  document.parameters.layout = shown ? call.parameters.layout : "square";
  session.setDocument(document, Session::Answer::Nothing);
  session.unwrap();
  waitForSession(session, call);
  ResultsPtr results = session.results();
  if (!results->flat) throw Error("The charts could not be laid flat.");
  return results;
}

/// \param shown by picture and report, unwrapped as the call asks
MethodRun measured(Session& session, const Invocation& call, bool alike, bool shown) {
  const auto reported = [](const Results& results) {
    return makeReport(results, {}, CHARTFLOOD_VERSION).results.front();
  };
  const bool showsCircle = call.parameters.unwrap == "circle";
  const ResultsPtr circle = laidFlat(session, call, "circle", showsCircle && shown);
  const ResultsPtr free = laidFlat(session, call, "free", !showsCircle && shown);
  const ResultReport onCircle = reported(*circle), outlined = reported(*free);
  MethodRun run;
  run.shown = showsCircle ? circle : free;
  ComparisonRow& row = run.row;
  row.method = onCircle.method;
  row.alike = alike;
  row.charts = onCircle.charts;
  const GaussReport& gauss = onCircle.gaussArea;
  row.gaussStdEq3 = gauss.stdEq3.value_or(0);
  if (gauss.stdOverMean) row.gaussStdOverMean = row.gaussStdEq3 / *gauss.mean;
  if (onCircle.stretch) {
    const Spread& l2 = onCircle.stretch->l2;
    row.circleMean = l2.mean;
    row.circleStd = l2.std;
    row.circleMedian = l2.median;
    row.circleMax = l2.max;
  }
  if (outlined.stretch) {
    row.freeMean = outlined.stretch->l2.mean;
    row.freeMax = outlined.stretch->l2.max;
  }
  row.seamLengthOverSqrtArea = onCircle.seamLengthOverSqrtArea.value_or(0);
  const double seams = onCircle.seamLength.value_or(0);
  row.cutShare = seams > 0 ? onCircle.cutLength.value_or(0) / seams : 0;
  row.segmentMilliseconds = onCircle.timing.segment.value_or(0);
  return run;
}

/// True where borders are finished: then all methods' are finished alike, and a second table has
/// them as each method leaves them. Else there is just that one.
bool finishesBorders(const Invocation& call) { return call.parameters.refine != "none"; }

std::vector<MethodRun> runsOf(Session& session, const Invocation& call) {
  const bool finishes = finishesBorders(call);
  std::vector<MethodRun> runs;
  for (const std::string& method : call.compare) {
    Invocation one = call;
    one.parameters = comparedWith(call.parameters, method);
    Document document = session.document();
    document.parameters = one.parameters;
    session.setDocument(document, Session::Answer::Nothing);
    session.resetSeeds();
    segment(session, one);
    runs.push_back(measured(session, one, finishes, true));
    if (!finishes) continue;
    const Parameters left = asLeft(call.parameters, method);
    if (left == one.parameters) {
      runs.push_back(runs.back());
      runs.back().row.alike = false;
      continue;
    }
    // Only borders change: finished charts are finished again in the other way.
    document = session.document();
    document.parameters = left;
    session.setDocument(document, Session::Answer::Flood);
    waitForSession(session, call);
    const double milliseconds = runs.back().row.segmentMilliseconds;
    runs.push_back(measured(session, one, false, false));
    runs.back().row.segmentMilliseconds = milliseconds;
  }
  return runs;
}

std::string comparisonReport(const std::vector<MethodRun>& runs, bool finishes) {
  Report report = makeReport(*runs.front().shown, {}, CHARTFLOOD_VERSION);
  report.results.clear();
  for (const MethodRun& run : runs) {
    report.comparison.push_back(run.row);
    if (run.row.alike != finishes) continue;
    report.results.push_back(makeReport(*run.shown, {}, CHARTFLOOD_VERSION).results.front());
  }
  report.peakMemoryBytes = peakMemoryBytes();
  return reportText(report);
}

}  // namespace

void runComparison(const Invocation& call) {
  catchInterruptions(removeStagedFiles);
  checkTargets(call);
  if (!call.output.empty()) checkGrid(call);
  Session session(Session::Worker::Threaded);
  openInput(session, call);
  const std::vector<MethodRun> runs = runsOf(session, call);
  std::vector<ComparisonRow> rows;
  std::vector<ResultsPtr> shown;
  std::vector<std::vector<std::string>> captions;
  for (const MethodRun& run : runs) {
    rows.push_back(run.row);
    if (run.row.alike != finishesBorders(call)) continue;
    shown.push_back(run.shown);
    captions.push_back(comparisonCaption(run.row));
  }
  std::vector<StagedFile> files;
  if (!call.output.empty()) {
    const Image image = drawSideBySide(shown, captions, call);
    const auto bytes = encodePng(image, pictureTexts(*shown.front()));
    files.emplace_back(call.output, std::string(bytes.begin(), bytes.end()));
  }
  const std::string report = comparisonReport(runs, finishesBorders(call));
  if (!call.report.empty() && call.report != "-") files.emplace_back(call.report, report);
  throwIfInterrupted();
  commitAll(files);
  printOutput(call.report == "-" ? report : comparisonText(rows));
}

}  // namespace chartflood
