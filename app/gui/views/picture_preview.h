#pragma once
/// The small picture in the dialog of pictures: what would be saved, drawn at its own size piece by
/// piece after the views, so that nothing stutters for it.

#include <array>
#include <chrono>
#include <optional>
#include <vector>

#include <imgui.h>

#include "app/gui/views/picture_pieces.h"
#include "app/gui/views/uv_view.h"
#include "render/gl/framebuffer.h"

namespace chartflood {

class ImguiGl;

inline constexpr const char* kPictureDialog = "Picture";  ///< name of the dialog's window

/// A part of the preview: columns of a texture, as shares of both their widths.
struct PreviewPart {
  ImTextureID texture = nullptr;
  float left = 0, right = 1;  ///< in the preview
  float from = 0, to = 1;     ///< in the texture
};

/// What the dialog needs; tests without GL use one of their own.
class PreviewSource {
 public:
  virtual ~PreviewSource() = default;
  /// The newest preview of a picture that is `extent` large, in so many pixels; empty before there
  /// is one.
  virtual std::vector<PreviewPart> preview(const AppState& state, const PictureExtent& extent,
                                           int width, int height, float pixelScale) = 0;
  /// False while it shows less than the newest.
  virtual bool upToDate() const = 0;
};

class PicturePreview : public PreviewSource {
 public:
  /// Needs a current GL context in every call.
  PicturePreview(CompareScene& scene, const UvView& uv) : scene_(scene), uv_(uv) {}

  std::vector<PreviewPart> preview(const AppState& state, const PictureExtent& extent, int width,
                                   int height, float pixelScale) override;
  bool upToDate() const override { return upToDate_; }

  /// As in SceneView; the views go first.
  bool busy() const { return pending_.has_value(); }
  bool goOn();

  /// Takes the window itself in as it has just been built, without the dialog.
  void takeWindow(ImguiGl& drawer, const ImDrawData& data);

 private:
  struct Slot {
    gl::Framebuffer front, back;
    std::optional<PicturePiece> shown;  ///< in `front`
  };

  void begin(std::size_t slot, const PicturePiece& piece);
  bool resting() const;

  CompareScene& scene_;
  const UvView& uv_;
  std::array<Slot, Compare::kMostPanes> slots_;
  std::optional<std::size_t> pending_;  ///< slot that is being drawn
  PicturePiece pendingPiece_;
  double pendingSeconds_ = 0, lastSeconds_ = 0;
  std::chrono::steady_clock::time_point readyAt_{};
  bool upToDate_ = false;
  gl::Framebuffer window_;
  int windowWidth_ = 0, windowHeight_ = 0;  ///< asked for last
};

/// True for what does not belong to a picture of the window: the dialog that takes it.
bool belongsToPictureDialog(const ImDrawList& list);

/// The window as built last, in its own pixels. \pre between ImGui::Render() and the next frame
Image windowImage(ImguiGl& drawer, const ImDrawData& data);

}  // namespace chartflood
