#pragma once
/// Meshes that the program makes itself: to look at without any file, and to test with.

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "core/model/input_mesh.h"

namespace chartflood {

/// One row of the list of samples.
struct SampleInfo {
  const char* id;     ///< "rocket", for `--sample`
  const char* title;  ///< for the menu
  const char* help;   ///< one sentence: what it shows
  std::size_t defaultTriangles;
};

/// All samples, those to show first.
std::span<const SampleInfo> sampleTable();

/// The most triangles that a sample can be asked for.
inline constexpr std::size_t kMostSampleTriangles = 50'000'000;

/// Makes a sample of about `triangles` triangles (0: its own number): within 10 percent, or the
/// least that the shape needs. All are manifold, consistently oriented (outwards where closed) and
/// the same on every call; y points up and the front faces z. Triangles are even and well shaped,
/// but for the cone's, whose edges run into its tip.
/// \throws UsageError for an id that is not in the table, or more than kMostSampleTriangles
std::shared_ptr<const InputMesh> makeSample(std::string_view id, std::size_t triangles = 0);

}  // namespace chartflood
