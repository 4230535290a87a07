#include "app/gui/window.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "app/gui/glfw_window.h"
#include "app/gui/views/compare_scene.h"
#include "app/gui/views/picture_preview.h"
#include "app/gui/views/picture_taker.h"
#include "app/gui/views/scene_view.h"
#include "app/gui/views/uv_view.h"
#include "app/gui/widgets/frame_damage.h"
#include "app/gui/widgets/imgui_gl.h"
#include "app/gui/widgets/key_names.h"
#include "app/host/script/command.h"
#include "core/base/failure.h"

namespace chartflood {

namespace {

constexpr double kFrameSeconds = 1.0 / 60;
/// Passes that nothing was drawn in do not wait for the display; they are this far apart.
constexpr double kUndrawnSeconds = 1.0 / 120;
constexpr double kPassWithPicture = 0.024;  // longer passes leave the 3D view for the next
/// Failures of passes one after the other that are told before the window gives up.
constexpr int kMostFailures = 20;
constexpr int kSettlingFrames = 3;  // Dear ImGui needs some frames to answer an event

std::atomic<bool> wokenByWorker{false};

/// From any thread: something new can be seen.
void wakeWindow() {
  wokenByWorker.store(true, std::memory_order_relaxed);
  glfwPostEmptyEvent();
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Seconds that a pass of the loop took, and its parts; the rest is answering requests.
struct PassTimes {
  double whole = 0;
  double state = 0;    ///< taking results and time in
  double panels = 0;   ///< building the interface, with the first stretch of the pictures in it
  double present = 0;  ///< drawing the interface and handing it to the display
  double picture = 0;  ///< going on with a picture that takes several passes
};

std::ostream& operator<<(std::ostream& out, const PassTimes& t) {
  return out << t.whole << ' ' << t.state << ' ' << t.panels << ' ' << t.present << ' ' << t.picture
             << '\n';
}

/// Where the window stood before it took the whole screen.
struct WindowedPlace {
  int x = 0, y = 0, width = 1280, height = 800;
};

}  // namespace

class Window::Parts {
 public:
  Parts(AppState& state, const ActionRegistry& actions, const WindowWatch& watch)
      : state_(state), actions_(actions), watch_(watch),
        window_(openWindow(state.preferences.windowWidth, state.preferences.windowHeight)),
        callbacks_(*this), imgui_(window_.get()), frame_(state, actions, wantedScale()),
        scene_(wakeWindow),
        pictures_(wakeWindow, [this] { return windowImage(drawer_, *ImGui::GetDrawData()); }) {
    drawer_.uploadFonts();
    if (!watch_.frameLog.empty()) frameLog_.open(watch_.frameLog);
    state_.session().setWake(wakeWindow);
    state_.insight().setWake(wakeWindow);
    state_.methodRuns.setWake(wakeWindow);
  }
  ~Parts() {
    state_.session().setWake(nullptr);
    state_.insight().setWake({});
    state_.methodRuns.setWake(nullptr);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void run() {
    double last = now();
    while (!state_.requests.quit) {
      wait();
      answerClosing();
      const double start = now();
      times_ = {};
      if (due()) {
        pass(start - last);
        last = start;
        rested_ = drawn_ ? 0 : start + kUndrawnSeconds;
        passSeconds_ = now() - start;
      } else if (!drawing()) {
        continue;
      }
      // A slow picture grows in turn with the window's own passes, and is shown by the next one.
      const bool late = now() - start > kPassWithPicture;
      const bool leave = late && !pictureWaited_;
      pictureWaited_ = leave;
      const double before = now();
      guarded([&] {
        if (!leave && goOn()) framesLeft_ = std::max(framesLeft_, 1);
      });
      times_.picture = now() - before;
      times_.whole = now() - start;
      if (frameLog_) frameLog_ << times_ << std::flush;
    }
    rememberSize();
  }

 private:
  /// Registers with GLFW before Dear ImGui does, which then calls on.
  struct Callbacks {
    explicit Callbacks(Parts& parts);
  };

  static Parts& of(GLFWwindow* window) {
    return *static_cast<Parts*>(glfwGetWindowUserPointer(window));
  }

  /// The request to close may be answered by a question.
  void answerClosing() {
    if (glfwWindowShouldClose(window_.get()) != GLFW_TRUE) return;
    glfwSetWindowShouldClose(window_.get(), GLFW_FALSE);
    state_.perform(actions_, "quit");
    touched();
  }

  /// Does a part of a pass. What it throws is told, and the window goes on: the work in it is worth
  /// more than a part of one picture. Unless it never ends: then the copy of the work is kept for
  /// the next start. \throws what the part threw, when that happens again and again
  template <typename Part>
  void guarded(Part&& part) {
    try {
      part();
      return;
    } catch (const std::exception& failure) {
      if (++failures_ > kMostFailures) throw;
      state_.notices.add(Notice::Kind::Error, failureSentence(failure));
    }
    touched();
  }

  /// A slow picture is on its way; the 3D view's goes first.
  bool drawing() const { return sides_.busy() || uv_.busy() || preview_.busy(); }
  bool goOn() {
    if (sides_.busy()) return sides_.goOn();
    return uv_.busy() ? uv_.goOn() : preview_.goOn();
  }

  void touched() { framesLeft_ = kSettlingFrames; }
  /// What the window shows may be lost.
  void damaged() {
    damage_.forget();
    touched();
  }

  void onKey(int key, int scancode, int action, int modifiers) {
    touched();
    if (action == GLFW_RELEASE) return;
    if (const auto chord = chordOf(key, scancode, modifiers)) {
      frame_.key(*chord, action == GLFW_REPEAT);
    }
  }

  void onDrop(int count, const char** paths) {
    touched();
    if (count < 1) return;
    if (count > 1) {
      state_.notices.add(Notice::Kind::Info,
                         "Several files were dropped; the first one is opened.");
    }
    state_.perform(actions_, "open " + quotedArgument(paths[0]));
  }

  void wait() {
    const double wake = std::min(frame_.wakeIn(), deadline_ - now());
    const double rest = rested_ - now();
    if (drawing() || (framesLeft_ > 0 && rest <= 0)) {
      glfwPollEvents();
    } else if (rest > 0) {
      glfwWaitEventsTimeout(rest);
    } else if (frame_.wakeIn() <= 0) {
      glfwWaitEventsTimeout(std::max(0.0005, kFrameSeconds - passSeconds_));
    } else if (frame_.wakeIn() < 1e8) {
      glfwWaitEventsTimeout(std::max(0.001, wake));
    } else {
      glfwWaitEvents();
    }
  }

  /// Whether anything calls for a new frame.
  bool due() {
    const bool woken = wokenByWorker.exchange(false, std::memory_order_relaxed);
    if (woken) framesLeft_ = std::max(framesLeft_, 1);
    return now() >= rested_ && (framesLeft_ > 0 || now() >= deadline_ - 0.001);
  }

  float wantedScale() const {
    if (state_.preferences.uiScale > 0) return static_cast<float>(state_.preferences.uiScale);
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_.get(), &x, &y);
    return std::clamp(x, 0.75f, 2.5f);
  }

