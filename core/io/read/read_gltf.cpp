#include "core/io/read/read_gltf.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/io/read/face_builder.h"
#include "core/io/read/glb_chunks.h"
#include "core/io/read/gltf_accessor.h"
#include "core/io/read/gltf_buffers.h"
#include "core/io/read/gltf_document.h"
#include "core/io/read/read_assimp.h"

namespace chartflood {

namespace {

/// Vertices and corners that repeating meshes may come to: a few bytes can ask for any number.
constexpr std::size_t kMostInCopies = 200'000'000;

class GltfReader {
 public:
  GltfReader(const Source& source, const GltfDocument& document, std::string_view binary,
             const DracoDecoder& draco)
      : source_(source), document_(document),
        buffers_(source, document, binary), data_{source, document, buffers_}, draco_(draco),
        faces_(out_) {}

  InputMesh read();

 private:
  struct Visit {
    std::size_t node;
    glm::dmat4 parent;
  };
  using Transforms = std::vector<glm::dmat4>;

  std::vector<std::size_t> rootNodes() const;
  bool visitNodes();
  bool visitNode(const GltfNode& node, const glm::dmat4& transform);
  Transforms instances(const GltfInstances& places, const glm::dmat4& transform);
  bool addMesh(std::size_t number, const Transforms& transforms);
  void place(const GltfGeometry& geometry, const glm::dmat4& transform);
  void countUses();
  void addRepairs();

  const Source& source_;
  const GltfDocument& document_;
  GltfBuffers buffers_;
  GltfData data_;
  const DracoDecoder& draco_;
  InputMesh out_;
  FaceBuilder faces_;
  std::vector<std::size_t> uses_;             ///< of each mesh by nodes yet to come
  std::vector<bool> placed_;                  ///< meshes that were there already
  std::size_t repeated_ = 0;                  ///< vertices and corners of those again
  std::map<std::size_t, GltfGeometry> kept_;  ///< meshes that come again
  std::size_t otherPrimitives_ = 0, skinnedNodes_ = 0, morphedNodes_ = 0;
};

InputMesh GltfReader::read() {
  countUses();
  if (!visitNodes()) return {};
  if (out_.faceCount() == 0) {
    source_.fail(document_.meshes.empty() ? "it has no meshes"
                                          : "none of its nodes shows triangles");
  }
  addRepairs();
  return std::move(out_);
}

void GltfReader::countUses() {
  uses_.assign(document_.meshes.size(), 0);
  placed_.assign(document_.meshes.size(), false);
  for (const GltfNode& node : document_.nodes) {
    if (node.mesh < uses_.size()) ++uses_[node.mesh];
  }
}

/// The roots of the scene that the file shows first, or of all nodes when it has no scene.
std::vector<std::size_t> GltfReader::rootNodes() const {
  const std::size_t shown = document_.scene == kNoPart ? 0 : document_.scene;
  if (shown < document_.scenes.size()) return document_.scenes[shown];
  if (!document_.scenes.empty()) source_.fail("its default scene does not exist");
  std::vector<bool> isChild(document_.nodes.size(), false);
  for (const GltfNode& node : document_.nodes) {
    for (const std::size_t child : node.children) {
      if (child < isChild.size()) isChild[child] = true;
    }
  }
  std::vector<std::size_t> roots;
  for (std::size_t n = 0; n < isChild.size(); ++n) {
    if (!isChild[n]) roots.push_back(n);
  }
  return roots;
}

/// Visits every node once, parents first, children in order. \returns false when cancelled.
bool GltfReader::visitNodes() {
  if (document_.nodes.empty()) {
    for (std::size_t m = 0; m < document_.meshes.size(); ++m) {
      if (!addMesh(m, {glm::dmat4(1)})) return false;
    }
    return true;
  }
  std::vector<Visit> stack;
  const auto push = [&](const std::vector<std::size_t>& nodes, const glm::dmat4& parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) stack.push_back({*node, parent});
  };
  std::vector<bool> visited(document_.nodes.size(), false);
  for (push(rootNodes(), glm::dmat4(1)); !stack.empty();) {
    const Visit visit = stack.back();
    stack.pop_back();
    if (visit.node >= document_.nodes.size()) {
      source_.fail("it names node " + std::to_string(visit.node) + " but there are " +
                   std::to_string(document_.nodes.size()));
    }
    if (visited[visit.node]) {
      source_.fail("its node " + std::to_string(visit.node) +
                   " hangs below two nodes or below itself");
    }
    visited[visit.node] = true;
    const GltfNode& node = document_.nodes[visit.node];
    const glm::dmat4 transform = visit.parent * node.transform;
    if (!visitNode(node, transform)) return false;
    push(node.children, transform);
  }
  if (std::find(visited.begin(), visited.end(), true) == visited.end()) {
    source_.fail("its scene shows no node");
  }
  return true;
}

/// \returns false when cancelled.
bool GltfReader::visitNode(const GltfNode& node, const glm::dmat4& transform) {
  if (node.mesh == kNoPart) return true;
  if (node.mesh >= document_.meshes.size()) {
    source_.fail("it names mesh " + std::to_string(node.mesh) + " but there are " +
                 std::to_string(document_.meshes.size()));
  }
  const GltfMesh& mesh = document_.meshes[node.mesh];
  const bool hasTargets = std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                                      [](const GltfPrimitive& each) { return each.hasTargets; });
  if (hasTargets && node.morphs.value_or(mesh.morphs)) ++morphedNodes_;
  if (node.instances) return addMesh(node.mesh, instances(*node.instances, transform));
  // A skin places its mesh by the joints alone; without its pose the mesh is as it was modelled.
  if (node.hasSkin) ++skinnedNodes_;
  return addMesh(node.mesh, {node.hasSkin ? glm::dmat4(1) : transform});
}

