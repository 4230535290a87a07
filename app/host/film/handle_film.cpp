#include "app/host/film/handle_film.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/charts/chart_surface.h"
#include "core/charts/handle_cutter.h"

namespace chartflood {

/// The finished film; the playback refers to the other parts, which stay where they are.
struct HandleFilm::Reel {
  ChartSurface surface;
  HandleRecord record;
  std::shared_ptr<FloodRecord> flood;
  std::unique_ptr<HandlePlayback> playback;
  Lines lines;
  std::size_t linesOf = static_cast<std::size_t>(-1);  ///< step that `lines` belong to
};

std::unique_ptr<HandleFilm::Reel> HandleFilm::make(const Mesh& mesh, const Segmentation& labels,
                                                   Index chart, std::uint32_t seed,
                                                   const Progress& progress) {
  auto reel = std::make_unique<Reel>();
  std::vector<Index> alone(labels.label.size(), kNone);
  for (std::size_t f = 0; f < alone.size(); ++f) {
    if (labels.label[f] == chart) alone[f] = 0;
  }
  reel->surface = std::move(extractCharts(mesh, alone, 1).front());
  reel->record = recordHandleCutter(reel->surface, seed, progress);
  reel->flood = std::make_shared<FloodRecord>(mesh.faceCount());
  const auto steps = static_cast<float>(std::max<std::size_t>(1, reel->record.steps()));
  Index first = 0;
  for (std::size_t step = 0; step < reel->record.steps(); ++step) {
    const Index face = mesh.faceOf(reel->record.triangles[first]);
    reel->flood->append(face, chart, static_cast<float>(step) / steps);
    first = reel->record.stepEnd[step];
  }
  reel->flood->publish();
  reel->playback = std::make_unique<HandlePlayback>(reel->surface, reel->record);
  return reel;
}

HandleFilm::HandleFilm() = default;
HandleFilm::~HandleFilm() { close(); }

void HandleFilm::open(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Segmentation> labels,
                      Index chart, std::uint32_t seed) {
  close();
  labels_ = labels;
  chart_ = chart;
  progress_ = std::make_shared<Progress>();
  making_ = std::async(std::launch::async, [mesh = std::move(mesh), labels = std::move(labels),
                                            chart, seed, progress = progress_] {
    return make(*mesh, *labels, chart, seed, *progress);
  });
}

void HandleFilm::close() {
  if (progress_) progress_->cancel();
  if (making_.valid()) making_.get();
  reel_.reset();
  labels_.reset();
  progress_.reset();
  chart_ = kNone;
  seek(0);
}

void HandleFilm::update(const std::shared_ptr<const Segmentation>& labels, double seconds) {
  if (!active()) return;
  if (labels != labels_) return close();
  if (making_.valid() && making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    reel_ = making_.get();
    playing_ = true;
  }
  if (!reel_ || !playing_) return;
  exact_ += seconds * static_cast<double>(steps()) / kSeconds;
  position_ = std::min(steps(), static_cast<std::size_t>(exact_));
  if (position_ == steps()) playing_ = false;
}

std::size_t HandleFilm::steps() const { return reel_ ? reel_->record.steps() : 0; }

void HandleFilm::seek(std::size_t step) {
  playing_ = false;
  position_ = std::min(step, steps());
  exact_ = static_cast<double>(position_);
}

void HandleFilm::toNextEvent() {
  if (!reel_) return;
  // An event of step n is seen once n + 1 steps are taken.
  const auto& events = reel_->record.events;
  const auto next = std::find_if(events.begin(), events.end(), [&](const HandleEvent& event) {
    return event.step + std::size_t{1} > position_;
  });
  seek(next == events.end() ? steps() : next->step + std::size_t{1});
}

std::shared_ptr<const FloodRecord> HandleFilm::flood() const {
  return reel_ ? reel_->flood : nullptr;
}

const HandleFilm::Lines& HandleFilm::lines() const {
  Reel& reel = *reel_;
  if (reel.linesOf == position_) return reel.lines;
  reel.linesOf = position_;
  reel.playback->seek(position_);
  reel.lines = {};
  for (const FrontPicture& front : reel.playback->fronts()) {
    reel.lines.fronts.insert(reel.lines.fronts.end(), front.sides.begin(), front.sides.end());
    reel.lines.kept.insert(reel.lines.kept.end(), front.kept.begin(), front.kept.end());
  }
  for (const Cut& cut : reel.playback->cuts()) {
    reel.lines.cuts.insert(reel.lines.cuts.end(), cut.sides.begin(), cut.sides.end());
  }
  return reel.lines;
}

std::string HandleFilm::sentence() const {
  if (!reel_) return "";
  const HandleEvent* last = nullptr;
  for (const HandleEvent& event : reel_->record.events) {
    if (event.step >= position_) break;
    last = &event;
  }
  if (last == nullptr) return "";
  switch (last->kind) {
  case HandleEventKind::Split:
    return "A front has split in two; each part remembers its shortest loop.";
  case HandleEventKind::Close:
    return "A front has closed: nothing is left to take there.";
  case HandleEventKind::Touch:
    return "Two fronts meet: a handle is found.";
  case HandleEventKind::Cut:
    return "The shorter remembered loop is cut.";
  case HandleEventKind::Fallback:
    return "No remembered loop would do: the shortest loop of the chart is cut.";
  }
  return "";
}

std::vector<long> handlesOfCharts(const ChartStats& stats) {
  std::vector<long> handles;
  for (const ChartFigures& chart : stats.charts) {
    const long twice = 2 - static_cast<long>(chart.boundaryLoops) - chart.euler;
    handles.push_back(chart.connected ? twice / 2 : 0);
  }
  return handles;
}

}  // namespace chartflood