  void pass(double seconds) {
    framesLeft_ = std::max(0, framesLeft_ - 1);
    const double start = now();
    const int failuresBefore = failures_;
    guarded([&] { state_.update(seconds); });
    times_.state = now() - start;
    if (const float scale = wantedScale(); scale != frame_.scale()) {
      frame_.setScale(scale);
      drawer_.uploadFonts();
    }
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    guarded([&] { drawFrame(); });
    drawer_.setVision(state_.view.vision);
    ImGui::Render();
    const double built = now();
    times_.panels = built - start - times_.state;
    present();
    times_.present = now() - built;
    deadline_ = now() + frame_.wakeIn();
    if (state_.panels.picture) preview_.takeWindow(drawer_, *ImGui::GetDrawData());
    guarded([&] { pictures_.update(state_, sides_, frame_.scale()); });
    if (failures_ == failuresBefore) failures_ = 0;
    answerRequests();
    writeProbe();
  }

  void drawFrame() {
    try {
      frame_.draw(&sides_, &uv_, &preview_);
    } catch (...) {
      // Windows that were begun are ended, so that the next frame begins as usual.
      ImGui::ErrorCheckEndFrameRecover(nullptr);
      throw;
    }
  }

  void present() {
    drawn_ = false;
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_.get(), &width, &height);
    if (width <= 0 || height <= 0) return;
    const ImDrawData& data = *ImGui::GetDrawData();
    if (width != canvas_.width() || height != canvas_.height()) {
      canvas_ = gl::Framebuffer(width, height, 1);
      canvas_.bindForDrawing();
      glClearColor(0, 0, 0, 1);
      glClear(GL_COLOR_BUFFER_BIT);
      damage_.forget();
    }
    if (std::exchange(shownVision_, state_.view.vision) != state_.view.vision) damage_.forget();
    const std::vector<PixelRectangle> parts = damage_.changed(data);
    drawn_ = !parts.empty();
    if (!drawn_) return;
    canvas_.bindForDrawing();
    drawer_.draw(data, parts);
    canvas_.resolve();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glfwSwapBuffers(window_.get());
  }

