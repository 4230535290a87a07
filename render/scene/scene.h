#pragma once
/// Everything that pictures of a model show, as one immutable value of shared parts: two scenes
/// with the same pointers look alike. How it is shown is said by RenderSettings. No GL.

#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "render/scene/mode_values.h"
#include "render/scene/simple_surface.h"
#include "render/scene/surface_marks.h"
#include "render/scene/surface_vertices.h"

namespace chartflood {

/// A seed to be marked.
struct SeedMark {
  Index face = kNone;
  Index chart = kNone;    ///< whose colour it gets
  bool emphasis = false;  ///< under the pointer
  bool locked = false;    ///< larger, with a padlock
  bool closed = false;    ///< with the bar of a closed road: the chart cannot grow

  bool operator==(const SeedMark&) const = default;
};

/// The middle of a face: where its seed mark stands. Normalised units.
glm::dvec3 faceMiddle(const Mesh& mesh, Index face);

namespace render {

template <typename Value>
using Shared = std::shared_ptr<const Value>;

/// Parts may be null: they are not shown.
struct Scene {
  /// Mesh, charts, flood, texture and what colours say of them. Without a mesh there is nothing but
  /// the ground; `taken` does not count.
  ModeSource source;

  /// Of the mesh, with its normals; null: each triangle is shaded by its plane.
  Shared<SurfaceVertices> vertices;
  /// The same parted by the texture of `source`; null: it is made where the scene is shown.
  Shared<SurfaceVertices> parted;
  /// Fewer triangles for pictures that ask for them, made of these vertices or ones with other
  /// normals, and of the texture.
  Shared<SimpleSurface> simple;

  /// Labels of another moment, one a face; null: those of the segmentation.
  Shared<std::vector<Index>> labels;
  /// Colours that the first charts begin with, as numbers of a palette's colours. They keep them as
  /// long as neighbours differ.
  Shared<std::vector<Index>> chartColors;
  Shared<std::vector<SeedMark>> seeds;
  /// Sides of the mesh along which charts are opened, in order along each path.
  Shared<std::vector<Index>> cuts;
  /// More lines on the model, the first ones lowest.
  Shared<std::vector<EdgeLines>> lines;
  /// What pictures with RenderSettings::problems point at, on the model and in the texture.
  Shared<SurfaceMarks> marks;

  bool operator==(const Scene&) const = default;
};

/// The labels that a scene shows, one a face; none without charts.
std::span<const Index> shownLabels(const Scene& scene);

/// \throws Error where a part cannot be of the mesh: its size says so
void checkScene(const Scene& scene);

}  // namespace render

}  // namespace chartflood
