#pragma once
/// What the methods that grow charts by normals differ in; growth_rounds.h drives them.

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/model/flood_record.h"
#include "core/model/segmentation.h"
#include "core/segment/growth/growth_flood.h"
#include "core/segment/parts/chart_price.h"

namespace chartflood {

/// One flood after another, each judged when it is done. Numbers of charts may grow between floods.
class GrowthMethod {
 public:
  /// What comes after a finished flood.
  struct Verdict {
    StopReason stop = StopReason::NotStopped;
    GrowthStart next;
  };

  virtual ~GrowthMethod() = default;

  virtual void start(const GrowthStart& start, std::shared_ptr<FloodRecord> record) = 0;
  virtual std::size_t advance(std::size_t count, Progress* progress) = 0;
  virtual bool finished() const = 0;
  /// A whole flood from `start`, away from the one at hand. False when cancelled.
  virtual bool floodAside(const GrowthStart& start, std::shared_ptr<FloodRecord> record,
                          Progress* progress) const = 0;
  virtual std::size_t taken() const = 0;
  /// The method's own cost of faces, for the refinement of borders after a flood from `start`.
  virtual std::shared_ptr<ChartPrice> price(const GrowthStart& start) const = 0;
  virtual const std::vector<GrowthFace>& faces() const = 0;

  /// Of a finished flood: the cost that the method lowers.
  virtual double measure(const GrowthStart& present) = 0;
  /// After measure(): what each chart has of that cost.
  virtual std::vector<double> chartCosts() const = 0;
  /// After measure(): the next start with seeds moved and normals fitted, nothing else changed.
  virtual GrowthStart relaxed() = 0;
  /// After measure(): the next start, with more seeds where there are fewer than wanted; or why to
  /// stop. Told of every new round once.
  virtual Verdict judge() = 0;
};

}  // namespace chartflood
