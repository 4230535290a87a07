#include "app/gui/frame.h"

#include <algorithm>
#include <cmath>

#include <imgui_internal.h>

#include "app/gui/panels/panels.h"
#include "app/gui/panels/problem_key.h"
#include "app/gui/tools/compare_panel.h"
#include "app/gui/tools/seeds_tool.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

constexpr double kNever = 1e9;
constexpr float kLeftWidth = 330, kRightWidth = 370;
constexpr float kWide = 1600, kWideShare = 0.33f;
constexpr float kLeastPane = 250, kLeastView = 240;
constexpr float kWholeTabNames = 320;
constexpr float kToolHeight = 46, kTimelineHeight = 70, kStatusHeight = 30;

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

/// A window at a fixed place; returns with it begun.
void beginFixed(const char* name, ImVec2 position, ImVec2 size, ImU32 ground, ImVec2 padding,
                ImGuiWindowFlags more = 0) {
  ImGui::SetNextWindowPos(position);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ground);
  // Where controls have edges, panels have them too.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, ImGui::GetStyle().FrameBorderSize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::Begin(name, nullptr, kFixed | more);
}

void endFixed() {
  ImGui::End();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

/// Keys that step: holding them down repeats.
bool repeats(const Chord& chord) {
  return chord.key == "Left" || chord.key == "Right" || chord.key == "Up" || chord.key == "Down" ||
         chord.key == "Tab" || chord.key == "+" || chord.key == "-" || chord.key == "[" ||
         chord.key == "]";
}

}  // namespace

Frame::Frame(AppState& state, const ActionRegistry& actions, float scale)
    : state_(state), actions_(actions), theme_(applyTheme(scale, state.preferences.theme)) {}

void Frame::setScale(float scale) {
  const float ratio = scale / theme_.scale;
  theme_ = applyTheme(scale, state_.preferences.theme);
  memory_.leftWidth = std::round(memory_.leftWidth * ratio);
  memory_.rightWidth = std::round(memory_.rightWidth * ratio);
}

Frame::Layout Frame::layOut() {
  Layout layout;
  layout.screen = ImGui::GetIO().DisplaySize;
  if (!laidOut_) {
    laidOut_ = true;
    memory_.leftWidth = theme_.px(kLeftWidth);
    // A wide screen has room for a larger texture.
    const bool wide = layout.screen.x >= theme_.px(kWide);
    memory_.rightWidth = wide ? std::round(kWideShare * layout.screen.x) : theme_.px(kRightWidth);
    state_.panels.rightWanted = layout.screen.x >= kNarrow * theme_.scale;
    state_.panels.right = state_.panels.rightWanted;
  }
  layout.top = ImGui::GetFrameHeight() + theme_.px(2);
  layout.tool = layout.top + theme_.px(kToolHeight);
  layout.status = layout.screen.y - theme_.px(kStatusHeight);
  layout.bottom = layout.status - (state_.panels.bottom ? theme_.px(kTimelineHeight) : 0);
  layout.left = state_.panels.left ? memory_.leftWidth : 0;
  layout.right = layout.screen.x - (state_.panels.right ? memory_.rightWidth : 0);
  const float least = theme_.px(kLeastView);
  if (layout.right - layout.left < least)
    layout.right = std::min(layout.screen.x, layout.left + least);
  return layout;
}

void Frame::drawBars(const Ui& ui, const Layout& layout) {
  const Palette& p = theme_.palette;
  const ImVec2 pad{theme_.px(10), theme_.px(7)};
  beginFixed("menu", {0, 0}, {layout.screen.x, layout.top}, p.bar, pad,
             ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar);
  menuBar(ui);
  endFixed();
  beginFixed("tools", {0, layout.top}, {layout.screen.x, layout.tool - layout.top}, p.panel, pad,
             ImGuiWindowFlags_NoScrollbar);
  toolBar(ui);
  endFixed();
  if (state_.panels.bottom) {
    beginFixed("time", {0, layout.bottom}, {layout.screen.x, layout.status - layout.bottom},
               p.panel, pad, ImGuiWindowFlags_NoScrollbar);
    timeline(ui);
    endFixed();
  }
  beginFixed("status", {0, layout.status}, {layout.screen.x, layout.screen.y - layout.status},
             p.bar, {theme_.px(10), theme_.px(2)}, ImGuiWindowFlags_NoScrollbar);
  statusBar(ui);
  endFixed();
}

