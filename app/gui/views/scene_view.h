#pragma once
/// The 3D view's picture: keeps the renderer's copy of the results up to date and draws only when
/// something that can be seen has changed. A slow picture is drawn piece by piece behind the last
/// finished one, so that the window always answers.

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include <imgui.h>

#include "app/host/state/app_state.h"
#include "app/host/state/compare_look.h"
#include "render/gl/framebuffer.h"
#include "render/passes/renderer.h"

namespace chartflood {

/// What the scene panel needs of a picture; tests without GL use one of their own.
class SceneSource {
 public:
  virtual ~SceneSource() = default;
  /// The picture at this size in pixels. While `moving` it may be drawn with less smoothing.
  virtual ImTextureID picture(const AppState& state, int width, int height, float pixelScale,
                              bool moving) = 0;
  /// What is under a pixel of the last picture, counted from its top left.
  virtual Pick pick(int x, int y) = 0;
  /// Colour of each chart in the picture, sRGB in [0, 1]; empty: not known.
  virtual std::vector<glm::vec3> chartColors(const AppState&) const { return {}; }
  /// Number of each chart's colour in the palette; empty while the model is not drawn.
  virtual std::vector<Index> chartColorNumbers(const AppState&) const { return {}; }
  /// What draws a half of a comparison.
  virtual SceneSource* side(const AppState&, ComparePane) { return this; }
};

/// The settings of the picture that shows the state now: playhead, selection, hover.
RenderSettings sceneSettings(const AppState& state, float pixelScale);

/// The seeds as they are to be marked: locked, under the mouse, on their way.
std::vector<SeedMark> seedMarks(const AppState& state);

class SceneView : public SceneSource {
 public:
  /// Needs a current GL context, now and in every call. `wake` is called from another thread when
  /// something new can be drawn.
  explicit SceneView(std::function<void()> wake);

  /// From now on shows this half of a comparison, or the live state as ever.
  void setPane(ComparePane pane) { pane_ = pane; }
  /// Takes in what is new, unless a picture is under way.
  void prepare(const AppState& state);
  /// The same with all that threads of their own are still making of it, for pictures that are
  /// kept.
  void catchUp(const AppState& state);
  /// The scale of colours that the half has by itself; nothing for modes without one.
  std::optional<ScalarRange> ownRange(const AppState& state) const;
  /// The ends that all halves share; nothing: each its own.
  void setSharedRange(std::optional<std::pair<double, double>> range) { sharedRange_ = range; }
  /// What a picture of the half is drawn with.
  RenderSettings settings(const AppState& state, float pixelScale) const;

  ImTextureID picture(const AppState& state, int width, int height, float pixelScale,
                      bool moving) override;
  Pick pick(int x, int y) override;
  std::vector<glm::vec3> chartColors(const AppState& state) const override;
  std::vector<Index> chartColorNumbers(const AppState& state) const override;

  /// True while a slow picture is on its way: call goOn() until it is done.
  bool busy() const { return pending_.has_value(); }
  /// Draws on for a moment; true when there is a new picture to show.
  bool goOn();

  Renderer& renderer() { return renderer_; }
  /// Grows with everything that the renderer was given.
  std::uint64_t content() const { return content_; }
  /// Whether the texture that was taken in is that of the state's results.
  bool showsTextureOf(const AppState& state) const {
    return atlas_ == state.results().atlas && !flat_.valid();
  }
  /// Size of the last picture.
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  /// Everything a picture depends on.
  struct Shown {
    RenderSettings settings;
    Camera camera;
    int width = 0, height = 0, samples = 0;
    SurfaceForm form = SurfaceForm::Whole;
    std::uint64_t content = 0;

    bool operator==(const Shown&) const = default;
  };

