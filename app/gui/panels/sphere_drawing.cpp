#include "app/gui/panels/sphere_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

constexpr float kFullTurn = 2 * std::numbers::pi_v<float>;
constexpr int kRing = 72;  // pieces of a circle

ImU32 faded(ImU32 color, float alpha) {
  const auto a = static_cast<ImU32>(std::lround(255 * std::clamp(alpha, 0.0f, 1.0f)));
  return (color & ~IM_COL32_A_MASK) | (a << IM_COL32_A_SHIFT);
}

/// Points of the shorter great arc, about 5 degrees apart, both ends included.
void appendArc(const glm::vec3& a, const glm::vec3& b, std::vector<glm::vec3>& out) {
  const float angle = std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f));
  const int pieces = std::clamp(static_cast<int>(angle / 0.09f) + 1, 1, 40);
  const float sine = std::sin(angle);
  for (int i = 0; i <= pieces; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(pieces);
    // Near 0 and 180 degrees the slerp has no direction; the chord will do.
    const glm::vec3 p = sine < 1e-4f
                            ? a + t * (b - a)
                            : (std::sin((1 - t) * angle) * a + std::sin(t * angle) * b) / sine;
    const float length = glm::length(p);
    out.push_back(length > 1e-6f ? p / length : a);
  }
}

}  // namespace

SphereDrawing::SphereDrawing(const Ui& ui, ImVec2 center, float radius, const Camera& camera)
    : ui_(ui), list_(*ImGui::GetWindowDrawList()), center_(center), radius_(radius),
      right_(camera.right()), up_(camera.upward()), toward_(-camera.forward()),
      upright_(camera.up == UpAxis::Z ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0)) {}

ImVec2 SphereDrawing::place(const glm::vec3& n) const {
  return {center_.x + radius_ * glm::dot(n, right_), center_.y - radius_ * glm::dot(n, up_)};
}

void SphereDrawing::ball() const {
  const ImU32 middle = ui_.theme.palette.ball, rim = ui_.theme.palette.ballRim;
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
  list_.PrimReserve(3 * kRing, kRing + 1);
  const auto first = static_cast<unsigned>(list_._VtxCurrentIdx);
  list_.PrimWriteVtx({center_.x - 0.28f * radius_, center_.y - 0.32f * radius_}, white, middle);
  for (int i = 0; i < kRing; ++i) {
    const float angle = kFullTurn * static_cast<float>(i) / kRing;
    list_.PrimWriteVtx(
        {center_.x + radius_ * std::cos(angle), center_.y + radius_ * std::sin(angle)}, white, rim);
  }
  for (unsigned i = 0; i < kRing; ++i) {
    list_.PrimWriteIdx(static_cast<ImDrawIdx>(first));
    list_.PrimWriteIdx(static_cast<ImDrawIdx>(first + 1 + i));
    list_.PrimWriteIdx(static_cast<ImDrawIdx>(first + 1 + (i + 1) % kRing));
  }
  list_.AddCircle(center_, radius_, ui_.theme.palette.dim, kRing, ui_.px(1));
}

void SphereDrawing::polyline(std::span<const glm::vec3> points, Half half, ImU32 color,
                             float width) const {
  std::vector<ImVec2> run;
  const auto end = [&] {
    if (run.size() > 1)
      list_.AddPolyline(run.data(), static_cast<int>(run.size()), color, 0, width);
    run.clear();
  };
  for (const glm::vec3& p : points) {
    if (!on(p, half)) {
      end();
      continue;
    }
    run.push_back(place(p));
  }
  end();
}