  void answerRequests() {
    if (state_.requests.clipboard) {
      glfwSetClipboardString(window_.get(), state_.requests.clipboard->c_str());
      state_.requests.clipboard.reset();
    }
    if (state_.requests.toggleFullScreen) toggleFullScreen();
    state_.requests.toggleFullScreen = false;
    const std::string model = state_.modelName();
    const std::string title =
        model.empty() ? "chartflood" : model + (state_.unsaved() ? " *" : "") + " - chartflood";
    if (title != title_) glfwSetWindowTitle(window_.get(), title.c_str());
    title_ = title;
  }

  void toggleFullScreen() {
    if (glfwGetWindowMonitor(window_.get()) != nullptr) {
      glfwSetWindowMonitor(window_.get(), nullptr, windowed_.x, windowed_.y, windowed_.width,
                           windowed_.height, GLFW_DONT_CARE);
      return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) return;
    glfwGetWindowPos(window_.get(), &windowed_.x, &windowed_.y);
    glfwGetWindowSize(window_.get(), &windowed_.width, &windowed_.height);
    glfwSetWindowMonitor(window_.get(), monitor, 0, 0, mode->width, mode->height,
                         mode->refreshRate);
  }

  void rememberSize() {
    if (glfwGetWindowMonitor(window_.get()) != nullptr) return;
    glfwGetWindowSize(window_.get(), &state_.preferences.windowWidth,
                      &state_.preferences.windowHeight);
  }

  /// Complete at any moment: written aside and renamed.
  void writeProbe() {
    if (watch_.probeFile.empty()) return;
    const std::filesystem::path aside = watch_.probeFile.string() + ".part";
    std::ofstream(aside) << frame_.probe().json();
    std::error_code ignored;  // the next frame writes again
    std::filesystem::rename(aside, watch_.probeFile, ignored);
  }

  AppState& state_;
  const ActionRegistry& actions_;
  WindowWatch watch_;
  Glfw glfw_;
  WindowHandle window_;
  Callbacks callbacks_;
  Imgui imgui_;
  Frame frame_;
  ImguiGl drawer_;
  SceneView scene_;
  CompareScene sides_{scene_, wakeWindow};
  UvView uv_{scene_};
  PicturePreview preview_{sides_, uv_};
  PictureTaker pictures_;
  std::ofstream frameLog_;
  WindowedPlace windowed_;
  std::string title_;
  gl::Framebuffer canvas_;  ///< the window as it was drawn last; frames change parts of it
  FrameDamage damage_;
  ColorVision shownVision_ = ColorVision::Full;
  int framesLeft_ = kSettlingFrames;
  double deadline_ = 0;
  PassTimes times_;
  double passSeconds_ = 0;
  int failures_ = 0;            ///< since the last pass without one
  bool drawn_ = false;          ///< the last pass changed the window
  double rested_ = 0;           ///< when the next pass may begin
  bool pictureWaited_ = false;  ///< the 3D view was left for the next turn
};

Window::Parts::Callbacks::Callbacks(Parts& parts) {
  GLFWwindow* window = parts.window_.get();
  glfwSetWindowUserPointer(window, &parts);
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
    of(w).onKey(key, scancode, action, modifiers);
  });
  glfwSetDropCallback(
      window, [](GLFWwindow* w, int count, const char** paths) { of(w).onDrop(count, paths); });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned) { of(w).touched(); });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { of(w).touched(); });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { of(w).touched(); });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int, int, int) { of(w).touched(); });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double) { of(w).touched(); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { of(w).touched(); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).damaged(); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).damaged(); });
  glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { of(w).touched(); });
}

Window::Window(AppState& state, const ActionRegistry& actions, const WindowWatch& watch)
    : parts_(std::make_unique<Parts>(state, actions, watch)) {}

Window::~Window() = default;

void Window::run() { parts_->run(); }

}  // namespace chartflood
