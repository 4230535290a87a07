#include "core/io/read/gltf_document.h"

#include <algorithm>
#include <utility>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "core/io/read/gltf_extensions.h"
#include "core/io/read/gltf_json.h"

namespace chartflood {

namespace {

std::string versionOf(const GltfJson& file) {
  if (file.holdsObject("asset")) {
    std::string version = file.part("asset").textOrNumber("version");
    if (!version.empty()) return version;
  }
  // The first version named its parts instead of numbering them.
  return file.holdsObject("meshes") ? "1.0" : "2.0";
}

void requireReadable(const Source& source, const GltfJson& file,
                     const std::vector<std::string>& required) {
  for (const std::string& extension : required) {
    if (leavesGeometryReadable(extension, file)) continue;
    source.fail("it needs the glTF extension " +
                quotedWord(extension.data(), extension.data() + extension.size()) +
                ", which changes the geometry in a way that is not known here; save it without "
                "that extension");
  }
}

GltfBuffer readBuffer(const GltfJson& buffer) {
  const GltfJson extensions = buffer.part("extensions");
  const bool fallback = extensions.part("EXT_meshopt_compression").flag("fallback") ||
                        extensions.part("KHR_meshopt_compression").flag("fallback");
  return {buffer.text("uri"), fallback};
}

GltfView readView(const GltfJson& view) {
  GltfView result{view.count("buffer", kNoPart), view.count("byteOffset", 0),
                  view.count("byteLength", 0), view.count("byteStride", 0), std::nullopt};
  const GltfJson extensions = view.part("extensions");
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    if (!extensions.has(name)) continue;
    const GltfJson packed = extensions.part(name);
    result.meshopt = GltfMeshopt{packed.count("buffer", kNoPart),
                                 packed.count("byteOffset", 0),
                                 packed.count("byteLength", 0),
                                 packed.count("byteStride", 0),
                                 packed.count("count", 0),
                                 packed.text("mode"),
                                 packed.text("filter")};
  }
  return result;
}

std::size_t componentsOf(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  return type == "VEC4" ? 4 : 0;
}

GltfAccessor readAccessor(const GltfJson& accessor) {
  GltfAccessor result;
  result.view = accessor.count("bufferView", kNoPart);
  result.offset = accessor.count("byteOffset", 0);
  result.count = accessor.count("count", 0);
  result.componentType =
      static_cast<int>(std::min<std::size_t>(accessor.count("componentType", 0), 1 << 20));
  result.components = componentsOf(accessor.text("type"));
  result.normalized = accessor.flag("normalized");
  if (!accessor.has("sparse")) return result;
  const GltfJson sparse = accessor.part("sparse");
  const GltfJson indices = sparse.part("indices"), values = sparse.part("values");
  result.sparse = GltfSparse{
      sparse.count("count", 0),
      indices.count("bufferView", kNoPart),
      indices.count("byteOffset", 0),
      values.count("bufferView", kNoPart),
      values.count("byteOffset", 0),
      static_cast<int>(std::min<std::size_t>(indices.count("componentType", 0), 1 << 20))};
  return result;
}

GltfPrimitive readPrimitive(const GltfJson& primitive) {
  GltfPrimitive result;
  result.mode = static_cast<int>(std::min<std::size_t>(primitive.count("mode", 4), 1 << 20));
  result.position = primitive.part("attributes").count("POSITION", kNoPart);
  result.indices = primitive.count("indices", kNoPart);
  result.hasTargets = primitive.has("targets");
  const GltfJson extensions = primitive.part("extensions");
  if (extensions.has("KHR_draco_mesh_compression")) {
    const GltfJson draco = extensions.part("KHR_draco_mesh_compression");
    result.draco = GltfDraco{draco.count("bufferView", kNoPart),
                             draco.part("attributes").count("POSITION", kNoPart)};
  }
  return result;
}

bool anyWeight(const GltfJson& owner) {
  const std::vector<double> weights = owner.numbers("weights");
  return std::any_of(weights.begin(), weights.end(), [](double weight) { return weight != 0; });
}

GltfMesh readMesh(const GltfJson& mesh) {
  GltfMesh result;
  for (const GltfJson& primitive : mesh.list("primitives", "primitive")) {
    result.primitives.push_back(readPrimitive(primitive));
  }
  result.morphs = anyWeight(mesh);
  return result;
}

glm::dmat4 transformOf(const GltfJson& node) {
  const auto numbers = [&](const char* key, std::size_t count) {
    std::vector<double> values = node.numbers(key);
    if (!values.empty() && values.size() != count) {
      node.fail(std::string("has a ") + key + " of " + std::to_string(values.size()) +
                " numbers where " + std::to_string(count) + " are due");
    }
    return values;
  };
  if (const auto m = numbers("matrix", 16); !m.empty()) return glm::make_mat4(m.data());
  glm::dmat4 matrix(1);
  if (const auto t = numbers("translation", 3); !t.empty()) {
    matrix = glm::translate(matrix, glm::make_vec3(t.data()));
  }
  if (const auto r = numbers("rotation", 4); !r.empty()) {
    matrix *= glm::mat4_cast(glm::dquat(r[3], r[0], r[1], r[2]));
  }
  if (const auto s = numbers("scale", 3); !s.empty()) {
    matrix = glm::scale(matrix, glm::make_vec3(s.data()));
  }
  return matrix;
}

GltfNode readNode(const GltfJson& node) {
  GltfNode result;
  result.mesh = node.count("mesh", kNoPart);
  result.hasSkin = node.has("skin");
  if (node.has("weights")) result.morphs = anyWeight(node);
  result.transform = transformOf(node);
  result.children = node.counts("children");
  const GltfJson extensions = node.part("extensions");
  if (extensions.has("EXT_mesh_gpu_instancing")) {
    const GltfJson places = extensions.part("EXT_mesh_gpu_instancing").part("attributes");
    result.instances =
        GltfInstances{places.count("TRANSLATION", kNoPart), places.count("ROTATION", kNoPart),
                      places.count("SCALE", kNoPart)};
  }
  return result;
}

template <class Part, class Read>
std::vector<Part> readAll(const GltfJson& file, const char* key, const char* each, Read read) {
  std::vector<Part> parts;
  for (const GltfJson& part : file.list(key, each)) parts.push_back(read(part));
  return parts;
}

GltfDocument readDocument(const GltfJson& file) {
  GltfDocument document;
  document.buffers = readAll<GltfBuffer>(file, "buffers", "buffer", readBuffer);
  document.views = readAll<GltfView>(file, "bufferViews", "buffer view", readView);
  document.accessors = readAll<GltfAccessor>(file, "accessors", "accessor", readAccessor);
  document.meshes = readAll<GltfMesh>(file, "meshes", "mesh", readMesh);
  document.nodes = readAll<GltfNode>(file, "nodes", "node", readNode);
  document.scenes = readAll<std::vector<std::size_t>>(
      file, "scenes", "scene", [](const GltfJson& scene) { return scene.counts("nodes"); });
  document.scene = file.count("scene", kNoPart);
  return document;
}

}  // namespace

GltfText readGltfText(const Source& source, std::string_view text) {
  const GltfJsonFile json(source, text);
  const GltfJson file = json.all();
  GltfText result{versionOf(file), {}};
  if (!result.version.starts_with("2")) return result;
  std::vector<std::string> required = file.texts("extensionsRequired");
  requireReadable(source, file, required);
  result.document = readDocument(file);
  result.document.required = std::move(required);
  return result;
}

}  // namespace chartflood
