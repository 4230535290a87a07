#pragma once
/// Segmentation that begins with the regions between sharp edges instead of a flood.

#include <cstddef>
#include <memory>

#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// A method whose charts are those of chartsFromCreases(). Its one round shows them growing from
/// their middles; then borders are refined with one-sided balance, because an even share of Gauss
/// area means little where planes have none: a hundredth of the weight of balance, and creases
/// count a third of what they do otherwise. Seeds of the options are not used: those of the result
/// are the middles of its charts, told of as a flood is once the borders are refined.
///
/// A model of few planes, as flatParts() knows it, begins with these where there are no more than
/// charts, whether their borders are sharp or not. Its borders stay where they are joined, and
/// where planes are split, they keep to the sides of quads.
std::unique_ptr<Stepper> makeCreaseStart(const SegmentInputs& inputs,
                                         const SegmentOptions& options);

/// True when the model is divided by its sharp edges, or made of few planes beside that number of
/// charts, so that makeCreaseStart() suits it.
bool suitsCreaseStart(const SegmentInputs& inputs, std::size_t charts);

}  // namespace chartflood
