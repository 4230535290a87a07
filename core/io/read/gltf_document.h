#pragma once
/// What the JSON of a glTF 2.0 file says of its geometry, as plain values. Numbers that name other
/// parts are as in the file: whoever follows one checks it.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "core/io/text/source.h"

namespace chartflood {

/// No part is named.
inline constexpr std::size_t kNoPart = static_cast<std::size_t>(-1);

struct GltfBuffer {
  std::string uri;        ///< "": the binary part of a GLB file, or nothing
  bool fallback = false;  ///< holds no data of its own: its views are compressed
};

/// How meshoptimizer compressed a view.
struct GltfMeshopt {
  std::size_t buffer = kNoPart, offset = 0, length = 0, stride = 0, count = 0;
  std::string mode, filter;
};

struct GltfView {
  std::size_t buffer = kNoPart, offset = 0, length = 0;
  std::size_t stride = 0;  ///< 0: elements follow each other
  std::optional<GltfMeshopt> meshopt;
};

struct GltfSparse {
  std::size_t count = 0;
  std::size_t indexView = kNoPart, indexOffset = 0, valueView = kNoPart, valueOffset = 0;
  int indexType = 0;
};

struct GltfAccessor {
  std::size_t view = kNoPart, offset = 0, count = 0;
  int componentType = 0;       ///< as OpenGL numbers it
  std::size_t components = 0;  ///< 1 for scalars, 3 for 3-vectors, 0 for what geometry has not
  bool normalized = false;
  std::optional<GltfSparse> sparse;
};

/// How Draco compressed a primitive.
struct GltfDraco {
  std::size_t view = kNoPart;
  std::size_t position = kNoPart;  ///< unique number of the attribute in the compressed data
};

enum class GltfMode { Points = 0, Triangles = 4, Strip = 5, Fan = 6 };

struct GltfPrimitive {
  int mode = 4;
  std::size_t position = kNoPart, indices = kNoPart;  ///< accessors
  std::optional<GltfDraco> draco;
  bool hasTargets = false;
};

struct GltfMesh {
  std::vector<GltfPrimitive> primitives;
  bool morphs = false;  ///< a weight is not 0
};

/// Places of a node's mesh; accessors.
struct GltfInstances {
  std::size_t translation = kNoPart, rotation = kNoPart, scale = kNoPart;
};

struct GltfNode {
  std::size_t mesh = kNoPart;
  bool hasSkin = false;
  std::optional<bool> morphs;  ///< its own weights; else those of the mesh
  glm::dmat4 transform{1};
  std::vector<std::size_t> children;
  std::optional<GltfInstances> instances;
};

struct GltfDocument {
  std::vector<GltfBuffer> buffers;
  std::vector<GltfView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<GltfMesh> meshes;
  std::vector<GltfNode> nodes;
  std::vector<std::vector<std::size_t>> scenes;  ///< their root nodes
  std::size_t scene = kNoPart;
  std::vector<std::string> required;  ///< extensions
};

/// The version that a glTF file says it has: "2.0". A file that says nothing has the version that
/// its lists look like.
/// \throws ReadError when the text is no JSON, or nested so deeply that it is no glTF
struct GltfText {
  std::string version;
  GltfDocument document;  ///< empty for other versions than 2
};

/// Reads the JSON of a glTF file. Version and required extensions are looked at before anything
/// else can fail.
/// \throws ReadError for broken JSON, an extension that changes the geometry in a way not known
///   here, or parts that are not what they should be
GltfText readGltfText(const Source& source, std::string_view json);

}  // namespace chartflood
