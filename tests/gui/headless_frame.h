#pragma once
/// The interface driven without a window and without GL: frames, clicks, drags and typing by the
/// rectangles that the widgets noted.

#include <string>
#include <string_view>

#include "app/gui/frame.h"
#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"

namespace chartflood {

class HeadlessFrame {
 public:
  explicit HeadlessFrame(ImVec2 size = {1280, 800}, float scale = 1);
  ~HeadlessFrame();
  HeadlessFrame(const HeadlessFrame&) = delete;
  HeadlessFrame& operator=(const HeadlessFrame&) = delete;

  /// Runs frames; the side bars need two to settle.
  void frames(int count);
  /// Opens a sample inline and floods it once; values are answered with floods.
  void openFlooded(const std::string& sample, std::size_t triangles);

  /// The widget with this label; fails the test when it is not there.
  ProbedItem item(std::string_view label) const;
  bool has(std::string_view label) const { return frame_.probe().find(label) != nullptr; }

  /// What draws and picks in the 3D view; null at first.
  void setSource(SceneSource* source) { sceneSource = source; }

  void moveTo(ImVec2 place);
  void press(int button = 0);
  void release(int button = 0);
  void click(std::string_view label);
  void ctrlClick(std::string_view label);
  /// Presses at one share of the widget's width, moves to another in steps, releases.
  void drag(std::string_view label, float from, float to);
  void type(const char* text);
  void enter();
  void wheel(float notches);
  void escape();
  /// Presses a key of ImGuiKey_ for one frame.
  void arrow(int key);
  void key(const char* chord) { frame_.key(parseChord(chord), false); }

  AppState& state() { return state_; }
  const ActionRegistry& actions() const { return actions_; }
  Frame& frame() { return frame_; }
  std::string lastLine() const;

  /// Where the pictures come from; null: none are drawn.
  SceneSource* sceneSource = nullptr;
  UvSource* uvSource = nullptr;
  PreviewSource* previewSource = nullptr;

 private:
  struct Context {
    Context(ImVec2 size);
    ~Context();
  };

  Context context_;
  AppState state_{Session::Worker::Inline};
  ActionRegistry actions_ = makeActionRegistry();
  Frame frame_;
};

}  // namespace chartflood