void SphereDrawing::grid(Half half, ImU32 color) const {
  const glm::vec3 a = std::abs(upright_.y) > 0.5f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  const glm::vec3 b = glm::cross(upright_, a);
  std::vector<glm::vec3> ring(kRing + 1);
  for (int m = 0; m < 6; ++m) {
    const float angle = kFullTurn * static_cast<float>(m) / 12;
    const glm::vec3 side = std::cos(angle) * a + std::sin(angle) * b;
    for (std::size_t i = 0; i <= kRing; ++i) {
      const float t = kFullTurn * static_cast<float>(i) / kRing;
      ring[i] = std::cos(t) * upright_ + std::sin(t) * side;
    }
    polyline(ring, half, color, ui_.px(1));
  }
  for (int parallel = -2; parallel <= 2; ++parallel) {
    const float latitude = kFullTurn * static_cast<float>(parallel) / 12;
    for (std::size_t i = 0; i <= kRing; ++i) {
      const float t = kFullTurn * static_cast<float>(i) / kRing;
      ring[i] =
          std::sin(latitude) * upright_ + std::cos(latitude) * (std::cos(t) * a + std::sin(t) * b);
    }
    polyline(ring, half, color, ui_.px(1));
  }
}

void SphereDrawing::facets(std::span<const SphereFacet> facets, Half half, ImU32 color,
                           float strength) const {
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
  for (const SphereFacet& facet : facets) {
    if (!on(facet.corner[0] + facet.corner[1] + facet.corner[2], half)) continue;
    // One layer shows the grid through; folds of the surface lie several times over one place.
    const float cover = 1 - std::pow(1 - strength, std::max(facet.layers, 0.6f));
    const ImU32 shade = faded(color, cover);
    list_.PrimReserve(3 * (facet.corners - 2), facet.corners);
    const auto base = static_cast<unsigned>(list_._VtxCurrentIdx);
    for (int i = 0; i < facet.corners; ++i) {
      list_.PrimWriteVtx(place(facet.corner[static_cast<std::size_t>(i)]), white, shade);
    }
    for (unsigned i = 2; i < static_cast<unsigned>(facet.corners); ++i) {
      list_.PrimWriteIdx(static_cast<ImDrawIdx>(base));
      list_.PrimWriteIdx(static_cast<ImDrawIdx>(base + i - 1));
      list_.PrimWriteIdx(static_cast<ImDrawIdx>(base + i));
    }
  }
}

void SphereDrawing::arcs(std::span<const SphereArc> arcs, Half half, ImU32 color) const {
  std::vector<glm::vec3> points;
  for (const SphereArc& arc : arcs) {
    points.clear();
    appendArc(arc.from, arc.to, points);
    polyline(points, half, arc.inside ? color : faded(color, 0.28f), ui_.px(arc.inside ? 1.4f : 1));
  }
}

void SphereDrawing::outline(std::span<const glm::vec3> corners, Half half, ImU32 color) const {
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    appendArc(corners[i], corners[(i + 1) % corners.size()], points);
  }
  polyline(points, half, color, ui_.px(1.6f));
}

void SphereDrawing::point(const glm::vec3& n, Half half, ImU32 color, float radius) const {
  if (on(n, half)) list_.AddCircleFilled(place(n), radius, color, 12);
}

void SphereDrawing::dot(const glm::vec3& n, Half half, ImU32 color, float size) const {
  if (!on(n, half)) return;
  const ImVec2 p = place(n);
  list_.PrimReserve(6, 4);
  list_.PrimRect({p.x - size / 2, p.y - size / 2}, {p.x + size / 2, p.y + size / 2}, color);
}

void SphereDrawing::axes() const {
  const std::array<const char*, 3> names = {"x", "y", "z"};
  ImGui::PushFont(ui_.theme.small);
  for (int i = 0; i < 3; ++i) {
    glm::vec3 n(0);
    n[i] = 1;
    if (!on(n, Half::Front)) continue;
    const ImVec2 p = place(1.09f * n);
    const char* name = names[static_cast<std::size_t>(i)];
    const ImVec2 size = ImGui::CalcTextSize(name);
    list_.AddCircleFilled(place(n), ui_.px(1.8f), ui_.theme.palette.dim);
    list_.AddText({p.x - size.x / 2, p.y - size.y / 2}, ui_.theme.palette.dim, name);
  }
  ImGui::PopFont();
}

}  // namespace chartflood
