#include "tests/support/exported_obj.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace chartflood::test {

namespace {

using Point = std::array<double, 2>;

struct Triangle {
  std::array<long, 3> vertex, texture;
  std::size_t chart;
};

std::vector<Triangle> fans(const ExportedObj& obj, TextureFigures& figures) {
  std::vector<Triangle> triangles;
  std::map<std::string, std::size_t> numbers;
  for (const ExportedObj::Face& face : obj.faces) {
    if (std::count(face.texture.begin(), face.texture.end(), -1) > 0) {
      ++figures.facesWithoutTexture;
      continue;
    }
    const auto [entry, fresh] = numbers.emplace(face.group, figures.charts.size());
    if (fresh) figures.charts.push_back({.group = face.group});
    for (std::size_t i = 1; i + 1 < face.vertex.size(); ++i) {
      const std::array<long, 3> v{face.vertex[0], face.vertex[i], face.vertex[i + 1]};
      if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
      triangles.push_back(
          {v, {face.texture[0], face.texture[i], face.texture[i + 1]}, entry->second});
    }
  }
  return triangles;
}

double signedArea(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Euler number 1, each border vertex passed once, one border loop.
bool isDisk(const std::vector<std::array<long, 3>>& triangles) {
  std::set<std::pair<long, long>> directed;
  std::set<long> vertices;
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      vertices.insert(t[i]);
      if (!directed.emplace(t[i], t[(i + 1) % 3]).second) return false;
    }
  }
  std::size_t edges = 0;
  std::map<long, long> next;
  for (const auto& [a, b] : directed) {
    const bool border = !directed.contains({b, a});
    if (border || a < b) ++edges;
    if (border && !next.emplace(a, b).second) return false;  // a pinch
  }
  if (next.empty()) return false;
  std::size_t around = 0;
  for (long at = next.begin()->first; around == 0 || at != next.begin()->first; at = next[at]) {
    ++around;
  }
  return around == next.size() && vertices.size() + triangles.size() == edges + 1;
}

void checkTopology(const ExportedObj& obj, const std::vector<Triangle>& triangles,
                   TextureFigures& figures) {
  using Place = std::array<double, 3>;
  std::map<Place, long> welded;
  std::vector<std::vector<std::array<long, 3>>> apart(figures.charts.size());
  std::vector<std::vector<std::array<long, 3>>> together(figures.charts.size());
  for (const Triangle& t : triangles) {
    std::array<long, 3> one{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& p = obj.textures[static_cast<std::size_t>(t.texture[i])];
      const Place key{static_cast<double>(t.vertex[i]), std::round(p[0] * 1e7),
                      std::round(p[1] * 1e7)};
      one[i] = welded.emplace(key, t.texture[i]).first->second;
    }
    apart[t.chart].push_back(t.texture);
    together[t.chart].push_back(one);
  }
  for (std::size_t c = 0; c < figures.charts.size(); ++c) {
    figures.charts[c].triangles = apart[c].size();
    figures.charts[c].disk = isDisk(apart[c]);
    figures.charts[c].weldedDisk = isDisk(together[c]);
  }
}

/// Which side of a to b a place lies on; exactly opposite for b to a, so that a pixel centre on a
/// shared edge belongs to one triangle alone.
bool inside(const Point& a, const Point& b, const Point& place) {
  const bool swapped = b < a;
  const double side = swapped ? -signedArea(b, a, place) : signedArea(a, b, place);
  return side > 0 || (side == 0 && swapped);
}

void raster(const ExportedObj& obj, const std::vector<Triangle>& triangles, int side,
            TextureFigures& figures) {
  constexpr std::size_t kFree = static_cast<std::size_t>(-1);
  const auto width = static_cast<std::size_t>(side);
  std::vector<std::size_t> owner(width * width, kFree);
  std::size_t covered = 0;
  for (const Triangle& t : triangles) {
    std::array<Point, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& uv = obj.textures[static_cast<std::size_t>(t.texture[i])];
      p[i] = {uv[0] * side, uv[1] * side};
    }
    if (signedArea(p[0], p[1], p[2]) <= 0) continue;
    const auto range = [&](std::size_t axis) {
      const auto [low, high] = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
      return std::pair(std::max(0, static_cast<int>(std::floor(low - 0.5))),
                       std::min(side - 1, static_cast<int>(std::ceil(high - 0.5))));
    };
    const auto [left, right] = range(0);
    const auto [bottom, top] = range(1);
    for (int y = bottom; y <= top; ++y) {
      for (int x = left; x <= right; ++x) {
        const Point place{x + 0.5, y + 0.5};
        if (!inside(p[0], p[1], place) || !inside(p[1], p[2], place) || !inside(p[2], p[0], place))
          continue;
        std::size_t& mine =
            owner[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
        if (mine == kFree) {
          mine = t.chart;
          ++covered;
        } else {
          ++(mine == t.chart ? figures.overlapInside : figures.overlapBetween);
        }
      }
    }
  }
  figures.covered = static_cast<double>(covered) / static_cast<double>(owner.size());
}

}  // namespace

ExportedObj parseObj(const std::filesystem::path& file) {
  ExportedObj obj;
  std::ifstream stream(file);
  std::string group;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      auto& v = obj.vertices.emplace_back();
      words >> v[0] >> v[1] >> v[2];
    } else if (kind == "vt") {
      auto& t = obj.textures.emplace_back();
      words >> t[0] >> t[1];
    } else if (kind == "g") {
      words >> group;
    } else if (kind == "f") {
      ExportedObj::Face& face = obj.faces.emplace_back();
      face.group = group;
      for (std::string corner; words >> corner;) {
        long vertex = 0, texture = 0;
        std::sscanf(corner.c_str(), "%ld/%ld", &vertex, &texture);
        face.vertex.push_back(vertex - 1);
        face.texture.push_back(texture - 1);
      }
    }
  }
  return obj;
}

TextureFigures measureTexture(const ExportedObj& obj, int side) {
  TextureFigures figures;
  const std::vector<Triangle> triangles = fans(obj, figures);
  checkTopology(obj, triangles, figures);
  figures.lowest = 1;
  for (const Point& p : obj.textures) {
    figures.lowest = std::min({figures.lowest, p[0], p[1]});
    figures.highest = std::max({figures.highest, p[0], p[1]});
  }
  for (const Triangle& t : triangles) {
    const auto at = [&](std::size_t i) {
      return obj.textures[static_cast<std::size_t>(t.texture[i])];
    };
    figures.charts[t.chart].flipped += signedArea(at(0), at(1), at(2)) > 0 ? 0 : 1;
  }
  raster(obj, triangles, side, figures);
  return figures;
}

}  // namespace chartflood::test
