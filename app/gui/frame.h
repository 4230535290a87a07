#pragma once
/// The interface as a whole: where each panel stands, which keys act, when the next frame is due.
/// Needs a Dear ImGui context, but no window and no GL.

#include "app/gui/tools/compare_panel.h"
#include "app/gui/tools/scene_panel.h"
#include "app/gui/tools/uv_panel.h"
#include "app/gui/widgets/file_browser.h"
#include "app/gui/widgets/probe.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/ui.h"

namespace chartflood {

class PreviewSource;

class Frame {
 public:
  /// The window at scale 1 below which the right pane starts hidden.
  static constexpr float kNarrow = 1200;

  Frame(AppState& state, const ActionRegistry& actions, float scale);

  /// Changes the size of text and controls; the fonts must then be uploaded again.
  void setScale(float scale);
  float scale() const { return theme_.scale; }

  /// Submits everything between ImGui::NewFrame and ImGui::Render. The sources may be null.
  void draw(SceneSource* source, UvSource* uvSource = nullptr, PreviewSource* previews = nullptr);
  /// Runs what a key is bound to, unless a text field or a widget owns the keyboard. Returns
  /// whether it acted.
  bool key(const Chord& chord, bool repeated);

  /// Seconds until another frame is needed though nothing happens; large for never.
  double wakeIn() const { return memory_.wakeIn; }
  const Probe& probe() const { return probe_; }

 private:
  /// Rectangles of the panels in this frame.
  struct Layout {
    ImVec2 screen;
    float top, tool, bottom, status, left, right;
  };

  const Binding* bindingOf(const Chord& chord) const;
  Layout layOut();
  void takeChartColors(SceneSource* source);
  void drawBars(const Ui& ui, const Layout& layout);
  void drawLeft(const Ui& ui, const Layout& layout);
  void drawRight(const Ui& ui, const Layout& layout, UvSource* uvSource);
  void drawScene(const Ui& ui, const Layout& layout, SceneSource* source);
  void drawSplitters(const Ui& ui, const Layout& layout);

  AppState& state_;
  const ActionRegistry& actions_;
  Theme theme_;
  Probe probe_;
  UiMemory memory_;
  SceneMouse mouse_;
  CompareMouse sideMouse_;
  UvMouse uvMouse_;
  FileBrowser browser_;
  bool laidOut_ = false;
};

}  // namespace chartflood