/// Where each instance of a node lies (EXT_mesh_gpu_instancing).
GltfReader::Transforms GltfReader::instances(const GltfInstances& places,
                                             const glm::dmat4& transform) {
  const auto read3 = [&](std::size_t accessor) {
    return accessor == kNoPart ? std::vector<glm::dvec3>() : gltfPositions(data_, accessor);
  };
  const std::vector<glm::dvec3> translations = read3(places.translation),
                                scales = read3(places.scale);
  const std::vector<glm::dvec4> rotations = places.rotation == kNoPart
                                                ? std::vector<glm::dvec4>()
                                                : gltfRotations(data_, places.rotation);
  const std::size_t count = std::max({translations.size(), rotations.size(), scales.size()});
  for (const std::size_t size : {translations.size(), rotations.size(), scales.size()}) {
    if (size != 0 && size != count) source_.fail("its instances have places of different number");
  }
  if (count == 0) return {transform};
  Transforms result(count, transform);
  for (std::size_t i = 0; i < count; ++i) {
    if (!translations.empty()) result[i] = glm::translate(result[i], translations[i]);
    if (!rotations.empty()) {
      const glm::dvec4 r = rotations[i];
      const glm::dquat turn(r.w, r.x, r.y, r.z);
      if (glm::dot(turn, turn) > 0) result[i] *= glm::mat4_cast(glm::normalize(turn));
    }
    if (!scales.empty()) result[i] = glm::scale(result[i], scales[i]);
  }
  return result;
}

/// \returns false when cancelled.
bool GltfReader::addMesh(std::size_t number, const Transforms& transforms) {
  if (source_.report(source_.begin())) return false;
  auto kept = kept_.find(number);
  if (kept == kept_.end()) {
    kept = kept_.emplace(number, readGltfGeometry(data_, number, draco_)).first;
  }
  const GltfGeometry& geometry = kept->second;
  otherPrimitives_ += geometry.otherPrimitives;
  const std::size_t size = geometry.positions.size() + geometry.corners.size();
  const std::size_t again = transforms.size() - (placed_[number] ? 0 : 1);
  placed_[number] = true;
  if (size > 0 && again > (kMostInCopies - repeated_) / size) {
    source_.fail("repeating its meshes comes to more than " + std::to_string(kMostInCopies) +
                 " vertices and corners; save fewer instances");
  }
  repeated_ += again * size;
  for (const glm::dmat4& transform : transforms) {
    if (source_.report(source_.begin())) return false;
    place(geometry, transform);
  }
  if (uses_[number] <= 1) {
    kept_.erase(kept);
  } else {
    --uses_[number];
  }
  return true;
}

