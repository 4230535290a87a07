#pragma once
/// Takes the pictures that were asked for: drawn by the renderer, written by another thread. Of a
/// row one is taken at a time, between the window's own pictures.

#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "app/gui/views/compare_scene.h"
#include "app/host/files/picture_record.h"
#include "app/host/state/app_state.h"
#include "render/scene/image.h"

namespace chartflood {

class PictureTaker {
 public:
  /// `wake` is called from another thread when a file is written. `window` gives the window as it
  /// is; without it there are no pictures of that.
  explicit PictureTaker(std::function<void()> wake, std::function<Image()> window = {});
  /// Waits for the last file.
  ~PictureTaker();
  PictureTaker(const PictureTaker&) = delete;
  PictureTaker& operator=(const PictureTaker&) = delete;

  /// Takes what the state asks for, with a current GL context, and says what became of it.
  void update(AppState& state, CompareScene& scene, float pixelScale);

  /// What was drawn, where the same picture can be taken again from it.
  struct Taken {
    std::optional<ViewSettings> shown;
    PictureRecord record;
    std::string notHeld;  ///< what the session of `shown` does not lead back to, "" for nothing
    ImageTexts sides;     ///< of a comparison: how each half was made
  };

 private:
  /// What a written file or a failure has to say.
  struct Outcome {
    bool written = false;
    std::string sentence;
  };

  /// A row of pictures under way.
  struct Row {
    PictureRequest request;
    Camera camera;                           ///< as it was at the beginning
    std::shared_ptr<const Results> results;  ///< that all pictures show
    std::filesystem::path folder;
    int next = 0;
  };

  void beginRow(AppState& state, const PictureRequest& request);
  void goOn(AppState& state, CompareScene& scene, float pixelScale);
  void endRow(AppState& state, const std::string& why);
  void take(const AppState& state, CompareScene& scene, const PictureRequest& request,
            float pixelScale);
  /// Has the picture written by another thread.
  void write(const AppState& state, const PictureRequest& request, Image image, const Taken& taken);
  void report(AppState& state);

  std::function<void()> wake_;
  std::function<Image()> window_;
  std::future<Outcome> writing_;
  std::optional<Row> row_;
};

}  // namespace chartflood
