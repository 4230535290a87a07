#pragma once
/// The HandleCutter at work, as a film: a region grows over one chart, its fronts split and meet,
/// and the shortest of their loops are cut (paper section 3.6, figure 4).

#include <cstdint>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/charts/handle_playback.h"
#include "core/model/chart_stats.h"
#include "core/model/flood_record.h"
#include "core/model/mesh.h"
#include "core/model/segmentation.h"

namespace chartflood {

/// Made by a thread of its own, then played. One film at a time; it ends with the charts that it
/// was made of.
class HandleFilm {
 public:
  /// A whole film takes this long.
  static constexpr double kSeconds = 8;

  /// Lines on the model at one moment.
  struct Lines {
    std::vector<Index> fronts, kept, cuts;  ///< sides of the mesh, in order along each path
  };

  HandleFilm();
  ~HandleFilm();
  HandleFilm(const HandleFilm&) = delete;
  HandleFilm& operator=(const HandleFilm&) = delete;

  /// Begins to make the film of a chart; `seed` chooses the face from which the region grows.
  void open(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Segmentation> labels,
            Index chart, std::uint32_t seed);
  void close();
  /// Takes in what was made, moves on by `seconds` while it plays, and ends the film when the
  /// labels are no longer those that it shows.
  void update(const std::shared_ptr<const Segmentation>& labels, double seconds);

  /// True from open() to close().
  bool active() const { return reel_ != nullptr || making_.valid(); }
  bool ready() const { return reel_ != nullptr; }
  Index chart() const { return chart_; }

  std::size_t steps() const;
  std::size_t position() const { return position_; }
  bool playing() const { return playing_; }
  void play() { playing_ = true; }
  void pause() { playing_ = false; }
  /// Pauses at a step, at most steps().
  void seek(std::size_t step);
  /// Pauses at the next moment at which something happens to the fronts, or at the end.
  void toNextEvent();

  /// The region as a flood of the chart: entry n is the face of step n. Null until ready().
  std::shared_ptr<const FloodRecord> flood() const;
  /// The lines at the present step. \pre ready()
  const Lines& lines() const;
  /// What happened last, as a sentence; "" before the first event.
  std::string sentence() const;

 private:
  struct Reel;

  static std::unique_ptr<Reel> make(const Mesh& mesh, const Segmentation& labels, Index chart,
                                    std::uint32_t seed, const Progress& progress);

  std::shared_ptr<const Segmentation> labels_;
  Index chart_ = kNone;
  std::shared_ptr<Progress> progress_;
  std::future<std::unique_ptr<Reel>> making_;
  std::unique_ptr<Reel> reel_;
  std::size_t position_ = 0;
  double exact_ = 0;  ///< position_ with the part of a step that has passed
  bool playing_ = false;
};

/// Handles of each chart as segmented; 0 for charts in several pieces.
std::vector<long> handlesOfCharts(const ChartStats& stats);

}  // namespace chartflood
