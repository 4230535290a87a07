#pragma once
/// Variational shape approximation (Cohen-Steiner, Alliez, Desbrun 2004): charts that planes fit
/// best.

#include <memory>

#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// Rounds of flooding and fitting with the L2,1 metric. A chart's proxy is a unit normal N; a face
/// costs area * |n - N|^2. One queue over all charts takes the cheapest face next (section 3.3);
/// each chart's next seed is its cheapest face and its next proxy the mean normal, which is the
/// exact minimiser for fixed charts. The charts of the round with the least total cost are kept.
///
/// Teleportation (section 3.5): when the cost rests, the two neighbours whose union costs least
/// become one chart and the freed seed goes to the worst face of the worst chart, as long as that
/// costs less than half of what the worst chart has; undone when it brings no gain.
/// \throws UsageError when the given seeds are not faces of the mesh.
std::unique_ptr<Stepper> makeVsa(const SegmentInputs& inputs, const SegmentOptions& options);

/// Total L2,1 cost of labels with the best proxies, in squared normalised units; degenerate faces
/// cost nothing.
double vsaCost(const Mesh& mesh, std::span<const Index> label, std::size_t chartCount);

}  // namespace chartflood
