#pragma once
/// What deserves attention before charts are painted on.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/index.h"
#include "core/session/session.h"

namespace chartflood {

enum class ProblemKind {
  NotDisks,          ///< charts that cannot lie flat
  NotFlat,           ///< charts that the unwrap left out
  Flipped,           ///< triangles that the unwrap turned over
  Overlapping,       ///< triangles that share a place of the texture
  DegenerateFaces,   ///< faces with a triangle without area
  ThinCharts,        ///< thinner in the texture than kThinPixels
  OpenSharpEdges,    ///< creases inside a chart: no border follows them
  NonManifoldEdges,  ///< of the input, which the mesh has split apart
};

/// Charts thinner than this many pixels of the texture are hard to paint on.
inline constexpr double kThinPixels = 8;

/// Where a problem lies. At least one of both is given.
struct ProblemPlace {
  Index chart = kNone;
  Index face = kNone;  ///< a single face rather than its whole chart
};

struct Problem {
  ProblemKind kind{};
  std::size_t count = 0;             ///< of charts, triangles, faces or edges
  double share = 0;                  ///< OpenSharpEdges: of the length of all creases, in [0, 1]
  std::vector<ProblemPlace> places;  ///< worst first, then ascending; never empty
  std::vector<Index> triangles;      ///< of the mesh that are meant, ascending; may be empty
  std::vector<Index> sides;          ///< of the mesh that are meant, one an edge; may be empty
};

/// "not-disks", "not-flat", "flipped", "degenerate-faces", "thin-charts", ...
const char* problemId(ProblemKind kind);
std::span<const ProblemKind> problemKinds();
/// "3 charts are no disks": the count and what it is of.
std::string problemText(const Problem& problem);
/// "Thin charts": what is meant, without a count.
const char* problemName(ProblemKind kind);
/// Why it matters and what helps, one or two sentences.
const char* problemHelp(ProblemKind kind);

/// Looks through all results. Charts of an unwrap count only while it belongs to the segmentation
/// (Results::flat). Kinds without a finding are left out; the others come in the order of
/// ProblemKind. Cost: linear in mesh and texture, times log for outlines.
std::vector<Problem> findProblems(const Results& results);

}  // namespace chartflood
