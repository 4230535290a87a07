#pragma once
/// Shapes on a sphere that is seen from far away.

#include <span>

#include <glm/vec3.hpp>

#include "app/gui/widgets/ui.h"
#include "app/host/insight/sphere_patch.h"
#include "render/scene/camera.h"

namespace chartflood {

/// Which half of the sphere is drawn.
enum class Half { Back, Front };

/// The sphere in the window and where it is seen from.
class SphereDrawing {
 public:
  SphereDrawing(const Ui& ui, ImVec2 center, float radius, const Camera& camera);

  /// A disc, lighter where the light comes from.
  void ball() const;
  /// Meridians and parallels every 30 degrees about the upright axis.
  void grid(Half half, ImU32 color) const;
  /// The chart's facets; places covered several times are stronger.
  void facets(std::span<const SphereFacet> facets, Half half, ImU32 color, float strength) const;
  /// Great arcs; those at the chart's border are fainter.
  void arcs(std::span<const SphereArc> arcs, Half half, ImU32 color) const;
  /// A closed polygon of great arcs.
  void outline(std::span<const glm::vec3> corners, Half half, ImU32 color) const;
  void point(const glm::vec3& n, Half half, ImU32 color, float radius) const;
  /// A square of `size` pixels; cheap.
  void dot(const glm::vec3& n, Half half, ImU32 color, float size) const;
  /// Where the model's axes leave the sphere.
  void axes() const;

 private:
  ImVec2 place(const glm::vec3& n) const;
  float depth(const glm::vec3& n) const { return glm::dot(n, toward_); }
  bool on(const glm::vec3& n, Half half) const { return (depth(n) >= 0) == (half == Half::Front); }
  void polyline(std::span<const glm::vec3> points, Half half, ImU32 color, float width) const;

  const Ui& ui_;
  ImDrawList& list_;
  ImVec2 center_;
  float radius_;
  glm::vec3 right_, up_, toward_, upright_;
};

}  // namespace chartflood
