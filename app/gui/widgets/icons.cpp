#include "app/gui/widgets/icons.h"

#include <array>
#include <cmath>
#include <numbers>

namespace chartflood {

namespace {

/// Draws in a square from -1 to 1 around a centre.
class Pen {
 public:
  Pen(ImDrawList& list, ImVec2 center, float size, ImU32 color)
      : list_(list), center_(center), half_(size / 2), color_(color) {}

  void triangle(float tipX, float baseX, float halfHeight) {
    list_.AddTriangleFilled(at(baseX, -halfHeight), at(baseX, halfHeight), at(tipX, 0), color_);
  }
  void box(float x0, float y0, float x1, float y1, float rounding = 0) {
    list_.AddRectFilled(at(x0, y0), at(x1, y1), color_, rounding * half_);
  }
  void frame(float x0, float y0, float x1, float y1, float rounding = 0) {
    list_.AddRect(at(x0, y0), at(x1, y1), color_, rounding * half_, 0, stroke());
  }
  void line(float x0, float y0, float x1, float y1) {
    list_.AddLine(at(x0, y0), at(x1, y1), color_, stroke());
  }
  void circle(float x, float y, float radius) {
    list_.AddCircle(at(x, y), radius * half_, color_, 0, stroke());
  }
  void dot(float x, float y, float radius) {
    list_.AddCircleFilled(at(x, y), radius * half_, color_);
  }
  /// Part of a circle from angle a to b (radians, clockwise from the right).
  void arc(float radius, float a, float b) {
    list_.PathArcTo(center_, radius * half_, a, b);
    list_.PathStroke(color_, 0, stroke());
  }
  void arrowHead(float x, float y, float angle, float size) {
    const auto corner = [&](float turn) {
      return at(x + size * std::cos(angle + turn), y + size * std::sin(angle + turn));
    };
    list_.AddTriangleFilled(corner(0), corner(2.3f), corner(-2.3f), color_);
  }

 private:
  ImVec2 at(float x, float y) const { return {center_.x + x * half_, center_.y + y * half_}; }
  float stroke() const { return std::fmax(1.2f, half_ * 0.2f); }

  ImDrawList& list_;
  ImVec2 center_;
  float half_;
  ImU32 color_;
};

void drawRound(Pen& pen) {  // an open circle with an arrow: once more around
  constexpr float kPi = std::numbers::pi_v<float>;
  pen.arc(0.72f, -0.35f * kPi, 1.25f * kPi);
  pen.arrowHead(0.42f, -0.62f, -0.75f * kPi + kPi, 0.42f);
}

void drawCamera(Pen& pen) {
  pen.frame(-0.9f, -0.5f, 0.9f, 0.7f, 0.2f);
  pen.box(-0.35f, -0.75f, 0.35f, -0.5f);
  pen.circle(0, 0.1f, 0.34f);
}

void drawDice(Pen& pen) {
  pen.frame(-0.75f, -0.75f, 0.75f, 0.75f, 0.3f);
  for (const auto& [x, y] : {std::array{-0.35f, -0.35f}, {0.35f, 0.35f}, {0.0f, 0.0f}}) {
    pen.dot(x, y, 0.15f);
  }
}

}  // namespace

void drawIcon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 color) {
  constexpr float kPi = std::numbers::pi_v<float>;
  Pen pen(list, center, size, color);
  switch (icon) {
  case Icon::Play:
    return pen.triangle(0.8f, -0.55f, 0.8f);
  case Icon::Pause:
    pen.box(-0.6f, -0.7f, -0.15f, 0.7f);
    return pen.box(0.15f, -0.7f, 0.6f, 0.7f);
  case Icon::StepForward:
    pen.box(-0.75f, -0.6f, -0.5f, 0.6f);
    return pen.triangle(0.75f, -0.3f, 0.6f);
  case Icon::StepBack:
    pen.box(0.5f, -0.6f, 0.75f, 0.6f);
    return pen.triangle(-0.75f, 0.3f, 0.6f);
  case Icon::StepChart:
    pen.circle(-0.45f, 0, 0.3f);
    return pen.triangle(0.75f, -0.05f, 0.55f);
  case Icon::StepMany:
    pen.box(-0.8f, -0.6f, -0.6f, 0.6f);
    pen.triangle(0.1f, -0.5f, 0.6f);
    return pen.triangle(0.8f, 0.15f, 0.6f);
  case Icon::ToStart:
    pen.box(-0.75f, -0.6f, -0.5f, 0.6f);
    return pen.triangle(-0.4f, 0.7f, 0.6f);
  case Icon::ToEnd:
    pen.box(0.5f, -0.6f, 0.75f, 0.6f);
    return pen.triangle(0.4f, -0.7f, 0.6f);
  case Icon::NextRound:
    return drawRound(pen);
  case Icon::RunToEnd:
    pen.triangle(0.0f, -0.8f, 0.6f);
    pen.triangle(0.6f, -0.15f, 0.6f);
    return pen.box(0.6f, -0.6f, 0.8f, 0.6f);
  case Icon::Stop:
    return pen.box(-0.6f, -0.6f, 0.6f, 0.6f);
  case Icon::Camera:
    return drawCamera(pen);
  case Icon::Reset:
    pen.arc(0.6f, -0.8f * kPi, 0.75f * kPi);
    return pen.arrowHead(-0.5f, -0.42f, -1.75f * kPi, 0.4f);
  case Icon::Dice:
    return drawDice(pen);
  case Icon::Close:
    pen.line(-0.5f, -0.5f, 0.5f, 0.5f);
    return pen.line(-0.5f, 0.5f, 0.5f, -0.5f);
  case Icon::Folder:
    pen.box(-0.8f, -0.6f, -0.1f, -0.2f, 0.1f);
    return pen.box(-0.8f, -0.4f, 0.8f, 0.65f, 0.15f);
  case Icon::File:
    return pen.frame(-0.55f, -0.75f, 0.55f, 0.75f, 0.1f);
  case Icon::Up:
    pen.line(0, -0.6f, 0, 0.7f);
    pen.line(0, -0.6f, -0.5f, -0.05f);
    return pen.line(0, -0.6f, 0.5f, -0.05f);
  }
}

}  // namespace chartflood
