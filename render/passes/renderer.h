#pragma once
/// Draws a mesh, its Gauss area, its charts and the flood that made them.

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/model/mesh.h"
#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/passes/chart_layer.h"
#include "render/passes/cut_layer.h"
#include "render/passes/flood_layer.h"
#include "render/passes/gauss_layer.h"
#include "render/passes/mark_layer.h"
#include "render/passes/overlay.h"
#include "render/passes/surface_mesh.h"
#include "render/passes/uv_layer.h"
#include "render/scene/camera.h"
#include "render/scene/eye.h"
#include "render/scene/label_places.h"
#include "render/scene/pick.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene.h"
#include "render/scene/uv_camera.h"

namespace chartflood {

/// With what a picture shows the surface.
enum class SurfaceForm {
  Whole,
  Simple,  ///< that of the scene, where it has one
};

/// Every call needs the context in which the renderer was made to be current. Nothing is uploaded
/// by draw() but the chart colours when they change.
class Renderer {
 public:
  Renderer();

  /// Takes in what is another value than in the scene before: equal pointers cost nothing. Of a
  /// long flood at most so many entries are taken in by one call; false when some are left for the
  /// next one. \throws Error where a part cannot be of the mesh
  bool show(const render::Scene& scene, std::size_t mostOfFlood = kWholeFlood);
  static constexpr std::size_t kWholeFlood = static_cast<std::size_t>(-1);
  /// What was taken in last.
  const render::Scene& scene() const { return scene_; }

  bool hasSimpleSurface() const;
  /// Pixels that its details take in such a picture; 0 without one.
  double simpleDetail(const Camera& camera, const PicturePart& part) const;

  /// False while a mode has nothing to show; draw() then shows the plain surface.
  bool canShow(ColorMode mode) const;
  /// The range, scale and words of a picture's scalar bar; nothing for modes without one.
  std::optional<ScalarRange> scalarRange(const RenderSettings& settings) const;

  /// Share of a picture's width that the scalar bar takes on the right; 0 without one.
  double scalarBarShare(const RenderSettings& settings, int width) const;

  /// Draws into the framebuffer; its texture is ready afterwards (colour premultiplied by alpha).
  void draw(const gl::Framebuffer& target, const Camera& camera, const RenderSettings& settings);
  /// Draws one part of a picture into a framebuffer of the part's size.
  void draw(const gl::Framebuffer& target, const Camera& camera, const RenderSettings& settings,
            const PicturePart& part);

  /// Draws the texture: charts laid flat, in the colours of the mode. Nothing but the ground
  /// without a layout. Light and seeds are left out, hidden charts too.
  void drawUv(const gl::Framebuffer& target, const UvCamera& camera, const RenderSettings& settings,
              const UvStyle& style);
  void drawUv(const gl::Framebuffer& target, const UvCamera& camera, const RenderSettings& settings,
              const UvStyle& style, const PicturePart& part);

  /// Begins a picture that continueDrawing() draws piece by piece, so that a slow driver never
  /// holds up the caller. An unfinished one is dropped, as it is by draw() and by another mesh. The
  /// framebuffer must stay where it is until then.
  void beginDrawing(const gl::Framebuffer& target, const Camera& camera,
                    const RenderSettings& settings, const PicturePart& part,
                    SurfaceForm form = SurfaceForm::Whole);
  /// The same for a picture of the texture.
  void beginDrawingUv(const gl::Framebuffer& target, const UvCamera& camera,
                      const RenderSettings& settings, const UvStyle& style,
                      const PicturePart& part);
  /// Goes on for about so many seconds, by what the driver has really done; true when the picture
  /// is ready or none was begun.
  bool continueDrawing(double seconds);
  /// Has the driver translate the shaders that these settings need, with and without a playhead:
  /// software drivers take a tenth of a second for each, which nobody should wait for in a flood.
  void warmUp(const RenderSettings& settings, std::span<const int> samples,
              SurfaceForm form = SurfaceForm::Whole);
  /// True while a picture waits for continueDrawing().
  bool drawing() const { return unfinished_.has_value(); }
  /// True while it is the one in this framebuffer.
  bool drawing(const gl::Framebuffer& target) const {
    return unfinished_ && unfinished_->target == &target;
  }

  /// Triangle in each pixel, rows from the top, kNone where there is none.
  std::vector<Index> triangleImage(const Camera& camera, int width, int height);
  /// One place for the number of each chart that is visible with room for it.
  std::vector<ChartLabel> chartLabels(const Camera& camera, const RenderSettings& settings,
                                      int width, int height);

  /// What lies under pixel (x, y), counted from the top left, of a picture of the texture; `point`
  /// is the place on the surface. Charts that the last draw() hid are seen through.
  Pick pickUv(const UvCamera& camera, int width, int height, int x, int y);
  std::vector<Index> triangleImage(const UvCamera& camera, int width, int height);

  bool hasUv() const { return uv_.has_value(); }
  /// What pictures of the texture are drawn from; null without a texture.
  std::shared_ptr<const UvLayout> textureLayout() const {
    return uv_ ? uv_->sharedLayout() : nullptr;
  }
  const Mesh* mesh() const { return mesh_.get(); }
  const BoundingSphere& bounds() const { return bounds_; }
  /// Colour of a chart as drawn, sRGB in [0, 1]; grey for a chart not known yet.
  glm::vec3 chartColor(Index chart, const RenderSettings& settings) const;
  /// Number of each chart's colour in the palette.
  std::span<const Index> chartColorNumbers() const;

