// Actions of the eye: colours, overlays, camera, panels.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/host/actions/actions.h"
#include "app/host/actions/switch_action.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"
#include "render/scene/first_view.h"

namespace chartflood {

namespace {

std::vector<std::string> modeIds() {
  std::vector<std::string> ids;
  for (const ColorModeInfo& info : colorModeTable()) ids.emplace_back(info.id);
  return ids;
}

void addOverlays(ActionRegistry& registry) {
  auto overlay = [&](const char* id, const char* title, const char* help, const char* key,
                     bool RenderSettings::*member) {
    addSwitch(
        registry, id, title, help,
        key, [member](auto& state) -> auto& { return state.view.render.*member; });
  };
  overlay("seams", "Seams", "Lines between charts.", "S", &RenderSettings::seams);
  overlay("cuts", "Cuts", "Lines along which charts are opened so that they can lie flat.", "C",
          &RenderSettings::cuts);
  overlay("edges", "Mesh edges", "The edges of all triangles.", "E", &RenderSettings::edges);
  overlay("sharp-edges", "Sharp edges", "Edges folded more than the sharp edge angle.", "K",
          &RenderSettings::sharpEdges);
  overlay("seeds", "Seeds", "A ball where each chart begins.", "M", &RenderSettings::seedMarks);
  overlay("numbers", "Chart numbers", "The number of each chart on the model.", "N",
          &RenderSettings::numbers);
  overlay("color-bar", "Colour bar", "What the colours mean.", "B", &RenderSettings::scalarBar);
  overlay("smooth", "Smooth shading", "Hides the facets of smooth parts.", "",
          &RenderSettings::smoothNormals);
}

void nextCheckerKind(AppState& state) {
  CheckerKind& kind = state.view.render.checkerKind;
  const int kinds = state.view.render.checkerPicture ? 4 : 3;
  kind = static_cast<CheckerKind>((static_cast<int>(kind) + 1) % kinds);
}

void addColors(ActionRegistry& registry) {
  registry.add({.id = "color-mode",
                .title = "Colour",
                .help = "Chooses what the colours of the model say.",
                .arguments = {{"mode", ArgumentType::Choice, "which one", true, modeIds()}},
                .refusal = {},
                .run =
                    [](AppState& state, const Arguments& a) {
                      showColorMode(state.view, findColorMode(a.text("mode"))->mode);
                    },
                .checked =
                    [](const AppState& state, const Arguments& a) {
                      return colorModeInfo(state.view.render.colorMode).id == a.text("mode");
                    }});
  for (const ColorModeInfo& info : colorModeTable()) {
    if (*info.key != '\0') registry.bind(info.key, std::string("color-mode ") + info.id);
  }
  registry.add({.id = "next-sub-mode",
                .title = "Next of its kind",
                .help = "Goes round the modes of one kind: Gauss area of all, corners, edges, "
                        "triangles; flood time, order; squares, numbers, circles.",
                .arguments = {},
                .refusal = [](const AppState& state) -> std::string {
                  const ColorMode mode = state.view.render.colorMode;
                  const bool single = colorModeFamily(mode).size() < 2;
                  return single && mode != ColorMode::Checkerboard
                             ? "This colour mode has no others of its kind."
                             : "";
                },
                .run =
                    [](AppState& state, const Arguments&) {
                      const ColorMode mode = state.view.render.colorMode;
                      if (mode == ColorMode::Checkerboard) return nextCheckerKind(state);
                      const auto family = colorModeFamily(mode);
                      const auto at = std::find(family.begin(), family.end(), mode) + 1;
                      showColorMode(state.view, at == family.end() ? family.front() : *at);
                    }});
  registry.bind("Q", "next-sub-mode");
}

void addCamera(ActionRegistry& registry) {
  registry.add({.id = "frame-all",
                .title = "Frame all",
                .help = "Shows the whole model; with the mouse on the texture, the whole texture.",
                .arguments = {},
                .refusal = {},
                .run = [](AppState& state, const Arguments&) {
                  if (state.panels.uvUnderMouse)
                    state.view.uvCamera = {};
                  else
                    state.view.frameWhenLoaded = true;
                }});
  registry.bind("A", "frame-all");
  registry.add({.id = "view",
                .title = "Standard view",
                .help = "Looks along an axis of the model.",
                .arguments = {{"from",
                               ArgumentType::Choice,
                               "which side",
                               true,
                               {"front", "back", "left", "right", "top", "bottom", "oblique"}}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  state.view.camera.look(standardViewFromId(a.text("from")));
                }});
  const char* const kViews[][2] = {{"Kp1", "front"}, {"Ctrl+Kp1", "back"},
                                   {"Kp3", "right"}, {"Ctrl+Kp3", "left"},
                                   {"Kp7", "top"},   {"Ctrl+Kp7", "bottom"}};
  for (const auto& [key, view] : kViews) registry.bind(key, std::string("view ") + view);
  addSwitch(
      registry, "orthographic", "Orthographic", "Parallel lines stay parallel.", "Kp5",
      [](auto& state) -> auto& { return state.view.camera.orthographic; });
  registry.bind("O", "orthographic");
  registry.add({.id = "up-axis",
                .title = "Upright axis",
                .help = "Chooses the model's axis that stands upright.",
                .arguments = {{"axis", ArgumentType::Choice, "which one", true, {"y", "z"}}},
                .refusal = {},
                .run =
                    [](AppState& state, const Arguments& a) {
                      state.view.camera.up = a.text("axis") == "z" ? UpAxis::Z : UpAxis::Y;
                      state.view.camera.look(StandardView::Oblique);
                      if (state.hasMesh()) lookAtFirst(state.view.camera, *state.results().mesh);
                    },
                .checked =
                    [](const AppState& state, const Arguments& a) {
                      return (state.view.camera.up == UpAxis::Z) == (a.text("axis") == "z");
                    }});
}

void addPanels(ActionRegistry& registry) {
  auto panel = [&](const char* id, const char* title, const char* help, const char* key,
                   bool PanelState::*member) {
    addSwitch(
        registry, id, title, help,
        key, [member](auto& state) -> auto& { return state.panels.*member; });
  };
  panel("right-pane", "Texture, charts, plots", "Shows or hides the right pane.", "U",
        &PanelState::right);
  panel("left-pane", "Parameters", "Shows or hides the left pane.", "", &PanelState::left);
  panel("keys", "Keys", "Lists all keys.", "H", &PanelState::keys);
  registry.bind("F1", "keys");
  panel("log", "Log", "All messages since the start.", "", &PanelState::log);
  panel("about", "About", "Version, method and fonts.", "", &PanelState::about);
  panel("first-steps", "First steps", "The four keys to begin with.", "", &PanelState::firstCard);
  registry.add({.id = "close-browser",
                .title = "Cancel",
                .help = "Closes the file browser.",
                .arguments = {},
                .refusal = {},
                .run = [](AppState& state, const Arguments&) {
                  state.panels.browse = PanelState::Browse::Nothing;
                  state.giveUp();  // saving it first was the answer to a question
                }});
  registry.add(
      {.id = "hide-panels",
       .title = "Hide panels",
       .help = "The model alone; once more brings the panels back.",
       .arguments = {},
       .refusal = {},
       .run =
           [](AppState& state, const Arguments&) {
             PanelState& p = state.panels;
             const bool show = !(p.left || p.bottom);
             p.left = p.bottom = show;
             p.right = show && p.rightWanted;
           },
       .checked = [](const AppState& state,
                     const Arguments&) { return !(state.panels.left || state.panels.bottom); }});
  registry.bind("F10", "hide-panels");
  registry.add(
      {.id = "full-screen",
       .title = "Full screen",
       .help = "Takes the whole screen; once more goes back.",
       .arguments = {},
       .refusal = {},
       .run = [](AppState& state, const Arguments&) { state.requests.toggleFullScreen = true; }});
  registry.bind("F11", "full-screen");
  registry.add(
      {.id = "right-tab",
       .title = "Tab of the right pane",
       .help = "Brings a tab of the right pane to the front.",
       .arguments =
           {{"tab", ArgumentType::Choice, "which one", true, {"uv", "charts", "sphere", "plots"}}},
       .refusal = {},
       .run = [](AppState& state, const Arguments& a) {
         using Tab = PanelState::RightTab;
         const std::string tab = a.text("tab");
         state.panels.right = true;
         state.panels.rightTab = tab == "charts"   ? Tab::Charts
                                 : tab == "sphere" ? Tab::Sphere
                                 : tab == "plots"  ? Tab::Plots
                                                   : Tab::Uv;
         state.panels.selectRightTab = true;
       }});
  registry.add({.id = "close-toast",
                .title = "Close",
                .help = "Takes a message off the view; it stays in the log.",
                .arguments = {{"number", ArgumentType::Integer, "from the top, from 0"}},
                .refusal = {},
                .run = [](AppState& state, const Arguments& a) {
                  state.notices.close(static_cast<std::size_t>(std::max(0L, a.integer("number"))));
                }});
}

}  // namespace

void addViewActions(ActionRegistry& registry) {
  addColors(registry);
  addOverlays(registry);
  addCamera(registry);
  addPanels(registry);
}

}  // namespace chartflood