void Frame::drawLeft(const Ui& ui, const Layout& layout) {
  if (!state_.panels.left) return;
  beginFixed("left", {0, layout.tool}, {layout.left, layout.bottom - layout.tool},
             theme_.palette.panel, {theme_.px(10), theme_.px(8)},
             ImGuiWindowFlags_AlwaysVerticalScrollbar);
  parameterPanel(ui);
  viewPanel(ui);
  endFixed();
}

void Frame::drawRight(const Ui& ui, const Layout& layout, UvSource* uvSource) {
  state_.panels.uvUnderMouse = false;
  if (!state_.panels.right) return leaveUv(ui, uvMouse_);
  beginFixed("right", {layout.right, layout.tool},
             {layout.screen.x - layout.right, layout.bottom - layout.tool}, theme_.palette.panel,
             {theme_.px(10), theme_.px(8)});
  PanelState& panels = state_.panels;
  if (ImGui::BeginTabBar("tabs")) {
    auto tab = [&](const char* name, PanelState::RightTab which, auto&& content) {
      const bool bring = panels.selectRightTab && panels.rightTab == which;
      const bool open =
          ImGui::BeginTabItem(name, nullptr, bring ? ImGuiTabItemFlags_SetSelected : 0);
      const std::string_view whole = name;
      ui.probe.item("tab/" + std::string(whole.substr(whole.rfind('#') + 1)));
      if (!open) return;
      if (!panels.selectRightTab) panels.rightTab = which;
      content(ui);
      ImGui::EndTabItem();
    };
    bool uvShown = false;
    tab("UV", PanelState::RightTab::Uv, [&](const Ui& inside) {
      uvShown = true;
      const double moved = ImGui::GetTime() - std::max(mouse_.movedAt, sideMouse_.movedAt());
      uvPanel(inside, uvSource, uvMouse_, moved < kSettleSeconds);
    });
    if (!uvShown) leaveUv(ui, uvMouse_);
    tab("Charts", PanelState::RightTab::Charts, chartTable);
    // The tab's whole name only where all names have room.
    const bool wide = ImGui::GetWindowWidth() > theme_.px(kWholeTabNames);
    tab(wide ? "Gauss sphere###sphere" : "Sphere###sphere", PanelState::RightTab::Sphere,
        spherePanel);
    tab("Plots", PanelState::RightTab::Plots, plotsPanel);
    panels.selectRightTab = false;
    ImGui::EndTabBar();
  }
  endFixed();
}

void Frame::drawScene(const Ui& ui, const Layout& layout, SceneSource* source) {
  const ImVec2 low{layout.left, layout.tool}, high{layout.right, layout.bottom};
  // One picture covers the whole view; a ground below it would only cost time.
  const bool covered = source != nullptr && !state_.compare.showing();
  beginFixed("scene", low, {high.x - low.x, high.y - low.y}, theme_.palette.ground, {0, 0},
             ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                 ImGuiWindowFlags_NoNav | (covered ? ImGuiWindowFlags_NoBackground : 0));
  const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
  state_.panels.viewWidth = static_cast<int>((high.x - low.x) * pixels.x);
  state_.panels.viewHeight = static_cast<int>((high.y - low.y) * pixels.y);
  if (state_.compare.showing()) {
    comparePanel(ui, source, sideMouse_);
  } else {
    scenePanel(ui, source, mouse_);
  }
  endFixed();
  toasts(ui, low, high);
  firstStepsCard(ui, low, high);
  if (state_.hasMesh()) toolSwitch(ui, low);
  problemKey(ui, low);
  legendPanel(ui, low, high);
  handleFilmBar(ui, low, high);
  recoveryCard(ui, low, high);
}

void Frame::drawSplitters(const Ui& ui, const Layout& layout) {
  const float height = layout.bottom - layout.tool;
  const float least = theme_.px(kLeastPane), view = theme_.px(kLeastView);
  if (state_.panels.left) {
    const float most = (state_.panels.right ? layout.right : layout.screen.x) - view;
    splitter(ui, "splitter/left", {layout.left, layout.tool}, height, memory_.leftWidth, false,
             least, most);
  }
  if (state_.panels.right) {
    const float most = layout.screen.x - layout.left - view;
    splitter(ui, "splitter/right", {layout.right, layout.tool}, height, memory_.rightWidth, true,
             least, most);
  }
}

