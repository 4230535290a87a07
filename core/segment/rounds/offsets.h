#pragma once
/// Gauss-area offsets between charts (paper section 3.5).

#include <span>
#include <vector>

namespace chartflood {

/// offset_i += beta * (A_i - A_min), then the smallest offset is subtracted from all.
///
/// The rule as printed feeds on the offsets themselves and, starting from zero, would never move
/// them; the text beside it ("the Gauss areas of the resulting charts are used to define the
/// offsets for the next flooding round") gives this one.
void updateOffsets(std::vector<double>& offsets, std::span<const double> chartGaussArea,
                   double damping);

}  // namespace chartflood
