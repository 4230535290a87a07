#include "core/segment/growth/vsa_price.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

/// What the mean |n - N|^2 over the surface counts against seam length over the square root of the
/// area.
constexpr double kFlatnessWeight = 100;

class VsaPrice final : public ChartPrice {
 public:
  VsaPrice(const std::vector<GrowthFace>& faces, std::vector<glm::dvec3> normals)
      : faces_(faces), normals_(std::move(normals)) {
    double area = 0;
    for (const GrowthFace& face : faces) area += static_cast<double>(face.area);
    factor_ = kFlatnessWeight / std::max(area, 1e-300);
  }

  void fit(std::span<const Index> label) override {
    std::vector<glm::dvec3> sums(normals_.size(), glm::dvec3(0));
    std::vector<double> areas(normals_.size(), 0);
    for (Index f = 0; f < label.size(); ++f) {
      sums[label[f]] += static_cast<double>(faces_[f].area) * glm::dvec3(faces_[f].normal);
      areas[label[f]] += static_cast<double>(faces_[f].area);
    }
    // The mean normal is the exact minimiser; where normals cancel any will do.
    for (std::size_t c = 0; c < sums.size(); ++c) {
      const double length = glm::length(sums[c]);
      if (length > 1e-9 * areas[c]) normals_[c] = sums[c] / length;
    }
  }

  double of(Index face, Index chart) const override {
    const glm::dvec3 d = glm::dvec3(faces_[face].normal) - normals_[chart];
    return factor_ * static_cast<double>(faces_[face].area) * glm::dot(d, d);
  }

 private:
  const std::vector<GrowthFace>& faces_;
  std::vector<glm::dvec3> normals_;
  double factor_ = 0;
};

}  // namespace

std::unique_ptr<ChartPrice> makeVsaPrice(const std::vector<GrowthFace>& faces,
                                         std::vector<glm::dvec3> normals) {
  return std::make_unique<VsaPrice>(faces, std::move(normals));
}

}  // namespace chartflood
