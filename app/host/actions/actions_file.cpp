// Actions that bring a mesh in, and the way out.

#include <algorithm>
#include <system_error>

#include "app/host/actions/actions.h"
#include "app/host/actions/picture_on_charts.h"
#include "app/host/files/checker_picture.h"
#include "app/host/files/picture_record.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"
#include "core/samples/samples.h"

namespace chartflood {

namespace {

std::vector<std::string> sampleIds() {
  std::vector<std::string> ids;
  for (const SampleInfo& sample : sampleTable()) ids.emplace_back(sample.id);
  return ids;
}

bool isSample(const AppState& state) {
  std::error_code error;
  return state.hasMesh() && !std::filesystem::exists(state.results().mesh->input().file, error);
}

std::string reloadRefusal(const AppState& state) {
  if (!state.hasMesh()) return "There is no model yet; open one first.";
  if (isSample(state)) return "This model was made by the program; there is no file to read again.";
  return "";
}

}  // namespace

void addFileActions(ActionRegistry& registry) {
  registry.add({.id = "open",
                .title = "Open",
                .help = "Reads a mesh file and floods it once, or goes on with a saved session.",
                .arguments = {{"file", ArgumentType::Text,
                               "OBJ, PLY, OFF, STL, glTF, GLB, a session (.chartflood) or a "
                               "picture saved here, or any other picture (PNG, JPEG) for the "
                               "checkerboard"}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  const std::string name = a.text("file");
                  if (isPictureFile(name) && !holdsSession(name)) {
                    return putPictureOnCharts(state, name);
                  }
                  state.whenSafe([file = a.text("file")](AppState& s) { s.open(file); });
                }});
  registry.add(
      {.id = "browse",
       .title = "Open\u2026",
       .help = "Chooses a mesh or session to read. Files can also be dropped onto the window.",
       .arguments = {},
       .refusal = {},
       .run = [](AppState& state, const Arguments&) {
         state.panels.browse = PanelState::Browse::Open;
       }});
  registry.bind("Ctrl+O", "browse");
  registry.add(
      {.id = "sample",
       .title = "Sample",
       .help = "Opens a model made by the program.",
       .arguments = {{"name", ArgumentType::Choice, "which one", true, sampleIds()},
                     {"triangles", ArgumentType::Integer, "about how many", false}},
       .refusal = {},
       .run = [](AppState& state, const Arguments& a) {
         const long triangles = a.integer("triangles");
         const auto count = static_cast<std::size_t>(std::max(triangles, 0L));
         if (triangles < 0 || count > kMostSampleTriangles) {
           throw UsageError("A sample has from 1 to " + std::to_string(kMostSampleTriangles) +
                            " triangles, or 0 for its own number.");
         }
         state.whenSafe([name = a.text("name"), count](AppState& s) { s.openSample(name, count); });
       }});
  registry.add({.id = "reload",
                .title = "Reload",
                .help = "Reads the present file again.",
                .arguments = {},
                .refusal = reloadRefusal,
                .run = [](AppState& state, const Arguments&) {
                  const std::string file = state.results().mesh->input().file;
                  state.whenSafe([file](AppState& s) { s.open(file); });
                }});
  registry.bind("F5", "reload");
  registry.add({.id = "quit",
                .title = "Quit",
                .help = "Closes the program.",
                .arguments = {},
                .refusal = {},
                .run = [](AppState& state, const Arguments&) {
                  state.whenSafe([](AppState& s) { s.requests.quit = true; });
                }});
  registry.bind("Ctrl+Q", "quit");
}

}  // namespace chartflood
