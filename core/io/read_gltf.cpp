#include "core/io/read_gltf.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <exception>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <tiny_gltf.h>

#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/io/face_builder.h"
#include "core/io/file_bytes.h"
#include "core/io/gltf_accessor.h"

namespace chartflood {

namespace {

/// What tinygltf asks of the file system: buffers in the folder of the file, nothing else.
struct BufferFiles {
  std::string folder;
  std::string failure;  ///< why a buffer could not be read
  std::string missing;  ///< the last one that was not there

  static bool exists(const std::string& path, void* self) {
    auto& files = *static_cast<BufferFiles*>(self);
    // Without this it would look into the present folder as well, and load pictures.
    if (!path.starts_with(files.folder) || isPicture(path)) return false;
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) return true;
    files.missing = "its buffer " + std::filesystem::path(path).filename().string() +
                    " is not in the same folder";
    return false;
  }
  static std::string expand(const std::string& path, void*) { return path; }
  static bool read(std::vector<unsigned char>* out, std::string* error, const std::string& path,
                   void* self) {
    try {
      const FileBytes bytes(path);
      out->assign(bytes.view().begin(), bytes.view().end());
      return true;
    } catch (const ReadError& e) {
      *error = e.cause();
      static_cast<BufferFiles*>(self)->failure = "its buffer " +
                                                 std::filesystem::path(path).filename().string() +
                                                 " could not be read: " + e.cause();
      return false;
    }
  }
  static bool write(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  }
  static bool isPicture(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    constexpr std::array<std::string_view, 6> kPictures = {".png",  ".jpg",  ".jpeg",
                                                           ".webp", ".ktx2", ".dds"};
    return std::find(kPictures.begin(), kPictures.end(), ending) != kPictures.end();
  }
};

bool ignoreImage(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*,
                 int, void*) {
  return true;
}

/// Refuses JSON nested so deeply that a parser that calls itself would run out of stack.
void requireShallow(const Source& source, std::string_view json) {
  constexpr int kDeepest = 200;
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (inString) {
      if (c == '\\') ++i;
      inString = c != '"';
      continue;
    }
    inString = c == '"';
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (depth > kDeepest) source.failAtByte(&json[i], "the JSON is nested too deeply");
  }
}

/// The first line of what the library says, as the end of a sentence.
std::string firstLine(std::string text) {
  text = text.substr(0, text.find('\n'));
  // JSON errors begin with a code and end with what a programmer would want to know.
  if (text.starts_with("[json.")) text = text.substr(std::min(text.find("] ") + 2, text.size()));
  text = text.substr(0, text.find("; last read"));
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  return text.empty() ? "its content is not valid" : text;
}

/// Extensions that leave the geometry alone.
bool isHarmless(std::string_view extension) {
  constexpr std::array<std::string_view, 8> kBeginnings = {
      "KHR_materials_", "KHR_texture_", "EXT_texture_",          "KHR_lights_",
      "MSFT_texture_",  "KHR_xmp",      "KHR_mesh_quantization", "EXT_lights_"};
  return std::any_of(kBeginnings.begin(), kBeginnings.end(),
                     [&](std::string_view begin) { return extension.starts_with(begin); });
}

/// The JSON text: all of a .gltf file, the first chunk of a .glb file.
std::string_view jsonOf(std::string_view bytes) {
  if (!bytes.starts_with("glTF") || bytes.size() < 20) return bytes;
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  return bytes.substr(20, length);
}

tinygltf::Model load(const Source& source) {
  if (source.bytes.size() > std::numeric_limits<unsigned>::max()) {
    source.fail("it is larger than 4 GB, which glTF cannot be");
  }
  requireShallow(source, jsonOf(source.bytes));
  BufferFiles files;
  files.folder = std::filesystem::absolute(source.folder.empty() ? "." : source.folder).string();
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(ignoreImage, nullptr);
  loader.SetFsCallbacks(
      {BufferFiles::exists, BufferFiles::expand, BufferFiles::read, BufferFiles::write, &files});
  tinygltf::Model model;
  std::string error, warning;
  const unsigned size = static_cast<unsigned>(source.bytes.size());
  bool loaded = false;
  try {
    loaded = source.bytes.starts_with("glTF")
                 ? loader.LoadBinaryFromMemory(
                       &model, &error, &warning,
                       reinterpret_cast<const unsigned char*>(source.begin()), size, files.folder)
                 : loader.LoadASCIIFromString(&model, &error, &warning, source.begin(), size,
                                              files.folder);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    error = e.what();
  }
  if (!files.failure.empty()) source.fail(files.failure);
  if (!loaded && !files.missing.empty()) source.fail(files.missing);
  if (!loaded) source.fail("it is not valid glTF: " + firstLine(error));
  for (const std::string& extension : model.extensionsRequired) {
    if (isHarmless(extension)) continue;
    source.fail("it needs the glTF extension " +
                quotedWord(extension.data(), extension.data() + extension.size()) +
                ", which is not supported; save it without compression or instancing");
  }
  return model;
}

