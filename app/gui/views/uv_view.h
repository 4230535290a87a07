#pragma once
/// The texture's picture: drawn by the 3D view's renderer, so that both show the same data, and
/// only when something that can be seen has changed. A slow picture is drawn piece by piece; until
/// it is there the last one is shown where the new camera has it.

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <imgui.h>

#include "app/gui/views/scene_view.h"
#include "app/host/state/app_state.h"
#include "render/gl/framebuffer.h"

namespace chartflood {

/// A finished picture and what it was taken with.
struct UvPicture {
  ImTextureID texture = nullptr;
  UvCamera camera;
  int width = 1, height = 1;
};

/// What is pointed at, in texture places. It is drawn over the picture, which stays as it is.
struct UvHighlight {
  std::vector<glm::vec2> outline;  ///< of the chart: two a line
  std::vector<glm::vec2> face;     ///< three a triangle
};

/// What moves while a picture is asked for.
enum class UvMotion { None, Own, Elsewhere };

/// What the UV panel needs; tests without GL use one of their own.
class UvSource {
 public:
  virtual ~UvSource() = default;
  /// Whether charts lie flat.
  virtual bool ready(const AppState& state) const = 0;
  /// The newest picture for this size in pixels.
  virtual UvPicture picture(const AppState& state, int width, int height, float pixelScale,
                            UvMotion motion) = 0;
  /// What is under a pixel of a picture of that size, counted from its top left.
  virtual Pick pick(const AppState& state, int x, int y) = 0;
  virtual const UvHighlight& highlight(const AppState& state) = 0;
};

/// The settings of the picture that shows the state now.
RenderSettings uvSettings(const AppState& state, float pixelScale);

class UvView : public UvSource {
 public:
  /// Needs the scene's GL context in every call; the scene takes the results in.
  explicit UvView(SceneView& scene) : scene_(scene) {}

  bool ready(const AppState& state) const override;
  UvPicture picture(const AppState& state, int width, int height, float pixelScale,
                    UvMotion motion) override;
  Pick pick(const AppState& state, int x, int y) override;
  const UvHighlight& highlight(const AppState& state) override;

  /// As in SceneView, which goes first.
  bool busy() const { return pending_.has_value(); }
  bool goOn();

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

  void begin(const Shown& wanted);

  SceneView& scene_;
  gl::Framebuffer front_, back_;
  int backSamples_ = 0, frontSamples_ = 0;
  std::optional<Shown> shown_, pending_;
  int width_ = 1, height_ = 1;
  double pendingSeconds_ = 0, smoothSeconds_ = 0, lastSeconds_ = 0;
  UvHighlight highlight_;
  Index highlightFace_ = kNone;
  std::uint64_t highlightContent_ = 0;
};

}  // namespace chartflood
