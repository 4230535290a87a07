#pragma once
/// The system's window with its GL context, and Dear ImGui fed by it, each for as long as its owner
/// lives.

#include <memory>

struct GLFWwindow;

namespace chartflood {

class Glfw {
 public:
  /// \throws Error when no window can be opened.
  Glfw();
  ~Glfw();
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;
};

struct DestroyWindow {
  void operator()(GLFWwindow* window) const;
};
using WindowHandle = std::unique_ptr<GLFWwindow, DestroyWindow>;

/// Opens a window of this size, or as large as the screen has room for, and makes its context
/// current. \throws Error when there is no OpenGL 3.3.
WindowHandle openWindow(int width, int height);

/// Dear ImGui with the window's input.
class Imgui {
 public:
  explicit Imgui(GLFWwindow* window);
  ~Imgui();
  Imgui(const Imgui&) = delete;
  Imgui& operator=(const Imgui&) = delete;
};

}  // namespace chartflood
