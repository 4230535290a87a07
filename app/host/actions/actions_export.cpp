// Actions that write files from the results.

#include "app/host/actions/action_needs.h"
#include "app/host/actions/actions.h"
#include "app/host/files/export_files.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"
#include "core/io/write/file_output.h"
#include "core/io/write/write_labels.h"
#include "core/io/write/write_report.h"
#include "core/session/pipeline/make_report.h"

namespace chartflood {

namespace {

std::string needsLabels(const AppState& state) {
  if (!state.hasMesh()) return needsMesh(state);
  const auto& labels = state.results().segmentation;
  const bool ready = labels && labels->complete && !state.status().busy && settled(state.results());
  return ready ? "" : "There are no complete charts yet; finish a flood first.";
}

std::string needsFlatCharts(const AppState& state) { return exportRefusal(state.results()); }

constexpr const char* kOverwriteHelp = "on: also over the model itself";

/// \throws Refusal when the export would replace the model that it is made from
void refuseOverModel(const AppState& state, const Arguments& a) {
  const std::filesystem::path model = state.modelIsFile() ? state.results().mesh->input().file : "";
  if (a.flag("overwrite", false) || !isSameFile(a.text("file"), model)) return;
  throw Refusal(model.filename().string() +
                " is the model itself, and the export does not carry all of it: choose another "
                "name, or add overwrite=on to the line of the action.");
}

/// Writes what `bytes` gives to the named file, or opens the browser when none is named.
template <typename Bytes>
void exportTo(AppState& state, const Arguments& a, PanelState::Browse browse, Bytes&& bytes) {
  if (!a.has("file")) {
    state.panels.browse = browse;
    return;
  }
  refuseOverModel(state, a);
  writeFileAtomically(a.text("file"), bytes());
  state.notices.add(Notice::Kind::Info, "Wrote " + a.text("file") + ".");
}

/// SVG is text that is written at once; PNG is drawn by whoever owns the renderer.
void exportUv(AppState& state, const Arguments& a) {
  const std::filesystem::path file = a.text("file");
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  if (a.has("file") && ending == ".png") {
    state.requests.pictures.push_back({.file = file, .settings = {}, .texture = true});
    return;
  }
  if (a.has("file") && ending != ".svg") {
    throw UsageError(file.filename().string() + " cannot be written: give a name that ends in "
                                                ".png or .svg.");
  }
  exportTo(state, a, PanelState::Browse::SaveUv, [&] {
    return exportedUvSvg(state.results(), state.view.render.palette, state.view.chartColors);
  });
}

void addFlatExports(ActionRegistry& registry) {
  registry.add({.id = "export-mesh",
                .title = "Export mesh\u2026",
                .help = "Writes the mesh with texture coordinates and charts: OBJ, PLY or GLB, by "
                        "the name's ending.",
                .arguments = {{"file", ArgumentType::Text, "left out: asks", false},
                              {"overwrite", ArgumentType::Switch, kOverwriteHelp, false}},
                .refusal = needsFlatCharts,
                .run = [](AppState& state, const Arguments& a) {
                  exportTo(state, a, PanelState::Browse::SaveMesh,
                           [&] { return exportedMesh(state.results(), a.text("file")); });
                }});
  registry.bind("Ctrl+E", "export-mesh");
  registry.add({.id = "export-uv",
                .title = "Export UV layout\u2026",
                .help = "Writes the charts in the texture: PNG or SVG, by the name's ending.",
                .arguments = {{"file", ArgumentType::Text, "left out: asks", false},
                              {"overwrite", ArgumentType::Switch, kOverwriteHelp, false}},
                .refusal = needsFlatCharts,
                .run = exportUv});
  registry.add({.id = "export-seams",
                .title = "Export seams\u2026",
                .help = "Writes borders between charts and cuts as lines (OBJ).",
                .arguments = {{"file", ArgumentType::Text, "left out: asks", false},
                              {"overwrite", ArgumentType::Switch, kOverwriteHelp, false}},
                .refusal = needsFlatCharts,
                .run = [](AppState& state, const Arguments& a) {
                  exportTo(state, a, PanelState::Browse::SaveSeams,
                           [&] { return exportedSeams(state.results()); });
                }});
}

}  // namespace

void addExportActions(ActionRegistry& registry) {
  addFlatExports(registry);
  registry.add({.id = "export-labels",
                .title = "Export labels\u2026",
                .help = "Writes the chart of each face as one number a line.",
                .arguments = {{"file", ArgumentType::Text, "left out: asks", false},
                              {"overwrite", ArgumentType::Switch, kOverwriteHelp, false}},
                .refusal = needsLabels,
                .run = [](AppState& state, const Arguments& a) {
                  exportTo(state, a, PanelState::Browse::SaveLabels, [&] {
                    return labelsText(*state.results().mesh, state.results().segmentation->label);
                  });
                }});
  registry.add({.id = "export-report",
                .title = "Export report\u2026",
                .help = "Writes parameters and figures as JSON.",
                .arguments = {{"file", ArgumentType::Text, "left out: asks", false},
                              {"overwrite", ArgumentType::Switch, kOverwriteHelp, false}},
                .refusal = needsLabels,
                .run = [](AppState& state, const Arguments& a) {
                  exportTo(state, a, PanelState::Browse::SaveReport, [&] {
                    return reportText(makeReport(state.results(), seedFaces(state.document().seeds),
                                                 CHARTFLOOD_VERSION));
                  });
                }});
}

}  // namespace chartflood
