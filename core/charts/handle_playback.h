#pragma once
/// Shows the log of a HandleCutter at any step.

#include <map>
#include <span>
#include <vector>

#include "core/charts/front_loops.h"
#include "core/model/handle_record.h"

namespace chartflood {

/// A front as it stands, with the shortest of its states. Sides of the mesh, in order, as in
/// FrontState.
struct FrontPicture {
  Index number = 0;
  double length = 0;  ///< normalised units
  std::vector<Index> sides;
  double keptLength = 0;
  std::vector<Index> kept;
};

/// Plays a record of recordHandleCutter(). Going on by a step costs as much as happens in it, going
/// back plays from the start; fronts are followed along their edges only when asked for.
class HandlePlayback {
 public:
  /// \param surface that the record was made of; it and the record must outlive this
  HandlePlayback(const ChartSurface& surface, const HandleRecord& record);

  /// Shows the state after so many steps, at most record.steps().
  void seek(std::size_t steps);
  std::size_t position() const { return position_; }

  /// Triangles of the mesh in the region, in the order in which they were taken.
  std::span<const Index> taken() const;
  /// The cuts made so far.
  std::span<const Cut> cuts() const { return {record_.cuts.data(), cuts_}; }
  /// The fronts by number.
  std::vector<FrontPicture> fronts() const;
  /// What happened during the last step.
  std::span<const HandleEvent> lastEvents() const;

 private:
  struct Live {
    FrontState last, kept;
  };

  std::vector<Index> sidesOf(const FrontState& state, Index step) const;

  const ChartSurface& surface_;
  const HandleRecord& record_;
  LiddedSurface lidded_;
  std::vector<Index> stepOfFace_;
  std::size_t position_ = 0, states_ = 0, events_ = 0, cuts_ = 0;
  std::map<Index, Live> live_;
};

}  // namespace chartflood
