#pragma once
/// The window: GLFW, its GL context and the loop that waits for events and draws when something
/// changed.

#include <filesystem>
#include <memory>

#include "app/gui/frame.h"

struct GLFWwindow;

namespace chartflood {

/// Files that scripts of the real window read; "": not written.
struct WindowWatch {
  std::filesystem::path probeFile;  ///< rectangles of all widgets, after every frame
  std::filesystem::path frameLog;   ///< seconds that each pass of the loop and its parts took
};

class Window {
 public:
  /// Opens the window. \throws Error when there is no display or no OpenGL 3.3.
  Window(AppState& state, const ActionRegistry& actions, const WindowWatch& watch);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Runs until the window is closed or the state asks to quit.
  void run();

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace chartflood