/// One more copy of a mesh; a mirrored node turns its triangles over.
void GltfReader::place(const GltfGeometry& geometry, const glm::dmat4& transform) {
  if (geometry.positions.size() >= kNone - out_.positions.size()) {
    source_.fail("it has too many vertices");
  }
  const auto offset = static_cast<Index>(out_.positions.size());
  const bool mirrored = glm::determinant(glm::dmat3(transform)) < 0;
  for (const glm::dvec3& p : geometry.positions) {
    out_.positions.emplace_back(transform * glm::dvec4(p, 1));
  }
  for (std::size_t i = 0; i + 2 < geometry.corners.size(); i += 3) {
    Index b = geometry.corners[i + 1], c = geometry.corners[i + 2];
    if (mirrored) std::swap(b, c);
    faces_.addTriangle(offset + geometry.corners[i], offset + b, offset + c);
  }
}

void GltfReader::addRepairs() {
  if (otherPrimitives_ > 0) {
    out_.repairs.push_back(
        {"points-and-lines-ignored", otherPrimitives_,
         counted(otherPrimitives_, "part of points or lines was", "parts of points or lines were") +
             " left out."});
  }
  if (skinnedNodes_ > 0) {
    out_.repairs.push_back({"poses-ignored", skinnedNodes_,
                            counted(skinnedNodes_, "mesh has", "meshes have") +
                                " a skeleton; shown as modelled, without its pose."});
  }
  if (morphedNodes_ > 0) {
    out_.repairs.push_back({"morphs-ignored", morphedNodes_,
                            counted(morphedNodes_, "mesh has", "meshes have") +
                                " morph targets switched on; shown without them."});
  }
}

bool usesDraco(const GltfDocument& document) {
  return std::any_of(document.meshes.begin(), document.meshes.end(), [&](const GltfMesh& mesh) {
    return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                       [&](const GltfPrimitive& each) { return needsDraco(document, each); });
  });
}

/// The first version has another build of the file; the import library knows it.
InputMesh readFirstVersion(const Source& source, std::string_view extension) {
  try {
    return readAssimp(source, extension);
  } catch (const ReadError& error) {
    source.fail("it is glTF 1.0, and " + error.cause() + "; glTF 2.0 is read without that library");
  }
}

}  // namespace

InputMesh readGltf(const Source& source) { return readGltf(source, DracoDecoder()); }

InputMesh readGltf(const Source& source, const DracoDecoder& draco) {
  const bool isBinary = isGlb(source.bytes);
  GlbChunks chunks{2, source.bytes, {}};
  if (isBinary) chunks = readGlbChunks(source);
  if (chunks.version == 1) return readFirstVersion(source, "glb");
  if (chunks.version != 2) {
    source.fail("it is GLB " + std::to_string(chunks.version) + "; versions 1 and 2 are read");
  }
  const GltfText text = readGltfText(source, chunks.json);
  if (text.version.starts_with("1") || text.version.starts_with("0")) {
    return readFirstVersion(source, isBinary ? "glb" : "gltf");
  }
  if (!text.version.starts_with("2")) {
    source.fail("it is glTF " +
                quotedWord(text.version.data(), text.version.data() + text.version.size()) +
                "; versions 1 and 2 are read");
  }
  if (!draco && usesDraco(text.document)) return readDracoGltf(source);
  return GltfReader(source, text.document, chunks.binary, draco).read();
}

}  // namespace chartflood
