#pragma once
/// Numbers of faces that need no memory where faces are triangles.

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace chartflood {

/// One value a face: a view of the triangles' where faces are triangles, which must outlive it,
/// else values of its own.
class FaceValues {
 public:
  FaceValues() = default;
  explicit FaceValues(std::span<const double> ofTriangles) : values_(ofTriangles) {}
  explicit FaceValues(std::vector<double> own) : own_(std::move(own)), values_(own_) {}
  FaceValues(FaceValues&&) = default;  // the memory of a vector stays in its place
  FaceValues& operator=(FaceValues&&) = default;
  FaceValues(const FaceValues&) = delete;
  FaceValues& operator=(const FaceValues&) = delete;
  ~FaceValues() = default;

  double operator[](std::size_t face) const { return values_[face]; }
  std::size_t size() const { return values_.size(); }
  const double* data() const { return values_.data(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 private:
  std::vector<double> own_;
  std::span<const double> values_;
};

}  // namespace chartflood