  void takeIn(const AppState& state);
  void takeMesh(const AppState& state, const Results& results);
  void takeDerived(const AppState& state, const Results& results);
  void showDerived(std::shared_ptr<const SurfaceDerived> derived,
                   std::shared_ptr<const SurfaceVertices> parted);
  void showScene(const AppState& state);
  void keepColors(const AppState& state, const Results& results);
  void takeFlood(std::shared_ptr<const FloodRecord> record);
  void takeBorders(const AppState& state);
  void takeAreas(const AppState& state);
  void takeSeeds(const AppState& state);
  void takeFilm(const AppState& state);
  void takeHints(const AppState& state);
  void takeMarks(const AppState& state, const Results& results);
  void takeUnwrap(const Results& results);
  void takeDistortion(const Results& results);
  void takeSimple(const AppState& state);
  int samplesFor(bool moving) const;
  Camera shownCamera(const AppState& state) const;
  SurfaceForm formFor(const AppState& state, int samples) const;
  bool& coarse(SurfaceForm form) { return coarse_[form == SurfaceForm::Simple ? 1 : 0]; }
  void begin(const Shown& wanted);

  Renderer renderer_;
  std::function<void()> wake_;
  ComparePane pane_;
  std::optional<std::pair<double, double>> sharedRange_;
  gl::Framebuffer front_, back_;            ///< what is shown, and what is being drawn
  std::optional<Shown> shown_;              ///< in front_
  std::optional<Shown> pending_;            ///< begun in back_
  int frontSamples_ = 0, backSamples_ = 0;  ///< as asked for: drivers may give others
  double pendingSeconds_ = 0;               ///< that the pending one has taken so far
  std::uint64_t content_ = 0;               ///< grows with every upload
  int width_ = 1, height_ = 1;

  render::Scene scene_;  ///< what the renderer is to show
  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const Segmentation> segmentation_;
  /// Of the moment of the refinement whose labels are shown; null: the finished ones.
  std::shared_ptr<const ChartStats> borders_;
  std::shared_ptr<const ChartStats> stats_;  ///< whose areas colour the balance
  std::shared_ptr<const FloodRecord> record_;
  bool floodTaken_ = true;  ///< all of it is drawn from
  std::vector<SeedMark> seeds_;
  unsigned recolored_ = 0;    ///< of the colours taken over from the state
  bool filmShown_ = false;    ///< lines of a film are drawn
  std::size_t filmStep_ = 0;  ///< of these lines
  struct HintsShown {
    EdgeHints hints;
    std::vector<Index> stroke;
    HintBrush brush = HintBrush::Cut;
    bool operator==(const HintsShown&) const = default;
  };
  std::optional<HintsShown> hintsShown_;  ///< lines of hints that are drawn; nothing: unknown
  std::shared_ptr<const SurfaceDerived> derived_;  ///< uploaded
  std::shared_ptr<const TriangleTree> tree_;       // null until picks can be answered
  std::shared_ptr<const SurfaceMarks> marks_;      ///< uploaded

  /// Vertices with texture places, worked out by a thread of its own when normals change.
  struct Parting {
    std::shared_ptr<const SurfaceDerived> derived;
    std::shared_ptr<const UvLayout> layout;
    std::shared_ptr<const SurfaceVertices> vertices;
  };
  std::future<Parting> parting_;
  /// The same when texture places change, with cuts.
  struct Flat {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const UvLayout> layout;
    std::vector<Index> cuts;
    std::shared_ptr<const SurfaceVertices> vertices, parted;  ///< null: not made yet
  };
  std::future<Flat> flat_;
  std::shared_ptr<const ChartSet> chartSet_;  ///< of the last one asked for
  std::shared_ptr<const Atlas> atlas_;

  std::shared_ptr<const Mesh> warmedFor_;  ///< whose shaders are translated

  double smoothSeconds_ = 0, lastSeconds_ = 0;
  bool coarse_[2] = {};  ///< pictures of each form in motion are drawn at half the size
  bool slow_ = false;    ///< pictures of the whole surface are, of this mesh

  /// Fewer triangles for pictures in motion, worked out by a thread of its own.
  struct Simplified {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const SurfaceDerived> derived;
    std::shared_ptr<const UvLayout> layout;
    std::shared_ptr<const SimpleSurface> surface;
  };
  std::future<Simplified> simplifying_;
  /// What the one asked for last is made of.
  std::shared_ptr<const SurfaceDerived> simpleOf_;
  std::shared_ptr<const UvLayout> simpleLayout_;
};

}  // namespace chartflood
