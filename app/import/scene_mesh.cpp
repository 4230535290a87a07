#include "app/import/scene_mesh.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <assimp/scene.h>

#include "core/io/read/face_builder.h"
#include "core/io/read/weld.h"

namespace chartflood {

namespace {

class SceneReader {
 public:
  explicit SceneReader(const aiScene& scene) : scene_(scene), faces_(reply_.mesh) {}

  ImportReply read();

 private:
  struct Visit {
    const aiNode* node;
    aiMatrix4x4 parent;
  };
  bool addMesh(unsigned number, const aiMatrix4x4& transform);
  bool refuse(std::string reason);

  const aiScene& scene_;
  ImportReply reply_;
  FaceBuilder faces_;
  PositionTable table_;
};

bool SceneReader::refuse(std::string reason) {
  reply_ = ImportReply{ImportOutcome::Refused, std::move(reason), {}, 0};
  return false;
}

ImportReply SceneReader::read() {
  std::vector<Visit> stack;
  if (scene_.mRootNode != nullptr) stack.push_back({scene_.mRootNode, aiMatrix4x4()});
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const aiMatrix4x4 transform = visit.parent * visit.node->mTransformation;
    for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
      if (!addMesh(visit.node->mMeshes[i], transform)) return std::move(reply_);
    }
    for (unsigned i = visit.node->mNumChildren; i > 0; --i) {
      stack.push_back({visit.node->mChildren[i - 1], transform});
    }
  }
  reply_.mesh.positions = std::move(table_.positions());
  reply_.outcome = ImportOutcome::Mesh;
  return std::move(reply_);
}

/// \returns false when the scene is refused
bool SceneReader::addMesh(unsigned number, const aiMatrix4x4& transform) {
  if (number >= scene_.mNumMeshes) return refuse("a node names a mesh that does not exist");
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
      ++reply_.pointsAndLines;
      continue;
    }
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      const unsigned corner = face.mIndices[mirrored ? face.mNumIndices - 1 - i : i];
      if (corner >= part.mNumVertices) {
        return refuse("a face names vertex " + std::to_string(corner) + " but there are " +
                      std::to_string(part.mNumVertices) + ", counted from 0");
      }
      faces_.addCorner(vertex[corner]);
    }
    faces_.endFace();
  }
  return true;
}

}  // namespace

ImportReply meshOfScene(const aiScene& scene) { return SceneReader(scene).read(); }

}  // namespace chartflood