void Frame::takeChartColors(SceneSource* source) {
  memory_.chartColors.clear();
  if (source == nullptr) return;
  for (const glm::vec3& c : source->chartColors(state_)) {
    memory_.chartColors.push_back(ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1}));
  }
  // Kept with the session: another day the charts have the same colours.
  std::vector<Index> numbers = source->chartColorNumbers(state_);
  if (!numbers.empty()) state_.view.chartColors = std::move(numbers);
}

void Frame::draw(SceneSource* source, UvSource* uvSource, PreviewSource* previews) {
  probe_.beginFrame();
  memory_.wakeIn = kNever;
  memory_.hoveredSeen = false;
  memory_.pointed = kNone;
  if (theme_.kind != state_.preferences.theme) recolor(theme_, state_.preferences.theme);
  const Ui ui{state_, actions_, theme_, probe_, memory_};
  takeChartColors(source);
  const Layout layout = layOut();
  const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
  state_.panels.windowWidth = std::max(1, static_cast<int>(layout.screen.x * pixels.x));
  state_.panels.windowHeight = std::max(1, static_cast<int>(layout.screen.y * pixels.y));
  drawScene(ui, layout, source);
  drawBars(ui, layout);
  drawLeft(ui, layout);
  drawRight(ui, layout, uvSource);
  drawSplitters(ui, layout);
  keysWindow(ui);
  logWindow(ui);
  aboutWindow(ui);
  preferencesWindow(ui);
  pictureDialog(ui, previews);
  browser_.draw(ui);
  unsavedQuestion(ui);
  presetNameQuestion(ui);
  actionPalette(ui);
  ui.wakeIn(state_.keeper.dueIn());
  if (state_.keepsLater()) ui.wakeIn(0.5);
  if (state_.methodRuns.running()) ui.wakeIn(0.1);  // its bar moves
  if (!memory_.hoveredSeen) memory_.hovered.clear();
  if (state_.pointedChart != memory_.pointed) {
    state_.pointedChart = memory_.pointed;
    ui.wakeIn(0);  // the views follow
  }
  if (state_.playback.playing() || state_.status().busy) ui.wakeIn(0);
  if (state_.flash.face() != kNone) ui.wakeIn(state_.flash.secondsLeft());
}

/// A film over the model has its keys, and so has the seeds tool as long as that can be done.
const Binding* Frame::bindingOf(const Chord& chord) const {
  if (state_.film.active()) {
    const Binding* own = actions_.findBinding(chord, KeyPlace::HandleFilm);
    if (own != nullptr) return own;
  }
  if (state_.panels.tool == PanelState::Tool::Seeds) {
    const Binding* own = actions_.findBinding(chord, KeyPlace::SeedsTool);
    if (own != nullptr && actions_.refusal(own->line, state_).empty()) return own;
  }
  return actions_.findBinding(chord);
}

bool Frame::key(const Chord& chord, bool repeated) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool browsing = state_.panels.browse != PanelState::Browse::Nothing;
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
  const bool searching = state_.panels.search;
  const bool quits = chord == Chord{.key = "Q", .ctrl = true};
  if (!quits && (io.WantTextInput || browsing || searching || popup || !memory_.typing.empty()))
    return false;
  const bool widgetHasKeys = io.NavVisible && !GImGui->NavDisableHighlight;
  const bool navigates = chord.key == "Space" || chord.key == "Enter" || chord.key == "Left" ||
                         chord.key == "Right" || chord.key == "Up" || chord.key == "Down" ||
                         chord.key == "Tab" || chord.key == "Esc";
  if (widgetHasKeys && navigates && !chord.ctrl) return false;
  if (state_.seedDrag && chord.key == "Esc") return state_.perform(actions_, "put-back");
  if (state_.panels.legend && chord.key == "Esc") return state_.perform(actions_, "legend off");
  const bool textWindow = state_.panels.keys || state_.panels.log || state_.panels.about ||
                          state_.panels.preferences || state_.panels.picture;
  if (textWindow && chord.key == "Esc") return false;
  if (repeated && !repeats(chord)) return false;
  if (state_.panels.firstCard) state_.perform(actions_, "first-steps off");
  const Binding* binding = bindingOf(chord);
  if (binding == nullptr) return false;
  const std::string reason = actions_.refusal(binding->line, state_);
  if (!reason.empty()) {
    state_.notices.add(Notice::Kind::Info, reason);
    return true;
  }
  return state_.perform(actions_, binding->line);
}

}  // namespace chartflood
