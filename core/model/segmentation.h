#pragma once
/// A division of the faces into charts, with what is known of each.

#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/flood_record.h"

namespace chartflood {

/// Why a segmenter stopped.
enum class StopReason {
  NotStopped,     ///< still going, or paused by the user
  Converged,      ///< all seeds rest
  Cycle,          ///< a set of seeds returned
  MaxIterations,  ///< the limit of rounds was reached
  NoImprovement,  ///< no better balance for `patience` rounds
  Balanced,       ///< the charts are as even as the fast search asks for
  Cancelled,      ///< stopped by the user
};

/// Stable id for reports ("no-improvement") .
const char* stopReasonId(StopReason reason);

/// Besides seeds and offsets, what a flood of the fast search runs on; see makeFastFlooding().
struct FastFlood {
  std::vector<Index> starts;  ///< faces that begin clusters wherever they are, ascending
  /// Offsets of the flood of a band around the seams of the clusters' charts, one a seed,
  /// steradians; empty: the clusters themselves are flooded.
  std::vector<double> band;

  bool operator==(const FastFlood&) const = default;
};

/// One round of flooding, as kept in the history.
struct IterationSummary {
  std::size_t iteration = 0;        ///< from 0
  double stdOverMean = 0;           ///< coefficient of variation of the charts' Gauss areas
  bool balanceDefined = true;       ///< false when the mean Gauss area is below 1e-9
  std::size_t movedSeeds = 0;       ///< seeds that differ from the round before
  std::vector<Index> seeds;         ///< seed face of each chart in this round
  std::vector<double> offsets;      ///< Gauss-area offset of each chart in this round, steradians
  std::vector<glm::dvec3> normals;  ///< of each chart in this round, where charts grow by normals
  std::vector<double> band;         ///< as in FastFlood, of rounds of the fast search
  double cost = 0;  ///< what such a method lowers, in normalised units; 0 with t-flooding
};

/// Gauss area of a division, in steradians.
struct ChartAreas {
  std::vector<double> gaussArea;  ///< A(c): one value a chart
  double onSeams = 0;             ///< area of the elements that no chart holds entirely
};

/// The labels at one moment. Immutable once published.
struct Segmentation {
  std::string method;               ///< id of the segmenter
  std::size_t chartCount = 0;       ///< K in force
  std::size_t requestedCharts = 0;  ///< K asked for
  std::vector<Index> label;         ///< chart of each face, kNone while free
  std::vector<Index> seeds;         ///< seed face of each chart
  ChartAreas areas;                 ///< of the labelled part
  std::size_t iteration = 0;        ///< round that the labels come from
  bool complete = false;            ///< every face has a chart
  bool refined = false;             ///< borders were cleaned up after the flood
};

}  // namespace chartflood
