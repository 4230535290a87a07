#pragma once
/// What deserves attention, as it is drawn on the model and in the texture.

#include <span>

#include <glm/vec3.hpp>

#include "app/host/insight/problems.h"
#include "core/model/mesh.h"
#include "core/model/segmentation.h"
#include "render/scene/surface_marks.h"

namespace chartflood {

/// How a kind looks: a pattern on triangles, or lines.
struct ProblemLook {
  TriangleMark mark = TriangleMark::None;  ///< None: lines
  glm::vec3 color{1};                      ///< sRGB in [0, 1]
  float width = 0;                         ///< of lines, pixels
  bool dashed = false;
};
ProblemLook problemLook(ProblemKind kind);

/// The marks of all problems of one result. Where several meet, the one that spoils paint most is
/// seen: flipped, overlapping, not flat, thin. Faces without area are drawn by their edges.
SurfaceMarks problemMarks(const Mesh& mesh, const Segmentation& segmentation,
                          std::span<const Problem> problems);

}  // namespace chartflood
