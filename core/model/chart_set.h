#pragma once
/// The charts as surfaces, with the cuts that make them disks (paper section 3.6).

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/index.h"
#include "core/model/chart_surface.h"

namespace chartflood {

/// Why a cut was made.
enum class CutReason : std::uint8_t {
  Handle,  ///< opens a handle (HandleCutter)
  Open,    ///< gives a closed chart without handles a boundary
  Loop,    ///< joins two boundary loops (LoopMergeCutter)
  Tip,     ///< slits a long finger
  Relief,  ///< slits a chart where it would stretch too much
};

/// A path or loop of edges along which a chart is opened. Cuts change neither labels nor the
/// chart's Gauss area.
struct Cut {
  CutReason reason = CutReason::Handle;
  std::vector<Index> sides;  ///< sides of the mesh, one of each edge's two, in order along the path
  double length = 0;         ///< normalised units
};

/// A chart after cutting.
struct CutChart {
  ChartSurface surface;    ///< opened along all cuts
  std::vector<Cut> cuts;   ///< in the order they were made
  ChartTopology before;    ///< as segmented
  ChartTopology topology;  ///< of `surface`
  std::string problem;     ///< a sentence that says why it is no disk; "" when it is one

  bool disk() const { return topology.disk(); }
  double cutLength() const {
    double sum = 0;
    for (const Cut& cut : cuts) sum += cut.length;
    return sum;
  }
};

/// A list of charts; its copies share them.
class CutCharts {
 public:
  class Iterator {
   public:
    using difference_type = std::ptrdiff_t;
    using value_type = CutChart;

    Iterator() = default;
    explicit Iterator(const std::shared_ptr<const CutChart>* at) : at_(at) {}
    const CutChart& operator*() const { return **at_; }
    const CutChart* operator->() const { return at_->get(); }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    Iterator operator++(int) { return Iterator(at_++); }
    bool operator==(const Iterator&) const = default;

   private:
    const std::shared_ptr<const CutChart>* at_ = nullptr;
  };

  CutCharts() = default;
  /// \pre put() fills each place before it is looked at
  explicit CutCharts(std::size_t count) : charts_(count) {}

  std::size_t size() const { return charts_.size(); }
  bool empty() const { return charts_.empty(); }
  const CutChart& operator[](std::size_t chart) const { return *charts_[chart]; }
  Iterator begin() const { return Iterator(charts_.data()); }
  Iterator end() const { return Iterator(charts_.data() + charts_.size()); }

  /// Replaces a chart. Threads may fill different places at once.
  void put(std::size_t place, CutChart chart) {
    charts_[place] = std::make_shared<const CutChart>(std::move(chart));
  }
  void push_back(CutChart chart) {
    charts_.emplace_back();
    put(charts_.size() - 1, std::move(chart));
  }

 private:
  std::vector<std::shared_ptr<const CutChart>> charts_;
};

/// One entry a chart, by its number.
struct ChartSet {
  CutCharts charts;
};

}  // namespace chartflood
