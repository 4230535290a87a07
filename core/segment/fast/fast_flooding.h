#pragma once
/// t-flooding that is fast at any size: the usual rounds on a coarse graph of clusters, then a few
/// balanced floods of a band of faces around the seams found there. Beyond the paper.

#include <memory>

#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// Faces a chart below which clusters would be too coarse for even charts.
constexpr std::size_t kFastFacesPerChart = 300;

/// True when the options ask for the fast search and the mesh has faces enough for it.
bool searchesFast(const Mesh& mesh, const SegmentOptions& options);

/// A stepper of method "t-flooding" whose rounds are
///
/// - floods of the clusters with shortest times, seeds moved and offsets kept as usual, until the
///   usual rules stop them, with seven tenths of the patience; when that left the charts uneven and
///   chance placed the seeds, a run with other seeds is tried aside and the best round of both is
///   flooded once more;
/// - then floods of the band with these charts' rests as seeds and offsets of its own, until
///   sqrt(n) std / mean < 0.02 or three rounds bring no gain.
///
/// Each round labels all faces; the log of one takes the faces of a cluster one after the other.
/// The best round of the band is kept and its borders are refined as usual.
std::unique_ptr<Stepper> makeFastFlooding(const SegmentInputs& inputs,
                                          const SegmentOptions& options);

}  // namespace chartflood
