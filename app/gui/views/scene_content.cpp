// How the 3D view takes in what has changed in the state, so that each part of it goes to the
// graphics card once.

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/gui/views/drawing_budget.h"
#include "app/gui/views/scene_view.h"
#include "render/scene/chart_palette.h"
#include "render/scene/corner_uv.h"

namespace chartflood {

namespace {

constexpr std::size_t kFacesAtOnce = 30'000;  // of a flood's log taken in by one pass
constexpr std::size_t kSimple = 60'000;       // triangles of the simple surface
constexpr std::size_t kDense = 2 * kSimple;   // from which there is one

template <class Value>
std::shared_ptr<const Value> shared(Value value) {
  return std::make_shared<const Value>(std::move(value));
}

template <class Value>
bool isReady(const std::future<Value>& future) {
  return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

void SceneView::takeMesh(const AppState& state, const Results& results) {
  if (results.mesh == mesh_) return;
  mesh_ = results.mesh;
  scene_ = {};
  scene_.source.mesh = mesh_;
  if (pane_.live()) scene_.chartColors = shared(state.view.chartColors);
  recolored_ = state.view.recolored;
  segmentation_.reset();
  stats_.reset();
  record_.reset();
  derived_.reset();
  tree_.reset();
  marks_.reset();
  seeds_.clear();
  chartSet_.reset();
  atlas_.reset();
  hintsShown_.reset();
  simpleOf_.reset();
  simpleLayout_.reset();
  slow_ = false;
  shown_.reset();  // title and figures are the new model's already
  ++content_;
}

void SceneView::takeDerived(const AppState& state, const Results& results) {
  const bool shared = results.gaussArea == state.results().gaussArea;
  Insight& insight = shared ? state.insight() : paneInsight(state, pane_);
  if (!tree_) tree_ = insight.tree(results);
  const auto derived = insight.surface(results);
  if (!derived || derived == derived_) return;
  const auto layout = scene_.source.layout;
  if (!layout) return showDerived(derived, nullptr);
  // With a texture the vertices are parted beside the window; what is ready is shown, even when a
  // newer one is wanted by now.
  if (isReady(parting_)) {
    const Parting done = parting_.get();
    if (done.layout == layout) showDerived(done.derived, done.vertices);
  }
  if (derived == derived_ || parting_.valid()) return;
  parting_ = std::async(std::launch::async, [derived, layout, wake = wake_] {
    Parting done{derived, layout, partedVertices(*derived->vertices, layout->corners)};
    wake();
    return done;
  });
}

void SceneView::showDerived(std::shared_ptr<const SurfaceDerived> derived,
                            std::shared_ptr<const SurfaceVertices> parted) {
  derived_ = std::move(derived);
  scene_.vertices = derived_->vertices;
  scene_.parted = std::move(parted);
  scene_.source.gauss = derived_->gaussValues;
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
  scene_.lines = shared(std::move(lines));
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
  scene_.lines = shared(std::move(lines));
  hintsShown_ = std::move(wanted);
  ++content_;
}

void SceneView::takeFlood(std::shared_ptr<const FloodRecord> record) {
  if (record != record_) {
    record_ = std::move(record);
    floodTaken_ = false;
    ++content_;
  }
  const std::size_t recorded = record_ ? record_->size() : 0;
  if (scene_.source.record == record_ && scene_.source.recorded == recorded && floodTaken_) return;
  scene_.source.record = record_;
  scene_.source.recorded = recorded;
  ++content_;
}

/// Labels of a moment of the refinement, or the finished ones again.
void SceneView::takeBorders(const AppState& state) {
  std::shared_ptr<const ChartStats> moment;
  if (state.playback.inBorders() && segmentation_) moment = state.shownStats();
  if (moment == borders_) return;
  borders_ = moment;
  scene_.labels = nullptr;
  if (moment) {
    const auto labels = state.shownLabels();
    scene_.labels = shared(std::vector<Index>(labels.begin(), labels.end()));
  }
  ++content_;
}

/// Colours of balance are those of the moment.
void SceneView::takeAreas(const AppState& state) {
  const auto& stats = state.shownStats();
  if (!stats || stats == stats_) return;
  stats_ = stats;
  scene_.source.stats = stats;
  if (state.view.render.colorMode == ColorMode::Balance) ++content_;
}

void SceneView::takeSeeds(const AppState& state) {
  std::vector<SeedMark> marks =
      pane_.live() ? seedMarks(state) : state.compare.stored[pane_.stored].seeds;
  if (marks == seeds_) return;
  seeds_ = std::move(marks);
  scene_.seeds = shared(seeds_);
  ++content_;
}

/// Where values are answered with whole charts these look moved, not painted anew. Floods grow in
/// the colours of their seeds.
void SceneView::keepColors(const AppState& state, const Results& results) {
  const Segmentation *before = segmentation_.get(), *after = results.segmentation.get();
  const bool moves = pane_.live() && state.preferences.explore && state.showsFinal() &&
                     recolored_ == state.view.recolored && before != nullptr && before->complete &&
                     after != nullptr && after->complete;
  if (!moves) return;
  const auto numbers = renderer_.chartColorNumbers();
  const std::size_t known = std::min<std::size_t>(before->chartCount, numbers.size());
  scene_.chartColors = shared(inheritedColors(*mesh_, before->label, numbers.first(known),
                                              after->label, after->chartCount));
}

/// Only while they are shown: to find them takes as long as to flood a large model.
void SceneView::takeMarks(const AppState& state, const Results& results) {
  const bool shown =
      state.compare.showing() ? paneLook(state, pane_).problems : state.view.render.problems;
  if (!shown || (pane_.live() && state.playback.playing())) return;
  const auto wanted = paneInsight(state, pane_).problemMarks(results);
  if (wanted == marks_) return;
  marks_ = wanted;
  scene_.marks = marks_;
  ++content_;
}

void SceneView::takeUnwrap(const Results& results) {
  if (isReady(flat_)) {
    Flat flat = flat_.get();
    if (flat.mesh == mesh_ && atlas_) {
      const bool fits = derived_ && flat.vertices == derived_->vertices;
      scene_.cuts = shared(std::move(flat.cuts));
      scene_.source.layout = std::move(flat.layout);
      scene_.parted = fits ? std::move(flat.parted) : nullptr;
      scene_.simple = nullptr;
      ++content_;
    }
  }
  if ((results.atlas == atlas_ && results.charts == chartSet_) || flat_.valid()) return;
  atlas_ = results.atlas;
  chartSet_ = results.charts;
  if (!atlas_ || !chartSet_) {
    atlas_.reset();
    scene_.cuts = chartSet_ ? shared(cutSides(*chartSet_)) : nullptr;
    scene_.source.layout = nullptr;
    scene_.parted = nullptr;
    scene_.simple = nullptr;
    ++content_;
    return;
  }
  flat_ = std::async(std::launch::async, [mesh = mesh_, charts = chartSet_, atlas = atlas_,
                                          derived = derived_, wake = wake_] {
    Flat flat;
    flat.mesh = mesh;
    flat.layout =
        std::make_shared<const UvLayout>(uvLayout(*mesh, cornerUv(*mesh, *charts, *atlas)));
    flat.cuts = cutSides(*charts);
    if (derived) {
      flat.vertices = derived->vertices;
      flat.parted = partedVertices(*flat.vertices, flat.layout->corners);
    }
    wake();
    return flat;
  });
}

void SceneView::takeDistortion(const Results& results) {
  if (results.unwrap == scene_.source.unwrap) return;
  scene_.source.unwrap = results.unwrap;
  ++content_;
}

/// Where pictures are slow, fewer triangles are made ready for the next motion.
void SceneView::takeSimple(const AppState& state) {
  const auto layout = scene_.source.layout;
  if (isReady(simplifying_)) {
    const Simplified done = simplifying_.get();
    if (done.mesh == mesh_ && done.layout == layout) {
      coarse(SurfaceForm::Simple) = false;
      scene_.simple = done.surface;
    }
  }
  if (!slow_ || !derived_ || mesh_->triangleCount() < kDense || simplifying_.valid()) return;
  if (simpleOf_ == derived_ && simpleLayout_ == layout) return;
  // Normals of a moment ago are good enough while a slider moves them.
  if (renderer_.hasSimpleSurface() && state.changing()) return;
  simpleOf_ = derived_;
  simpleLayout_ = layout;
  simplifying_ =
      std::async(std::launch::async, [mesh = mesh_, derived = derived_, layout, wake = wake_] {
        Simplified done{mesh, derived, layout,
                        simpleSurface(*mesh, *derived->vertices, layout.get(), kSimple)};
        wake();
        return done;
      });
}

void SceneView::takeIn(const AppState& state) {
  const Results& results = paneResults(state, pane_);
  takeMesh(state, results);
  if (!mesh_) {
    renderer_.show(scene_);
    return;
  }
  takeDerived(state, results);
  if (results.segmentation != segmentation_) {
    keepColors(state, results);
    segmentation_ = results.segmentation;
    scene_.source.segmentation = segmentation_;
    scene_.source.stats = nullptr;
    scene_.labels = nullptr;
    stats_.reset();
    borders_.reset();
    ++content_;
  }
  if (pane_.live() && recolored_ != state.view.recolored) {
    scene_.chartColors = shared(state.view.chartColors);
    recolored_ = state.view.recolored;
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
  takeSimple(state);
  showScene(state);
}

void SceneView::catchUp(const AppState& state) {
  const gl::FramebufferScope keep;
  pending_.reset();  // what it shows is older than what is asked for
  do {
    if (flat_.valid()) flat_.wait();
    if (parting_.valid()) parting_.wait();
    takeIn(state);
  } while (mesh_ && (flat_.valid() || parting_.valid() || !floodTaken_));
}

/// A whole flood at once would hold up the window; the rest comes with the next passes.
void SceneView::showScene(const AppState& state) {
  const bool simplified = scene_.simple != nullptr && scene_.simple != renderer_.scene().simple;
  floodTaken_ = renderer_.show(scene_, kFacesAtOnce);
  if (!floodTaken_) wake_();
  const int samples[] = {1, kSmoothSamples};
  if (derived_ && warmedFor_ != mesh_) {
    renderer_.warmUp(RenderSettings{}, samples);
    warmedFor_ = mesh_;
  }
  if (simplified) {
    renderer_.warmUp(settings(state, 1), std::span(samples, 1), SurfaceForm::Simple);
  }
}

}  // namespace chartflood
