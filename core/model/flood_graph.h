#pragma once
/// What a flood needs to know of every face, packed for it: neighbours, delays, Gauss-area gains.

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/index.h"
#include "core/base/raw_vector.h"

namespace chartflood {

/// How fast the flood runs and what it counts.
struct FloodSpeeds {
  double power = 1;         ///< p of equation 7
  double epsilon = 1e-3;    ///< epsilon of equation 7, as a share of the largest |K|
  double areaShare = 1e-3;  ///< eta: share of the total Gauss area that plain surface counts as

  bool operator==(const FloodSpeeds&) const = default;
};

/// Static data of one triangular face, half a cache line.
struct alignas(32) FloodFace {
  /// Face across each side times 4 plus the side's number (0..2) there; kNone on a mesh border.
  std::array<Index, 3> neighbour;
  std::array<float, 3> delay;  ///< Delta t into the face across each side (equation 9)
  float gain;                  ///< own Gauss area plus eta times area
  Index extra;                 ///< entry of FloodGraph::extras, 0 for none
};
static_assert(sizeof(FloodFace) == 32);

/// Gauss areas on the edges and corners of the few triangular faces that have them.
struct FloodExtra {
  std::array<float, 3> edge;    ///< Gauss area of each side's edge
  std::array<Index, 3> corner;  ///< entry of FloodGraph::cornerGain for each vertex, kNone for none
};

/// One way from a face to a neighbour, for faces of any degree.
struct FloodArc {
  Index face;     ///< where it leads
  Index reverse;  ///< the arc back
  float delay;
  float edgeGain;  ///< Gauss area of the edge that it crosses
};

/// A corner with Gauss area at a face, and how often the face touches it.
struct FloodCorner {
  Index corner;
  Index times;
};

/// A node of any size beside triangles, such as what stays of a chart: its sides and corners follow
/// those of the hub before.
struct FloodHub {
  float gain;
  Index sideEnd;    ///< in FloodGraph::hubSides
  Index cornerEnd;  ///< in FloodGraph::hubCorners
};

/// A side of a triangle against a hub.
struct FloodHubSide {
  Index side;   ///< triangle times 4 plus the side's number (0..2); its neighbour is kNone there
  float delay;  ///< into the triangle, the same for all its sides against the hub
};

/// Exactly one of the two layouts is filled: `faces` and hubs when every face is a triangle, else
/// the arcs.
struct FloodGraph {
  FloodSpeeds speeds;
  std::size_t faceCount = 0;  ///< with the hubs
  double eta = 0;             ///< steradians that one squared normalised unit of surface counts as

  RawVector<FloodFace> faces;
  std::vector<FloodExtra> extras;  ///< entry 0 is unused
  /// Numbered behind the triangles; all are seeds of every flood.
  std::vector<FloodHub> hubs;
  std::vector<FloodHubSide> hubSides;   ///< of each hub, sides of the same triangle in a row
  std::vector<FloodCorner> hubCorners;  ///< corners that triangles touch as well

  std::vector<float> gain;      ///< of each face, as in FloodFace
  std::vector<Index> arcBegin;  ///< faceCount + 1 entries
  std::vector<FloodArc> arcs;
  std::vector<Index> cornerBegin;  ///< faceCount + 1 entries into `corners`
  std::vector<FloodCorner> corners;
  std::vector<std::uint8_t> atMeshBorder;  ///< of each face

  std::vector<float> cornerGain;   ///< Gauss area of each corner
  std::vector<Index> cornerTimes;  ///< how often faces touch it: the size of its fan

  bool packed() const { return !faces.empty() || !hubs.empty(); }
};

}  // namespace chartflood
