// Actions that write files from the results.

#include "app/host/action_registry.h"
#include "app/host/actions.h"
#include "app/host/app_state.h"
#include "core/base/error.h"
#include "core/io/file_output.h"
#include "core/io/write_labels.h"
#include "core/io/write_report.h"
#include "core/session/make_report.h"

namespace chartflood {

namespace {

std::string needsMesh(const AppState& state) {
  return state.hasMesh() ? "" : "There is no model yet; open one first.";
}

std::string needsLabels(const AppState& state) {
  if (!state.hasMesh()) return needsMesh(state);
  const auto& labels = state.results().segmentation;
  const bool ready = labels && labels->complete && !state.status().busy;
  return ready ? "" : "There are no complete charts yet; finish a flood first.";
}

void takePicture(AppState& state, const Arguments& a) {
  PictureRequest request;
  request.bare = a.flag("bare", false);
  request.scale = static_cast<int>(a.integer("scale", state.preferences.screenshotScale));
  if (request.scale != 1 && request.scale != 2 && request.scale != 4) {
    throw UsageError("A picture can be 1, 2 or 4 times the size of the view.");
  }
  request.file = a.text("file");
  state.requests.pictures.push_back(std::move(request));
}

/// Writes what `bytes` gives to the named file, or opens the browser when none is named.
template <typename Bytes>
void exportTo(AppState& state, const Arguments& a, PanelState::Browse browse, Bytes&& bytes) {
  if (!a.has("file")) {
    state.panels.browse = browse;
    return;
  }
  writeFileAtomically(a.text("file"), bytes());
  state.notices.add(Notice::Kind::Info, "Wrote " + a.text("file") + ".");
}

}  // namespace

void addExportActions(ActionRegistry& registry) {
  registry.add({.id = "screenshot",
                .title = "Picture",
                .help = "Saves the 3D view as a PNG picture; bare: transparent, without helpers.",
                .arguments = {{"file", ArgumentType::Text, "left out: a new name", false},
                              {"scale", ArgumentType::Integer, "1, 2 or 4 times the view", false},
                              {"bare", ArgumentType::Switch, "without helpers", false}},
                .refusal = needsMesh,
                .run = takePicture});
  registry.bind("F12", "screenshot");
  registry.bind("Ctrl+F12", "screenshot bare=on");
  registry.add({.id = "picture-scale",
                .title = "Size of pictures",
                .help = "Sets how many times the size of the view pictures are.",
                .arguments = {{"scale", ArgumentType::Choice, "times", true, {"1", "2", "4"}}},
                .refusal = {},
                .run =
                    [](AppState& state, const Arguments& a) {
                      state.preferences.screenshotScale = static_cast<int>(a.integer("scale"));
                    },
                .checked =
                    [](const AppState& state, const Arguments& a) {
                      return state.preferences.screenshotScale == a.integer("scale");
                    }});
  registry.add({.id = "export-labels",
                .title = "Export labels\u2026",
                .help = "Writes the chart of each face as one number a line.",
                .arguments = {{"file", ArgumentType::Text, "left out: asks", false}},
                .refusal = needsLabels,
                .run = [](AppState& state, const Arguments& a) {
                  exportTo(state, a, PanelState::Browse::SaveLabels, [&] {
                    return labelsText(*state.results().mesh, state.results().segmentation->label);
                  });
                }});
  registry.add({.id = "export-report",
                .title = "Export report\u2026",
                .help = "Writes parameters and figures as JSON.",
                .arguments = {{"file", ArgumentType::Text, "left out: asks", false}},
                .refusal = needsLabels,
                .run = [](AppState& state, const Arguments& a) {
                  exportTo(state, a, PanelState::Browse::SaveReport, [&] {
                    return reportText(makeReport(state.results(), seedFaces(state.document().seeds),
                                                 CHARTFLOOD_VERSION));
                  });
                }});
}

}  // namespace chartflood
