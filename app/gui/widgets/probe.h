#pragma once
/// Where each widget stood in the last frame, by label, so that tests and scripts find them.

#include <map>
#include <string>
#include <string_view>

#include <imgui.h>

namespace chartflood {

/// One widget as drawn, in window coordinates.
struct ProbedItem {
  ImVec2 min{0, 0}, max{0, 0};          ///< the widget
  ImVec2 clipMin{0, 0}, clipMax{0, 0};  ///< what of its panel can be seen
  bool visible = false;                 ///< some part of it is inside the clip
  bool scrolls = false;                 ///< its panel can be scrolled up and down

  ImVec2 center() const { return {(min.x + max.x) / 2, (min.y + max.y) / 2}; }
  /// True when nothing of it is cut off.
  bool whole() const;
};

class Probe {
 public:
  /// Forgets the last frame.
  void beginFrame() { items_.clear(); }
  /// Notes the widget just submitted to Dear ImGui.
  void item(std::string_view label);
  /// Notes any rectangle of the present window.
  void rectangle(std::string_view label, ImVec2 min, ImVec2 max);

  const std::map<std::string, ProbedItem, std::less<>>& items() const { return items_; }
  const ProbedItem* find(std::string_view label) const;
  /// {"label": [left, top, right, bottom], ..} of the visible items, whole pixels.
  std::string json() const;

 private:
  std::map<std::string, ProbedItem, std::less<>> items_;
};

}  // namespace chartflood
