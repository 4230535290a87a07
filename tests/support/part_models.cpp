#include "tests/support/part_models.h"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace chartflood::test {

Index PartModel::add(const glm::dvec3& position) {
  positions_.push_back(position);
  return static_cast<Index>(positions_.size() - 1);
}

void PartModel::quad(Index a, Index b, Index c, Index d) {
  faces_.push_back({a, b, c});
  faces_.push_back({a, c, d});
}

void PartModel::addRevolved(const glm::dvec3& base, std::span<const glm::dvec2> profile,
                            Index around) {
  std::vector<std::vector<Index>> rows;
  for (const glm::dvec2& point : profile) {
    rows.emplace_back();
    for (Index i = 0; i < (point.x > 0 ? around : 1); ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      rows.back().push_back(
          add(base + glm::dvec3(point.x * std::cos(angle), point.x * std::sin(angle), point.y)));
    }
  }
  for (std::size_t r = 0; r + 1 < rows.size(); ++r) {
    const auto &low = rows[r], &high = rows[r + 1];
    for (Index i = 0; i < around; ++i) {
      const Index j = (i + 1) % around;
      if (low.size() == 1) {
        faces_.push_back({low[0], high[j], high[i]});
      } else if (high.size() == 1) {
        faces_.push_back({low[i], low[j], high[0]});
      } else {
        quad(low[i], low[j], high[j], high[i]);
      }
    }
  }
}

void PartModel::addBall(const glm::dvec3& center, double radius, Index around) {
  std::vector<glm::dvec2> profile;
  const Index rows = around / 2;
  for (Index i = 0; i <= rows; ++i) {
    const double angle = std::numbers::pi * i / rows;
    const bool pole = i == 0 || i == rows;
    profile.emplace_back(pole ? 0 : radius * std::sin(angle), -radius * std::cos(angle));
  }
  addRevolved(center, profile, around);
}

void PartModel::addBox(const glm::dvec3& corner, const glm::dvec3& size, Index n) {
  std::map<std::tuple<Index, Index, Index>, Index> known;
  const auto at = [&](const glm::uvec3& place) {
    const auto [found, fresh] = known.try_emplace({place.x, place.y, place.z}, 0);
    if (fresh) found->second = add(corner + size * glm::dvec3(place) / static_cast<double>(n));
    return found->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool far : {false, true}) {
      for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j < n; ++j) {
          const auto point = [&](Index x, Index y) {
            glm::uvec3 place(0);
            place[axis] = far ? n : 0;
            place[(axis + 1) % 3] = x;
            place[(axis + 2) % 3] = y;
            return at(place);
          };
          const Index a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1),
                      d = point(i, j + 1);
          far ? quad(a, b, c, d) : quad(d, c, b, a);
        }
      }
    }
  }
}

void PartModel::addTetrahedron(const glm::dvec3& center, double size) {
  const Index a = add(center + size * glm::dvec3(1, 1, 1));
  const Index b = add(center + size * glm::dvec3(1, -1, -1));
  const Index c = add(center + size * glm::dvec3(-1, 1, -1));
  const Index d = add(center + size * glm::dvec3(-1, -1, 1));
  faces_.insert(faces_.end(), {{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}});
}

void PartModel::addFan(const glm::dvec3& center, double radius, Index triangles) {
  const Index middle = add(center);
  for (Index i = 0; i <= triangles; ++i) {
    const double angle = 0.9 * i;
    add(center + radius * glm::dvec3(std::cos(angle), std::sin(angle), 0));
  }
  for (Index i = 1; i <= triangles; ++i) faces_.push_back({middle, middle + i, middle + i + 1});
}

void PartModel::addGrid(const glm::dvec3& corner, double size, Index n) {
  const Index first = static_cast<Index>(positions_.size());
  for (Index y = 0; y <= n; ++y) {
    for (Index x = 0; x <= n; ++x) add(corner + size / n * glm::dvec3(x, y, 0));
  }
  for (Index y = 0; y < n; ++y) {
    for (Index x = 0; x < n; ++x) {
      const Index a = first + y * (n + 1) + x;
      quad(a, a + 1, a + n + 2, a + n + 1);
    }
  }
}

void PartModel::addPrism(const glm::dvec3& base, std::span<const glm::dvec2> outline,
                         double height) {
  const Index first = static_cast<Index>(positions_.size());
  const auto corners = static_cast<Index>(outline.size());
  for (const double z : {0.0, height}) {
    for (const glm::dvec2& corner : outline) add(base + glm::dvec3(corner, z));
  }
  for (Index i = 0; i < corners; ++i) {
    const Index a = first + i, b = first + (i + 1) % corners;
    quad(a, b, b + corners, a + corners);
    if (i == 0 || i + 1 == corners) continue;
    faces_.push_back({first, b, a});
    faces_.push_back({first + corners, a + corners, b + corners});
  }
}

}  // namespace chartflood::test
