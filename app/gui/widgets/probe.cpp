#include "app/gui/widgets/probe.h"

#include <cmath>

#include <imgui_internal.h>

namespace chartflood {

bool ProbedItem::whole() const {
  constexpr float kRounding = 1.0f;
  return min.x >= clipMin.x - kRounding && min.y >= clipMin.y - kRounding &&
         max.x <= clipMax.x + kRounding && max.y <= clipMax.y + kRounding;
}

void Probe::item(std::string_view label) {
  rectangle(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

void Probe::rectangle(std::string_view label, ImVec2 min, ImVec2 max) {
  const ImRect clip = ImGui::GetCurrentWindow()->ClipRect;
  ProbedItem item;
  item.min = min;
  item.max = max;
  item.clipMin = clip.Min;
  item.clipMax = clip.Max;
  item.visible = clip.Overlaps(ImRect(min, max));
  item.scrolls = ImGui::GetCurrentWindow()->ScrollMax.y > 0;
  items_.insert_or_assign(std::string(label), item);
}

const ProbedItem* Probe::find(std::string_view label) const {
  const auto found = items_.find(label);
  return found == items_.end() ? nullptr : &found->second;
}

std::string Probe::json() const {
  std::string text = "{";
  for (const auto& [label, item] : items_) {
    if (!item.visible) continue;
    if (text.size() > 1) text += ',';
    text += "\n  \"";
    for (char c : label) {
      if (c == '"' || c == '\\') text += '\\';
      text += c;
    }
    text += "\": [";
    const float values[] = {item.min.x, item.min.y, item.max.x, item.max.y};
    for (int i = 0; i < 4; ++i) {
      text += (i == 0 ? "" : ", ") + std::to_string(std::lround(values[i]));
    }
    text += ']';
  }
  return text + "\n}\n";
}

}  // namespace chartflood