 private:
  /// Values of a mode, worked out when they are first drawn.
  struct ValueLayer {
    ModeSource of;
    std::vector<float> values;
    ScalarRange range;
    gl::TextureBuffer onCard;  ///< of triangles, once they are drawn
  };
  /// What the passes of one picture share.
  struct Frame {
    const RenderSettings& settings;
    Eye eye;
    float dash = 0;          ///< a dash and a gap of a cut, in units of the eye's space
    bool inTexture = false;  ///< triangles stand where the texture has them
    bool simple = false;     ///< the simple form of the surface
    glm::vec2 origin{0};     ///< of the part in the picture, pixels from its bottom left
  };

  /// A picture on its way.
  struct Unfinished {
    const gl::Framebuffer* target;
    Camera camera;
    RenderSettings settings;
    PicturePart part;
    bool inTexture = false;
    UvCamera uvCamera = {};  ///< of a picture of the texture
    UvStyle uvStyle = {};
    bool simple = false;  ///< as in Frame
    std::size_t nextTriangle = 0;
    std::size_t pieceSize = 16'000;  ///< triangles, by what the last piece took
  };

  Frame frameOf(const Unfinished& picture) const;
  void begin(Unfinished picture);
  void finishScene(const Frame& frame, const Camera& camera);
  void finishUv(const Frame& frame, const Unfinished& picture);
  static float dashLength(float pixel, const RenderSettings& settings);
  Index shownChart(Index triangle, const RenderSettings& settings) const;
  unsigned hoveredChart(const RenderSettings& settings) const;
  void showMesh(const render::Scene& scene);
  void showVertices(const render::Scene& before);
  void showCharts(const render::Scene& before);
  bool showFlood(const render::Scene& before, std::size_t most);
  void showLines(const render::Scene& before);
  ValueLayer& valuesOf(ColorMode mode) const;

  void drawBackground(const Frame& frame);
  std::size_t drawnTriangles(const Frame& frame) const;
  /// Draws up to so many triangles from `first` on; returns the first one that is left.
  std::size_t drawSurface(const Frame& frame, std::size_t first, std::size_t count);
  bool drawSurfacePieces(const Frame& frame, Unfinished& picture, double seconds);
  void updateCharts(const RenderSettings& settings);
  SurfaceFill fillOf(const RenderSettings& settings) const;
  gl::Program& surfaceProgram(const Frame& frame);
  void setChecker(gl::Program& program, const RenderSettings& settings);
  void bindCheckerPicture(std::shared_ptr<const Image> picture);
  void setFill(gl::Program& program, const Frame& frame);
  void drawLines(const Frame& frame);
  void drawSegments(const Frame& frame, std::size_t count, const glm::vec2& widths,
                    const glm::vec4& color, float dash = 0, std::size_t first = 0);
  /// Cuts from the segments on unit kValues, without those of hidden charts.
  void drawCuts(const Frame& frame, const std::vector<Index>& triangleOf, float width);
  void drawMarkLines(const Frame& frame);
  void setTriangleMarks(gl::Program& program, const Frame& frame);
  void drawUvGround(const Frame& frame, const UvCamera& camera);
  void drawUvLines(const Frame& frame, const UvStyle& style);
  void drawUvOutline(const Frame& frame, const SegmentRange& range, float width);
  void addUvTicks(const Frame& frame, const UvCamera& camera);
  void addUvNumbers(const Frame& frame, const UvCamera& camera);
  void drawMarks(const Frame& frame);
  void uploadSeeds(const RenderSettings& settings);
  void drawOverlay(const Frame& frame, const Camera& camera);
  void addScalarBar(const Frame& frame, const ScalarRange& range);
  void addNumbers(const Frame& frame, const Camera& camera);
  void setScale(gl::Program& program, const ScalarRange& range, const RenderSettings& settings);
  void useColorMap(const RenderSettings& settings);
  std::vector<GLuint> drawIds(gl::Program& program, const Eye& eye, int width, int height,
                              const RenderSettings& settings);

  gl::Program backgroundProgram_, lineProgram_, pointProgram_, idProgram_, idUvProgram_;
  std::map<std::vector<std::string>, gl::Program> surfacePrograms_;  // by their macros
  gl::VertexArray emptyVertexArray_;
  gl::Texture colorMap_;
  std::string loadedMap_;
  Overlay overlay_;

  render::Scene scene_;
  std::shared_ptr<const Mesh> mesh_;
  BoundingSphere bounds_;
  std::optional<SurfaceMesh> surface_;
  std::optional<ChartLayer> charts_;
  std::optional<FloodLayer> flood_;
  std::optional<GaussLayer> gauss_;
  mutable std::map<ColorMode, ValueLayer> values_;
  std::optional<UvLayer> uv_;
  std::optional<CutLayer> cuts_;
  /// Lines on the graphics card.
  struct LineLayer {
    CutLayer edges;
    EdgeLines look;  ///< without its sides
  };
  std::vector<LineLayer> lines_;
  std::optional<MarkLayer> marks_;
  gl::TextureBuffer seeds_, checkerGlyphs_;
  gl::Texture checkerPicture_;
  std::shared_ptr<const Image> loadedPicture_;  // in checkerPicture_
  RenderSettings lastSettings_;  // of the last picture: what is hidden there cannot be picked
  std::vector<glm::vec4> uploadedSeeds_;
  std::optional<Unfinished> unfinished_;
};

}  // namespace chartflood
