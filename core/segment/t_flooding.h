#pragma once
/// The paper's segmentation: t-flooding rounds with Lloyd-Max seeds and Gauss-area offsets.

#include <memory>

#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// Places the seeds and stands ready to flood; nothing is taken yet.
/// \throws UsageError when the given seeds are not faces of the mesh.
std::unique_ptr<Stepper> makeTFlooding(const SegmentInputs& inputs, const SegmentOptions& options);

}  // namespace chartflood
