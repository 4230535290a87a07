#pragma once
/// Takes the pictures that were asked for: drawn by the renderer, written by another thread.

#include <filesystem>
#include <functional>
#include <future>
#include <string>

#include "app/gui/compare_scene.h"
#include "app/host/app_state.h"
#include "render/image.h"

namespace chartflood {

class PictureTaker {
 public:
  /// `wake` is called from another thread when a file is written.
  explicit PictureTaker(std::function<void()> wake);
  /// Waits for the last file.
  ~PictureTaker();
  PictureTaker(const PictureTaker&) = delete;
  PictureTaker& operator=(const PictureTaker&) = delete;

  /// Takes what the state asks for, with a current GL context, and says what became of it.
  void update(AppState& state, CompareScene& scene, float pixelScale);

 private:
  /// What a written file or a failure has to say.
  struct Outcome {
    bool written = false;
    std::string sentence;
  };

  void take(const AppState& state, CompareScene& scene, const PictureRequest& request,
            float pixelScale);
  /// Has the picture written by another thread.
  void write(const AppState& state, const PictureRequest& request, Image image);
  void report(AppState& state);

  std::function<void()> wake_;
  std::future<Outcome> writing_;
};

}  // namespace chartflood
