#pragma once
/// The log of a HandleCutter that grows a region over a chart (paper section 3.6, figure 4): all a
/// viewer needs to show it step by step.

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/index.h"
#include "core/model/chart_set.h"

namespace chartflood {

/// What can happen to the fronts, the closed chains of edges around the region.
enum class HandleEventKind : std::uint8_t {
  Split,     ///< front 0 becomes fronts 1 and 2
  Close,     ///< front 0 shrinks to nothing
  Touch,     ///< fronts 0 and 1 meet and become front 2: a handle is found
  Cut,       ///< the remembered loop of front 0 is cut
  Fallback,  ///< no remembered loop would do: the shortest loop of the whole chart is cut
};

struct HandleEvent {
  HandleEventKind kind = HandleEventKind::Split;
  Index step = 0;                                    ///< during which it happens
  std::array<Index, 3> fronts{kNone, kNone, kNone};  ///< as said with the kind
  /// Of Cut and Fallback: the cuts [firstCut, endCut) of the record, nearly always one.
  Index firstCut = 0, endCut = 0;

  bool operator==(const HandleEvent&) const = default;
};

/// A front after a step that changed it.
struct FrontState {
  Index step = 0;
  Index front = 0;  ///< numbered from 0 in the order in which fronts appear
  /// A side of the mesh on the front: of a taken triangle towards a free one, or of a free triangle
  /// on a border of the chart that the region has reached.
  Index side = 0;
  double length = 0;  ///< normalised units; edges on borders count nothing

  bool operator==(const FrontState&) const = default;
};

/// Only grows while it is made. Step n takes the triangles [stepEnd[n - 1], stepEnd[n]) of
/// `triangles`: those of one face. A border of the chart belongs to the region from the step that
/// first takes a triangle at it. A front remembers the shortest of its states.
struct HandleRecord {
  std::vector<Index> triangles;     ///< of the mesh, in the order in which they are taken
  std::vector<Index> stepEnd;       ///< one entry a step
  std::vector<FrontState> states;   ///< ascending steps
  std::vector<HandleEvent> events;  ///< ascending steps
  std::vector<Cut> cuts;            ///< in the order in which they are made

  std::size_t steps() const { return stepEnd.size(); }
};

}  // namespace chartflood
