#include "core/model/triangulate_faces.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/model/needless_corners.h"
#include "core/model/triangulate_polygon.h"

namespace chartflood {

namespace {

class FaceTriangulation {
 public:
  FaceTriangulation(const InputMesh& input, MeshData& d) : input_(input), d_(d) {}

  TriangulationFindings run(bool joinPlaces) {
    const std::size_t faces = input_.faceCount();
    if (faces > kNone / 4) throw ReadError(input_.file, "it has too many faces");
    for (const Index corner : input_.corners) CF_CHECK(corner < input_.positions.size());
    if (joinPlaces) needless_ = needlessCorners(input_);
    d_.triangles.reserve(input_.corners.size() / 3);
    for (std::size_t f = 0; f < faces; ++f) addFace(f);
    if (d_.triangles.empty()) {
      throw ReadError(input_.file, faces == 0 ? "it has no faces"
                                              : "none of its faces has three different corners");
    }
    finish();
    return findings_;
  }

 private:
  void addFace(std::size_t face);
  void outline(std::size_t face);
  void leaveIdentity(std::size_t facesSoFar);
  void finish();

  const InputMesh& input_;
  MeshData& d_;
  TriangulationFindings findings_;
  std::vector<std::size_t> needless_;
  bool identity_ = true;  ///< each input face is one triangle with the same corners
  std::vector<Index> faceOfTriangle_, triangleBegin_, inputFace_;
  std::vector<std::pair<Index, Index>> diagonals_;
  PolygonTriangulator polygon_;
  std::vector<Index> outline_, corner_;  ///< of the present face: vertices, places in the input
};

void FaceTriangulation::leaveIdentity(std::size_t facesSoFar) {
  identity_ = false;
  faceOfTriangle_.resize(facesSoFar);
  triangleBegin_.resize(facesSoFar);
  inputFace_.resize(facesSoFar);
  for (std::size_t i = 0; i < facesSoFar; ++i) {
    faceOfTriangle_[i] = triangleBegin_[i] = inputFace_[i] = static_cast<Index>(i);
  }
  d_.inputCorner.resize(3 * facesSoFar);
  for (std::size_t i = 0; i < d_.inputCorner.size(); ++i) {
    d_.inputCorner[i] = static_cast<Index>(i);
  }
}

/// The corners of a face that are not needless.
void FaceTriangulation::outline(std::size_t face) {
  const std::span<const Index> vertices = input_.face(face);
  const std::size_t first = static_cast<std::size_t>(vertices.data() - input_.corners.data());
  outline_.clear();
  corner_.clear();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (std::binary_search(needless_.begin(), needless_.end(), first + i)) continue;
    outline_.push_back(vertices[i]);
    corner_.push_back(static_cast<Index>(first + i));
  }
}

void FaceTriangulation::addFace(std::size_t face) {
  const std::span<const Index> v = input_.face(face);
  const bool triangle = v.size() == 3 && v[0] != v[1] && v[1] != v[2] && v[2] != v[0];
  if (identity_ && triangle && needless_.empty()) {
    d_.triangles.push_back({v[0], v[1], v[2]});
    return;
  }
  outline(face);
  polygon_.run(outline_, input_.positions);
  const std::size_t made = polygon_.triangles().size(), first = d_.triangles.size();
  if (identity_ && (v.size() != 3 || made != 1)) leaveIdentity(face);
  if (v.size() >= 3) findings_.droppedTriangles += v.size() - 2 - made;
  for (const auto& [a, b] : polygon_.diagonals()) {
    diagonals_.emplace_back(static_cast<Index>(3 * first) + a, static_cast<Index>(3 * first) + b);
  }
  for (const auto& t : polygon_.triangles()) {
    d_.triangles.push_back({outline_[t[0]], outline_[t[1]], outline_[t[2]]});
    if (!identity_) {
      d_.inputCorner.insert(d_.inputCorner.end(), {corner_[t[0]], corner_[t[1]], corner_[t[2]]});
    }
  }
  if (made == 0) ++findings_.emptyFaces;
  if (made == 0 || identity_) return;
  const Index number = static_cast<Index>(triangleBegin_.size());
  triangleBegin_.push_back(static_cast<Index>(first));
  inputFace_.push_back(static_cast<Index>(face));
  faceOfTriangle_.insert(faceOfTriangle_.end(), made, number);
}

void FaceTriangulation::finish() {
  d_.faceCount = identity_ ? d_.triangles.size() : triangleBegin_.size();
  if (!identity_) {
    triangleBegin_.push_back(static_cast<Index>(d_.triangles.size()));
    const bool dropped = d_.faceCount != input_.faceCount();
    const bool polygons = d_.faceCount != d_.triangles.size();
    if (dropped) d_.inputFace = std::move(inputFace_);
    if (polygons) {
      d_.faceOfTriangle = std::move(faceOfTriangle_);
      d_.triangleBegin = std::move(triangleBegin_);
    }
  }
  d_.opposite.assign(3 * d_.triangles.size(), kNone);
  for (const auto& [side, other] : diagonals_) {
    d_.opposite[side] = other;
    d_.opposite[other] = side;
  }
}

}  // namespace

TriangulationFindings triangulateFaces(const InputMesh& input, bool joinPlaces, MeshData& d) {
  return FaceTriangulation(input, d).run(joinPlaces);
}

}  // namespace chartflood
