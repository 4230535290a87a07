#include "render/gauss_layer.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace chartflood {

GaussLayer::GaussLayer(const Mesh& mesh, const GaussArea& gauss) {
  uploadFaces(mesh, gauss);
  uploadEdges(mesh, gauss);
  uploadVertices(mesh, gauss);
}

void GaussLayer::uploadFaces(const Mesh& mesh, const GaussArea& gauss) {
  const double mean = mesh.surfaceArea() / static_cast<double>(mesh.triangleCount());
  const double smallest = std::max(1e-9 * mean, 1e-300);
  std::vector<float> values;
  std::vector<WeightedValue> weighted;
  values.reserve(mesh.triangleCount());
  weighted.reserve(mesh.triangleCount());
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const double area = std::max(mesh.triangleArea()[t], smallest);
    const double value = gauss.triangle[t] / area;
    values.push_back(static_cast<float>(value));
    weighted.push_back({value, area});
  }
  faceRange_ = rangeFromZero(weighted);
  faceValues_.upload<float>(GL_R32F, values);
}

void GaussLayer::uploadEdges(const Mesh& mesh, const GaussArea& gauss) {
  edgeCount_ = gauss.sharpEdges.size();
  std::vector<glm::vec4> ends;
  std::vector<WeightedValue> weighted;
  ends.reserve(2 * edgeCount_);
  for (std::size_t i = 0; i < edgeCount_; ++i) {
    const glm::dvec3& a = mesh.positions()[mesh.sideStart(gauss.sharpEdges[i])];
    const glm::dvec3& b = mesh.positions()[mesh.sideEnd(gauss.sharpEdges[i])];
    const double length = std::max(glm::distance(a, b), 1e-12);
    const double value = gauss.edge[i] / length;
    weighted.push_back({value, length});
    ends.emplace_back(glm::vec3(a), static_cast<float>(value));
    ends.emplace_back(glm::vec3(b), 0.0f);
  }
  edgeRange_ = rangeFromZero(weighted);
  edges_.upload<glm::vec4>(GL_RGBA32F, ends);
}

void GaussLayer::uploadVertices(const Mesh& mesh, const GaussArea& gauss) {
  vertexCount_ = gauss.corners.size();
  std::vector<glm::vec4> points;
  std::vector<WeightedValue> weighted;
  for (std::size_t i = 0; i < vertexCount_; ++i) {
    points.emplace_back(glm::vec3(mesh.positions()[gauss.corners[i]]),
                        static_cast<float>(gauss.corner[i]));
    points.emplace_back(0.0f);
    weighted.push_back({gauss.corner[i], 1});
  }
  vertexRange_ = rangeFromZero(weighted);
  vertices_.upload<glm::vec4>(GL_RGBA32F, points);
}

}  // namespace chartflood
