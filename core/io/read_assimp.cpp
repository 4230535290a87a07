#include "core/io/read_assimp.h"

#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include "core/base/counted.h"
#include "core/io/face_builder.h"
#include "core/io/weld.h"

namespace chartflood {

namespace {

class SceneReader {
 public:
  SceneReader(const Source& source, const aiScene& scene)
      : source_(source), scene_(scene), faces_(mesh_) {}

  InputMesh read();

 private:
  struct Visit {
    const aiNode* node;
    aiMatrix4x4 parent;
  };
  bool addMesh(unsigned number, const aiMatrix4x4& transform);

  const Source& source_;
  const aiScene& scene_;
  InputMesh mesh_;
  FaceBuilder faces_;
  PositionTable table_;
  std::size_t pointsAndLines_ = 0;
};

InputMesh SceneReader::read() {
  std::vector<Visit> stack;
  if (scene_.mRootNode != nullptr) stack.push_back({scene_.mRootNode, aiMatrix4x4()});
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const aiMatrix4x4 transform = visit.parent * visit.node->mTransformation;
    for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
      if (!addMesh(visit.node->mMeshes[i], transform)) return {};
    }
    for (unsigned i = visit.node->mNumChildren; i > 0; --i) {
      stack.push_back({visit.node->mChildren[i - 1], transform});
    }
  }
  if (mesh_.faceCount() == 0) source_.fail("it has no faces");
  if (pointsAndLines_ > 0) {
    mesh_.repairs.push_back(
        {"points-and-lines-ignored", pointsAndLines_,
         counted(pointsAndLines_, "point or line was", "points or lines were") + " left out."});
  }
  mesh_.positions = std::move(table_.positions());
  return std::move(mesh_);
}

/// \returns false when cancelled.
bool SceneReader::addMesh(unsigned number, const aiMatrix4x4& transform) {
  if (source_.report(source_.begin())) return false;
  if (number >= scene_.mNumMeshes) source_.fail("a node names a mesh that does not exist");
  const aiMesh& part = *scene_.mMeshes[number];
  std::vector<Index> vertex(part.mNumVertices);
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    const aiVector3D p = transform * part.mVertices[v];
    vertex[v] = table_.indexOf(glm::dvec3(p.x, p.y, p.z));
  }
  const bool mirrored = transform.Determinant() < 0;
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices < 3) {
      ++pointsAndLines_;
      continue;
    }
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      const unsigned corner = face.mIndices[mirrored ? face.mNumIndices - 1 - i : i];
      if (corner >= part.mNumVertices) {
        source_.fail("a face names vertex " + std::to_string(corner) + " but there are " +
                     std::to_string(part.mNumVertices) + " (counted from 0)");
      }
      faces_.addCorner(vertex[corner]);
    }
    faces_.endFace();
  }
  return true;
}

}  // namespace

InputMesh readAssimp(const Source& source, std::string_view extension) {
  Assimp::Importer importer;
  std::string error;
  const aiScene* scene = nullptr;
  try {
    scene = importer.ReadFileFromMemory(source.begin(), source.bytes.size(), 0,
                                        std::string(extension).c_str());
    error = importer.GetErrorString();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    error = e.what();
  }
  if (scene == nullptr) {
    error = error.substr(0, error.find('\n'));
    source.fail(error.empty() ? "the import library does not know its content" : error);
  }
  return SceneReader(source, *scene).read();
}

}  // namespace chartflood
