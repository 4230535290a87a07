#pragma once
/// The planes that a model of few faces is made of, and the quads that its triangles come from.

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/index.h"
#include "core/model/mesh.h"
#include "core/segment/creases/crease_regions.h"

namespace chartflood {

/// The largest connected sets of faces that lie in one plane: normals within half a degree and
/// places within a ten thousandth of the model's size. Nothing where there are more than `most`.
/// Cost: linear, less where there are more.
std::optional<CreaseRegions> flatRegions(const Mesh& mesh, std::size_t most);

/// How many charts a model has by itself: its flat regions, where single triangles count with a
/// neighbour. A very large number where there are more than any default asks for.
std::size_t featureCount(const Mesh& mesh);

/// For each face the one that makes a quad with it, kNone where there is none: of two triangles of
/// the same region, best the four corners closest to right angles. Cost: sorting the edges.
std::vector<Index> quadPartners(const Mesh& mesh, const CreaseRegions& flat);

/// Flat regions of a model whose charts are best made of them, and the quads in them.
struct FlatParts {
  CreaseRegions regions;
  std::vector<Index> partner;  ///< as quadPartners() has it
};

/// Where the model has no more than 60 flat regions, or no more than charts, or fewer faces than
/// three a chart; else, and where joining so many regions would take long, nothing.
std::optional<FlatParts> flatParts(const Mesh& mesh, std::size_t charts);

/// True where flatParts() has something. Cost: linear at most.
bool hasFlatParts(const Mesh& mesh, std::size_t charts);

}  // namespace chartflood
