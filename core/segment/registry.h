#pragma once
/// All segmentation methods by name.

#include <memory>
#include <span>
#include <string_view>

#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// One method.
struct Segmenter {
  const char* id;  ///< value of `--method`
  const char* title;
  const char* reference;  ///< where it was published
  std::unique_ptr<Stepper> (*make)(const SegmentInputs&, const SegmentOptions&);
};

std::span<const Segmenter> segmenterTable();

/// The method with this id, or nullptr.
const Segmenter* findSegmenter(std::string_view id);

}  // namespace chartflood
