#pragma once
/// All segmentation methods by name, each with what others must know of it: choices, notices,
/// report and comparison ask this table and never a method's name.

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// One method.
struct Segmenter {
  const char* id;          ///< value of `--method`
  const char* title;       ///< as the list of methods shows it
  const char* shortTitle;  ///< as its name is used in a sentence
  const char* reference;   ///< where it was published
  std::unique_ptr<Stepper> (*make)(const SegmentInputs&, const SegmentOptions&);
  bool beginsWithAllSeeds = false;  ///< rather than coming to its charts one by one
  bool balances = false;            ///< its rounds even out the charts' Gauss areas
  bool knowsCreases = false;        ///< may begin from the charts between sharp edges
  bool knowsFast = false;           ///< has rounds on a coarse graph
  bool refinesByDefault = false;    ///< refined borders are part of it here
  /// Why seeds that return are no end for it; "" where they are.
  const char* noCycles = "";
};

std::span<const Segmenter> segmenterTable();

/// The method with this id, or nullptr.
const Segmenter* findSegmenter(std::string_view id);

/// The same of an id that the parameter table has let through.
const Segmenter& segmenterOf(std::string_view id);

/// Ids in the order of figure 6 of the paper, which puts its own method last.
std::vector<const char*> comparedMethods();

}  // namespace chartflood
