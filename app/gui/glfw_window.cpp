#include "app/gui/glfw_window.h"

#include <algorithm>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include "core/base/error.h"

namespace chartflood {

namespace {

constexpr int kLeastWidth = 640, kLeastHeight = 480;

std::string glfwProblem() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason given" : text;
}

}  // namespace

Glfw::Glfw() {
  if (glfwInit() == GLFW_TRUE) return;
  throw Error("No window can be opened (" + glfwProblem() +
              "). Without a display use --output=picture.png.");
}

Glfw::~Glfw() { glfwTerminate(); }

void DestroyWindow::operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }

WindowHandle openWindow(int width, int height) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "chartflood");
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
    int x = 0, y = 0, mostWidth = width, mostHeight = height;
    glfwGetMonitorWorkarea(monitor, &x, &y, &mostWidth, &mostHeight);
    width = std::min(width, mostWidth);
    height = std::min(height, mostHeight);
  }
  WindowHandle window(glfwCreateWindow(width, height, "chartflood", nullptr, nullptr));
  if (!window) {
    throw Error("The window needs OpenGL 3.3, which is not there (" + glfwProblem() +
                "). Use --output=picture.png to work without a window.");
  }
  glfwSetWindowSizeLimits(window.get(), kLeastWidth, kLeastHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window.get());
  glfwSwapInterval(1);
  return window;
}

Imgui::Imgui(GLFWwindow* window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  ImGui_ImplGlfw_InitForOther(window, true);
}

Imgui::~Imgui() {
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

}  // namespace chartflood
