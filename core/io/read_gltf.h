#pragma once
/// glTF 2.0, as JSON with buffers beside or inside it, and as GLB.

#include "core/io/source.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Reads every triangle primitive (lists, strips, fans) of the nodes of the scene, with the nodes'
/// transforms applied. The vertices are those of the file, node by node; as glTF splits vertices
/// where normals or texture coordinates differ, buildMesh() joins those with the same position.
/// Images are not read; morph targets and poses of skins are not applied.
/// \throws ReadError for invalid files, data outside of its buffer, nodes that form a cycle, and
///   required extensions that change the geometry (compression, instancing).
InputMesh readGltf(const Source& source);

}  // namespace chartflood
