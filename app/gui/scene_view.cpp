#include "app/gui/scene_view.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <epoxy/gl.h>

#include "app/gui/drawing_budget.h"
#include "app/gui/imgui_gl.h"
#include "render/corner_uv.h"

namespace chartflood {

namespace {

constexpr std::size_t kFacesAtOnce = 30'000;  // of a flood's log taken in by one pass
constexpr double kCoarseFrom = 0.045;         // slower plain pictures get half the size in motion
constexpr double kCoarseUntil = 0.012;        // quicker coarse ones get their full size back

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Value>
bool isReady(const std::future<Value>& future) {
  return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

RenderSettings sceneSettings(const AppState& state, float pixelScale) {
  RenderSettings settings = state.view.render;
  settings.background = shownGround(settings.background, state.preferences.theme);
  settings.pixelScale = pixelScale;
  settings.playhead.reset();
  if (!state.showsFinal() && !state.playback.inBorders()) {
    settings.playhead = state.playback.playhead();
    settings.front = !(state.playback.complete() && state.playback.atEnd());
  }
  if (state.playback.inBorders()) settings.cuts = false;  // they are of the finished charts
  settings.hoverFace = state.hoveredFace;
  settings.flashFace = state.flash.face();
  settings.hoverChart = state.pointedChart;
  settings.selectedCharts.clear();
  if (state.film.ready()) {
    settings.colorMode = ColorMode::Charts;
    settings.problems = false;
    settings.playhead = state.film.position();
    settings.front = true;
    return settings;
  }
  if (settings.playhead) settings.problems = false;  // they belong to the finished charts
  if (state.selectedChart != kNone) settings.selectedCharts.push_back(state.selectedChart);
  if (state.view.isolate && state.selectedChart != kNone && state.results().segmentation) {
    const std::size_t count = state.results().segmentation->chartCount;
    for (Index chart = 0; chart < count; ++chart) {
      if (chart != state.selectedChart) settings.hiddenCharts.push_back(chart);
    }
  } else {
    settings.hiddenCharts = state.view.hiddenCharts;
  }
  return settings;
}

std::vector<SeedMark> seedMarks(const AppState& state) {
  std::vector<SeedMark> marks;
  const Playback& playback = state.playback;
  const auto& history = state.results().history;
  const bool editing = state.panels.tool == PanelState::Tool::Seeds;
  if (!editing && playback.round() != state.results().recordIteration &&
      playback.round() < history.size()) {
    for (const Index face : history[playback.round()].seeds) {
      const auto chart = static_cast<Index>(marks.size());
      marks.push_back({face, chart, false, false, state.closedOff(chart)});
    }
    return marks;
  }
  for (const PlacedSeed& seed : state.presentSeeds()) {
    const auto number = static_cast<Index>(marks.size());
    const bool emphasis = number == state.hoveredSeed || number == state.chosenSeed;
    marks.push_back({seed.face, number, emphasis, seed.locked, state.closedOff(number)});
  }
  if (const auto& drag = state.seedDrag; drag && drag->seed < marks.size()) {
    marks[drag->seed].face = drag->face;
    marks[drag->seed].emphasis = true;
  }
  return marks;
}

SceneView::SceneView(std::function<void()> wake) : wake_(std::move(wake)) {}

void SceneView::takeMesh(const AppState& state, const Results& results) {
  if (results.mesh == mesh_) return;
  mesh_ = results.mesh;
  renderer_.setMesh(mesh_, nullptr);
  if (pane_.live()) renderer_.setChartColors(state.view.chartColors);
  segmentation_.reset();
  stats_.reset();
  record_.reset();
  derived_.reset();
  marks_.reset();
  seeds_.clear();
  chartSet_.reset();
  atlas_.reset();
  unwrap_.reset();
  hintsShown_.reset();
  ++content_;
}

void SceneView::takeDerived(const AppState& state, const Results& results) {
  if (results.gaussArea != state.results().gaussArea && !insight_) {
    insight_ = std::make_unique<Insight>(false);
    insight_->setWake(wake_);
  }
  const bool shared = results.gaussArea == state.results().gaussArea;
  const auto derived = (shared ? state.insight() : *insight_).surface(results);
  if (!derived || derived == derived_) return;
  derived_ = derived;
  renderer_.setNormals(&derived->normals);
  renderer_.setGaussValues(derived->gaussValues);
  const int samples[] = {1, kSmoothSamples};
  if (warmedFor_ != mesh_) renderer_.warmUp(RenderSettings{}, samples);
  warmedFor_ = mesh_;
  ++content_;
}

/// Fronts of the film in two colours that everyone can tell apart, what they remember dashed.
void SceneView::takeFilm(const AppState& state) {
  const bool shown = state.film.ready();
  if (shown == filmShown_ && (!shown || state.film.position() == filmStep_)) return;
  filmShown_ = shown;
  filmStep_ = state.film.position();
  hintsShown_.reset();  // they come back after the film
  std::vector<EdgeLines> lines;
  if (shown) {
    const HandleFilm::Lines& film = state.film.lines();
    lines.push_back({film.kept, glm::vec3(0.95f, 0.90f, 0.25f), 2.2f, true});
    lines.push_back({film.fronts, glm::vec3(1), 2.6f, false});
    lines.push_back({film.cuts, glm::vec3(0.84f, 0.37f, 0.0f), 3.4f, false});
  }
  renderer_.setLines(lines);
  ++content_;
}

/// Painted edges while the tool is in the hand: where seams are welcome whole, where not dashed.
void SceneView::takeHints(const AppState& state) {
  if (filmShown_) return;
  HintsShown wanted;
  if (state.panels.tool == PanelState::Tool::Hints) {
    wanted.hints = state.document().hints;
    if (state.hintStroke) wanted.stroke = state.hintStroke->vertices;
    wanted.brush = state.panels.brush;
  }
  if (hintsShown_ == wanted) return;
  std::vector<EdgeLines> lines;
  const glm::vec3 cut(0.25f, 0.88f, 0.95f), never(0.95f, 0.35f, 0.65f), erase(1);
  lines.push_back({hintSides(*mesh_, wanted.hints, HintKind::Cut), cut, 3.4f, false});
  lines.push_back({hintSides(*mesh_, wanted.hints, HintKind::Never), never, 3.4f, true});
  lines.push_back({sidesAlong(*mesh_, wanted.stroke),
                   wanted.brush == HintBrush::Cut     ? cut
                   : wanted.brush == HintBrush::Never ? never
                                                      : erase,
                   3.4f, wanted.brush == HintBrush::Never});
  std::erase_if(lines, [](const EdgeLines& each) { return each.sides.empty(); });
  renderer_.setLines(lines);
  hintsShown_ = std::move(wanted);
  ++content_;
}

void SceneView::takeFlood(std::shared_ptr<const FloodRecord> record) {
  if (record != record_) {
    record_ = std::move(record);
    recorded_ = 0;
    floodTaken_ = false;
    renderer_.setFlood(record_, 0);
    ++content_;
  }
  if (record_ && (record_->size() != recorded_ || !floodTaken_)) {
    recorded_ = record_->size();
    // A whole flood at once would hold up the window; the rest comes with the next passes.
    floodTaken_ = renderer_.updateFlood(kFacesAtOnce);
    if (!floodTaken_) wake_();
    ++content_;
  }
}

/// Labels of a moment of the refinement, or the finished ones again.
void SceneView::takeBorders(const AppState& state) {
  std::optional<std::size_t> step;
  if (state.playback.inBorders() && segmentation_) step = state.playback.borderStep();
  if (step == borderStep_) return;
  borderStep_ = step;
  renderer_.setLabels(step ? state.shownLabels() : std::span<const Index>(segmentation_->label));
  ++content_;
}

/// Colours of balance are those of the moment.
void SceneView::takeAreas(const AppState& state) {
  const auto& stats = state.shownStats();
  if (!stats || stats == stats_) return;
  stats_ = stats;
  std::vector<double> areas;
  for (const ChartFigures& chart : stats->charts) areas.push_back(chart.gaussArea);
  renderer_.setChartAreas(areas);
  if (state.view.render.colorMode == ColorMode::Balance) ++content_;
}

void SceneView::takeSeeds(const AppState& state) {
  std::vector<SeedMark> marks =
      pane_.live() ? seedMarks(state) : state.compare.stored[pane_.stored].seeds;
  if (marks == seeds_) return;
  seeds_ = std::move(marks);
  renderer_.setSeeds(seeds_);
  ++content_;
}

/// Only while they are shown: to find them takes as long as to flood a large model.
void SceneView::takeMarks(const AppState& state, const Results& results) {
  if (!state.view.render.problems || state.playback.playing()) return;
  std::shared_ptr<const SurfaceMarks> wanted;
  // Those of a stored result would be worked out in turn with the live ones, over and over.
  if (results.segmentation == state.results().segmentation) {
    wanted = state.insight().problemMarks(state.results());
  }
  if (wanted == marks_) return;
  marks_ = wanted;
  renderer_.setMarks(marks_ ? *marks_ : SurfaceMarks{});
  ++content_;
}

void SceneView::takeUnwrap(const Results& results) {
  if (isReady(flat_)) {
    Flat flat = flat_.get();
    if (flat.mesh == mesh_ && atlas_) {
      renderer_.setCuts(flat.cuts);
      renderer_.setUvLayout(std::move(flat.layout));
      ++content_;
    }
  }
  if ((results.atlas == atlas_ && results.charts == chartSet_) || flat_.valid()) return;
  atlas_ = results.atlas;
  chartSet_ = results.charts;
  if (!atlas_ || !chartSet_) {
    atlas_.reset();
    renderer_.setCuts(chartSet_ ? cutSides(*chartSet_) : std::vector<Index>{});
    renderer_.setCornerUv({});
    ++content_;
    return;
  }
  flat_ = std::async(
      std::launch::async, [mesh = mesh_, charts = chartSet_, atlas = atlas_, wake = wake_] {
        Flat flat{mesh, uvLayout(*mesh, cornerUv(*mesh, *charts, *atlas)), cutSides(*charts)};
        wake();
        return flat;
      });
}

void SceneView::takeDistortion(const Results& results) {
  if (results.unwrap == unwrap_) return;
  unwrap_ = results.unwrap;
  const auto show = [&](ColorMode mode, std::span<const float> values) {
    // A part that does not fit the mesh is none.
    const bool fits = values.size() == mesh_->triangleCount();
    renderer_.setTriangleValues(mode, fits ? values : std::span<const float>{});
  };
  static const Unwrap none;
  const Unwrap& unwrap = unwrap_ ? *unwrap_ : none;
  show(ColorMode::Stretch, unwrap.stretch);
  show(ColorMode::AreaDistortion, unwrap.area);
  show(ColorMode::AngleDistortion, unwrap.angle);
  ++content_;
}

void SceneView::takeIn(const AppState& state) {
  const Results& results = paneResults(state, pane_);
  takeMesh(state, results);
  if (!mesh_) return;
  takeDerived(state, results);
  if (results.segmentation != segmentation_) {
    segmentation_ = results.segmentation;
    renderer_.setSegmentation(segmentation_.get());
    stats_.reset();
    borderStep_.reset();
    ++content_;
  }
  if (pane_.live()) {
    takeFlood(state.film.ready() ? state.film.flood() : state.playback.record());
    takeBorders(state);
    takeAreas(state);
  } else {
    takeFlood(results.record);
  }
  takeSeeds(state);
  if (pane_.live()) takeFilm(state);
  if (pane_.live()) takeHints(state);
  takeMarks(state, results);
  takeUnwrap(results);
  takeDistortion(results);
}

void SceneView::prepare(const AppState& state) {
  const gl::FramebufferScope keep;
  // A picture under way shows the data that it was begun with, and is finished even when a newer
  // one is wanted: while things move none would ever be otherwise. Only another mesh ends it.
  if (!pending_ || paneResults(state, pane_).mesh != mesh_) takeIn(state);
}

RenderSettings SceneView::settings(const AppState& state, float pixelScale) const {
  if (!state.compare.showing()) return sceneSettings(state, pixelScale);
  RenderSettings settings = paneLook(state, pane_);
  settings.pixelScale = pixelScale;
  settings.playhead.reset();
  if (pane_.live()) {
    const RenderSettings live = sceneSettings(state, pixelScale);
    settings.playhead = live.playhead;
    settings.front = live.front;
    settings.flashFace = live.flashFace;
    settings.hiddenCharts = live.hiddenCharts;
    settings.hoverChart = live.hoverChart;
    if (state.film.ready()) settings.colorMode = live.colorMode;
  }
  if (sharedRange_ && !settings.range) settings.range = sharedRange_;
  return settings;
}

std::optional<ScalarRange> SceneView::ownRange(const AppState& state) const {
  if (!mesh_) return std::nullopt;
  return renderer_.scalarRange(paneLook(state, pane_));
}

int SceneView::samplesFor(bool moving) const {
  return moving && smoothSeconds_ > kSmoothWhileMoving ? 1 : kSmoothSamples;
}

void SceneView::begin(const Shown& wanted) {
  const bool fits = back_.width() == wanted.width && back_.height() == wanted.height &&
                    backSamples_ == wanted.samples;
  if (!fits) back_ = gl::Framebuffer(wanted.width, wanted.height, wanted.samples);
  backSamples_ = wanted.samples;
  renderer_.beginDrawing(back_, wanted.camera, wanted.settings,
                         PicturePart::whole(wanted.width, wanted.height));
  pending_ = wanted;
  pendingSeconds_ = 0;
}

bool SceneView::goOn() {
  if (!pending_) return false;
  const auto start = std::chrono::steady_clock::now();
  const bool ready = renderer_.continueDrawing(kSecondsAtOnce);
  if (ready) glFinish();  // the cost decides on the smoothing of the next pictures
  pendingSeconds_ += secondsSince(start);
  if (!ready) return false;
  if (pending_->samples == kSmoothSamples) {
    smoothSeconds_ = pendingSeconds_;
  } else {
    coarse_ = pendingSeconds_ > (coarse_ ? kCoarseUntil : kCoarseFrom);
  }
  lastSeconds_ = pendingSeconds_;
  // Only a picture of half the size is enlarged; pixel by pixel the nearest texel is exact and
  // cheap.
  const bool enlarged = pending_->width < width_;
  glBindTexture(GL_TEXTURE_2D, back_.texture());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, enlarged ? GL_LINEAR : GL_NEAREST);
  std::swap(front_, back_);
  std::swap(frontSamples_, backSamples_);
  shown_ = std::exchange(pending_, std::nullopt);
  return true;
}

ImTextureID SceneView::picture(const AppState& state, int width, int height, float pixelScale,
                               bool moving) {
  const gl::FramebufferScope keep;
  prepare(state);
  if (pending_ && !renderer_.drawing(back_)) pending_.reset();
  width_ = std::max(1, width);
  height_ = std::max(1, height);
  const int samples = samplesFor(moving);
  const int divisor = coarse_ && samples == 1 ? 2 : 1;
  Shown wanted{settings(state, pixelScale / static_cast<float>(divisor)),
               state.compare.showing() ? paneCamera(state, pane_) : state.view.camera,
               std::max(1, width_ / divisor),
               std::max(1, height_ / divisor),
               samples,
               content_};
  // Where pictures are slow, the mouse passing over the model must not cost one each time.
  if (smoothSeconds_ > kSmoothWhileMoving) wanted.settings.hoverFace = kNone;
  // A smooth picture gives way to motion.
  if (pending_ && samples < pending_->samples && *pending_ != wanted) pending_.reset();
  // A round that is still being taken in is shown when it is there as a whole.
  const bool takingIn = !floodTaken_ && !state.changing() && wanted.settings.playhead;
  if (!pending_ && !(takingIn && shown_) && (!shown_ || *shown_ != wanted)) {
    begin(wanted);
    // Quick drivers finish it at once; slow ones go on after the window was looked after.
    if (lastSeconds_ < kSecondsAtOnce) goOn();
  }
  return textureId(shown_ ? front_.texture() : back_.texture());
}

std::vector<glm::vec3> SceneView::chartColors(const AppState& state) const {
  std::vector<glm::vec3> colors;
  const Segmentation* labels = state.results().segmentation.get();
  const auto count = static_cast<Index>(labels == nullptr ? 0 : labels->chartCount);
  for (Index c = 0; c < count; ++c) {
    colors.push_back(renderer_.chartColor(c, state.view.render));
  }
  return colors;
}

std::vector<Index> SceneView::chartColorNumbers(const AppState& state) const {
  const Segmentation* labels = segmentation_.get();
  if (!mesh_ || state.results().mesh != mesh_ || labels == nullptr) return {};
  const auto numbers = renderer_.chartColorNumbers();
  const auto count = std::min<std::size_t>(labels->chartCount, numbers.size());
  return {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count)};
}

Pick SceneView::pick(int x, int y) {
  if (!shown_ || !mesh_) return {};
  const auto start = std::chrono::steady_clock::now();
  const gl::FramebufferScope keep;
  const Pick pick = renderer_.pick(shown_->camera, width_, height_, x, y);
  pickSeconds_ = secondsSince(start);
  return pick;
}

}  // namespace chartflood
