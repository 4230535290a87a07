#pragma once
/// Charts of multi-chart geometry images (Sander, Wood, Gortler, Snyder, Hoppe 2003, section 3).

#include <memory>

#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// Charts grow over the dual graph by shortest paths from their seeds; to step from face f to face
/// g costs (lambda - N . n_g) * |centroid_f - centroid_g|, N the chart's normal. The next seed is
/// the face farthest from the chart's border under the same cost with lambda + 1. From one seed on,
/// the face reached last becomes a new one whenever the seeds rest, until there are enough.
///
/// The paper's N is the mean of the chart as it grows, which makes path costs depend on the order
/// of growth; the reading here (frozen normals, the default) takes the mean of the chart of the
/// round before, and the seed's own in its first. `runningNormals` is the literal one.
/// \throws UsageError when the given seeds are not faces of the mesh.
std::unique_ptr<Stepper> makeMcgim(const SegmentInputs& inputs, const SegmentOptions& options);

}  // namespace chartflood
