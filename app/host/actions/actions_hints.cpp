// Actions of the brush on edges. Vertices are those of the file, as in files of hints.

#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include "app/host/actions/action_needs.h"
#include "app/host/actions/actions.h"
#include "app/host/actions/hint_edits.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

const std::vector<std::string> kBrushes = {"cut", "never", "erase"};

std::string needsHints(const AppState& state) {
  if (!state.hasMesh()) return needsMesh(state);
  return state.document().hints.empty() ? "No edge has a hint." : "";
}

/// "12,57,80". \throws UsageError
std::vector<Index> verticesOf(const std::string& text) {
  std::vector<Index> vertices;
  const char* p = text.data();
  const char* const end = p + text.size();
  for (;;) {
    Index vertex = 0;
    const auto [next, error] = std::from_chars(p, end, vertex);
    const bool goesOn = next < end && *next == ',';
    if (error != std::errc() || (next != end && !goesOn)) {
      throw UsageError("path=" + text + " is no list of vertices: give A,B,.. from 0.");
    }
    vertices.push_back(vertex);
    if (next == end) break;
    p = next + 1;
  }
  if (vertices.size() < 2) throw UsageError("path=" + text + " is no edge: give two vertices.");
  return vertices;
}

}  // namespace

void addHintActions(ActionRegistry& registry) {
  registry.add(
      {.id = "brush",
       .title = "Brush of hints",
       .help = "What the Hints tool paints: where seams are welcome, where they are to "
               "stay away, or nothing any more.",
       .arguments = {{"name", ArgumentType::Choice, "which one", true, kBrushes}},
       .refusal = {},
       .run = [](AppState& state,
                 const Arguments& a) { state.panels.brush = hintBrushFromId(a.text("name")); },
       .checked =
           [](const AppState& state, const Arguments& a) {
             return hintBrushId(state.panels.brush) == a.text("name");
           }});
  registry.add({.id = "paint",
                .title = "Paint hints",
                .help = "Paints the edges along a chain of vertices of the file. Shortest borders "
                        "run along \"cut\" and keep away from \"never\".",
                .arguments = {{"name", ArgumentType::Choice, "which brush", true, kBrushes},
                              {"path", ArgumentType::Text, "vertices: A,B,.. from 0"}},
                .refusal = needsMesh,
                .run = [](AppState& state, const Arguments& a) {
                  paintHints(state, hintBrushFromId(a.text("name")), verticesOf(a.text("path")));
                }});
  registry.add({.id = "clear-hints",
                .title = "Clear hints",
                .help = "Takes all painted edges away.",
                .arguments = {},
                .refusal = needsHints,
                .run = [](AppState& state, const Arguments&) { clearHints(state); }});
}

}  // namespace chartflood