glm::dmat4 transformOf(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) return glm::make_mat4(node.matrix.data());
  glm::dmat4 matrix(1);
  if (node.translation.size() == 3) {
    matrix = glm::translate(matrix, glm::make_vec3(node.translation.data()));
  }
  if (node.rotation.size() == 4) {
    const std::vector<double>& r = node.rotation;
    matrix *= glm::mat4_cast(glm::dquat(r[3], r[0], r[1], r[2]));
  }
  if (node.scale.size() == 3) matrix = glm::scale(matrix, glm::make_vec3(node.scale.data()));
  return matrix;
}

class GltfReader {
 public:
  explicit GltfReader(const Source& source) : source_(source), model_(load(source)), faces_(out_) {}

  InputMesh read();

 private:
  struct Visit {
    int node;
    glm::dmat4 parent;
  };

  std::vector<int> rootNodes() const;
  bool visitNodes();
  bool addMesh(int number, const glm::dmat4& transform);
  void addPrimitive(const tinygltf::Primitive& primitive, const glm::dmat4& transform,
                    std::map<int, Index>& offsets);
  void addTriangles(const tinygltf::Primitive& primitive, const std::vector<std::uint32_t>& corners,
                    Index offset, bool mirrored);
  void addRepairs();

  const Source& source_;
  tinygltf::Model model_;
  InputMesh out_;
  FaceBuilder faces_;
  std::size_t otherPrimitives_ = 0, skinnedNodes_ = 0;
};

InputMesh GltfReader::read() {
  const bool finished = visitNodes();
  if (!finished) return {};
  if (out_.faceCount() == 0) {
    source_.fail(model_.meshes.empty() ? "it has no meshes" : "none of its nodes shows triangles");
  }
  addRepairs();
  return std::move(out_);
}

/// The roots of the scene that the file shows first, or of all nodes when it has no scene.
std::vector<int> GltfReader::rootNodes() const {
  const std::size_t shown =
      model_.defaultScene < 0 ? 0 : static_cast<std::size_t>(model_.defaultScene);
  if (shown < model_.scenes.size()) return model_.scenes[shown].nodes;
  if (!model_.scenes.empty()) source_.fail("its default scene does not exist");
  std::vector<bool> isChild(model_.nodes.size(), false);
  for (const tinygltf::Node& node : model_.nodes) {
    for (const int child : node.children) {
      const bool exists = child >= 0 && static_cast<std::size_t>(child) < isChild.size();
      if (exists) isChild[static_cast<std::size_t>(child)] = true;
    }
  }
  std::vector<int> roots;
  for (std::size_t n = 0; n < isChild.size(); ++n) {
    if (!isChild[n]) roots.push_back(static_cast<int>(n));
  }
  return roots;
}

/// Visits every node once, parents first, children in order. \returns false when cancelled.
bool GltfReader::visitNodes() {
  if (model_.nodes.empty()) {
    for (std::size_t m = 0; m < model_.meshes.size(); ++m) {
      if (!addMesh(static_cast<int>(m), glm::dmat4(1))) return false;
    }
    return true;
  }
  std::vector<Visit> stack;
  const auto push = [&](const std::vector<int>& nodes, const glm::dmat4& parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) stack.push_back({*node, parent});
  };
  std::vector<bool> visited(model_.nodes.size(), false);
  for (push(rootNodes(), glm::dmat4(1)); !stack.empty();) {
    const Visit visit = stack.back();
    stack.pop_back();
    if (visit.node < 0 || static_cast<std::size_t>(visit.node) >= model_.nodes.size()) {
      source_.fail("it names node " + std::to_string(visit.node) + " but there are " +
                   std::to_string(model_.nodes.size()));
    }
    const std::size_t number = static_cast<std::size_t>(visit.node);
    if (visited[number]) {
      source_.fail("its node " + std::to_string(visit.node) +
                   " hangs below two nodes or below itself");
    }
    visited[number] = true;
    const tinygltf::Node& node = model_.nodes[number];
    const glm::dmat4 transform = visit.parent * transformOf(node);
    if (node.mesh >= 0) {
      // A skin places its mesh by the joints alone; without its pose the mesh is as it was
      // modelled.
      if (node.skin >= 0) ++skinnedNodes_;
      if (!addMesh(node.mesh, node.skin >= 0 ? glm::dmat4(1) : transform)) return false;
    }
    push(node.children, transform);
  }
  if (std::find(visited.begin(), visited.end(), true) == visited.end()) {
    source_.fail("its scene shows no node");
  }
  return true;
}

