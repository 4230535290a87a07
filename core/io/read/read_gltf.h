#pragma once
/// glTF 2.0, as JSON with buffers beside or inside it, and as GLB; 1.0 by the import library.

#include "core/io/read/gltf_geometry.h"
#include "core/io/text/source.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Reads the triangles of the scene that the file shows first, every node's transform applied, a
/// mesh once for each node that has it and for each of the node's instances. The vertices are those
/// of the file, node by node; as glTF splits them where normals or texture coordinates differ,
/// buildMesh() joins those with the same position. Compressed (Draco, meshopt) and quantized
/// geometry is read. Skeletons and morph targets are left at rest, points and lines left out; each
/// of these is said in repairs.
///
/// Buffers are opened in the folder of the source or below it only.
/// \throws ReadError for broken content, other versions than 1 and 2, and extensions that change
///   the geometry in a way that is not known here
InputMesh readGltf(const Source& source);

/// The same in this program with a decoder of Draco's data; without one, files that Draco
/// compressed are read in a program of their own.
InputMesh readGltf(const Source& source, const DracoDecoder& draco);

}  // namespace chartflood
