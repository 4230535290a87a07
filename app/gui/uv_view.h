#pragma once
/// The texture's picture: drawn by the 3D view's renderer, so that both show the same data, and
/// only when something that can be seen has changed.

#include <cstdint>
#include <optional>

#include <imgui.h>

#include "app/gui/scene_view.h"
#include "app/host/app_state.h"
#include "render/gl/framebuffer.h"

namespace chartflood {

/// What the UV panel needs of a picture; tests without GL use one of their own.
class UvSource {
 public:
  virtual ~UvSource() = default;
  /// Whether charts lie flat.
  virtual bool ready(const AppState& state) const = 0;
  /// The picture at this size in pixels. `elsewhere`: something else moves just now, so that a slow
  /// picture may stay as it was.
  virtual ImTextureID picture(const AppState& state, int width, int height, float pixelScale,
                              bool elsewhere) = 0;
  /// What is under a pixel of the last picture, counted from its top left.
  virtual Pick pick(int x, int y) = 0;
};

/// The settings of the picture that shows the state now.
RenderSettings uvSettings(const AppState& state, float pixelScale);

class UvView : public UvSource {
 public:
  /// Needs the scene's GL context in every call; the scene takes the results in.
  explicit UvView(SceneView& scene) : scene_(scene) {}

  bool ready(const AppState& state) const override;
  ImTextureID picture(const AppState& state, int width, int height, float pixelScale,
                      bool elsewhere) override;
  Pick pick(int x, int y) override;

 private:
  /// Everything a picture depends on.
  struct Shown {
    RenderSettings settings;
    UvStyle style;
    UvCamera camera;
    int width = 0, height = 0, samples = 0;
    std::uint64_t content = 0;

    bool operator==(const Shown&) const = default;
  };

  void draw(const Shown& wanted);

  SceneView& scene_;
  gl::Framebuffer target_;
  std::optional<Shown> shown_;
  double seconds_ = 0;  ///< that the last picture took
};

}  // namespace chartflood