/// \returns false when cancelled.
bool GltfReader::addMesh(int number, const glm::dmat4& transform) {
  if (source_.report(source_.begin())) return false;
  if (static_cast<std::size_t>(number) >= model_.meshes.size()) {
    source_.fail("it names mesh " + std::to_string(number) + " but there are " +
                 std::to_string(model_.meshes.size()));
  }
  // Primitives may share an accessor: its vertices come once per node.
  std::map<int, Index> offsets;
  for (const auto& primitive : model_.meshes[static_cast<std::size_t>(number)].primitives) {
    addPrimitive(primitive, transform, offsets);
  }
  return true;
}

void GltfReader::addPrimitive(const tinygltf::Primitive& primitive, const glm::dmat4& transform,
                              std::map<int, Index>& offsets) {
  const bool triangles = primitive.mode == TINYGLTF_MODE_TRIANGLES ||
                         primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
                         primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
  const auto position = primitive.attributes.find("POSITION");
  if (!triangles || position == primitive.attributes.end()) {
    ++otherPrimitives_;
    return;
  }
  const int accessor = position->second;
  auto known = offsets.find(accessor);
  if (known == offsets.end()) {
    known = offsets.emplace(accessor, static_cast<Index>(out_.positions.size())).first;
    const std::vector<glm::dvec3> positions = gltfPositions(source_, model_, accessor);
    if (positions.size() >= kNone - out_.positions.size()) source_.fail("it has too many vertices");
    for (const glm::dvec3& p : positions) {
      out_.positions.emplace_back(transform * glm::dvec4(p, 1));
    }
  }
  const std::size_t count = model_.accessors[static_cast<std::size_t>(accessor)].count;
  std::vector<std::uint32_t> corners;
  if (primitive.indices >= 0) {
    corners = gltfIndices(source_, model_, primitive.indices);
    for (const std::uint32_t corner : corners) {
      if (corner < count) continue;
      source_.fail("a face names vertex " + std::to_string(corner) + " but there are " +
                   std::to_string(count) + " (counted from 0)");
    }
  } else {
    corners.resize(count);
    std::iota(corners.begin(), corners.end(), 0u);
  }
  const double determinant = glm::determinant(glm::dmat3(transform));
  addTriangles(primitive, corners, known->second, determinant < 0);
}

/// The triangles of a list, strip or fan; a mirrored node turns them over.
void GltfReader::addTriangles(const tinygltf::Primitive& primitive,
                              const std::vector<std::uint32_t>& corners, Index offset,
                              bool mirrored) {
  const bool list = primitive.mode == TINYGLTF_MODE_TRIANGLES;
  const bool fan = primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
  if (list && corners.size() % 3 != 0) {
    source_.fail("it has a list of triangles with " + std::to_string(corners.size()) +
                 " corners, which is not a multiple of 3");
  }
  for (std::size_t i = 2; i < corners.size(); i += list ? 3 : 1) {
    Index a = corners[fan ? 0 : i - 2], b = corners[i - 1], c = corners[i];
    if (!list && !fan && i % 2 == 1) std::swap(a, b);
    // In a strip, triangles that repeat a vertex only lead it around a corner.
    if (!list && (a == b || b == c || c == a)) continue;
    if (mirrored) std::swap(b, c);
    faces_.addTriangle(offset + a, offset + b, offset + c);
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
}

}  // namespace

InputMesh readGltf(const Source& source) { return GltfReader(source).read(); }

}  // namespace chartflood
