#pragma once
/// The rounds of the methods that grow charts by normals, as a stepper.

#include <memory>
#include <vector>

#include "core/model/mesh.h"
#include "core/segment/growth/growth_method.h"
#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// Rounds with fewer charts than wanted come first and are not counted against the limit of rounds.
/// The result is the round with the least cost among those with all charts. With even growth that
/// round is where even rounds begin: seeds and normals go on as the method has it, and offsets by
/// the rule of the paper's section 3.5 with the charts' errors in place of Gauss areas; then seeds
/// and normals rest while offsets go on. The result is the round whose charts are most even.
/// Borders are refined at the end by their length and the method's own cost: these methods know no
/// balance.
std::unique_ptr<Stepper> makeGrowthRounds(const char* id, const SegmentInputs& inputs,
                                          const SegmentOptions& options,
                                          std::unique_ptr<GrowthMethod> method,
                                          const GrowthStart& first, std::size_t chartCount);

/// Where growth begins when nothing is said: seeds as given, else one random face; one random face
/// in each further component; each with its face's normal, or the normals given with the seeds.
GrowthStart firstGrowthStart(const SegmentInputs& inputs, const SegmentOptions& options);

}  // namespace chartflood
