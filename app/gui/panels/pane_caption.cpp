#include "app/gui/panels/pane_caption.h"

#include <algorithm>

#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

constexpr float kPad = 8, kAbove = 5, kBelow = 6, kButton = 56, kHead = 24, kBetween = 1;
constexpr float kBadgePad = 5, kGap = 8;

float textWidth(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> found;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    if (to > from) found.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return found;
}

/// The letter on a plate, so that it is found at once.
void badge(const Ui& ui, const std::string& name) {
  const ImVec2 text = ImGui::CalcTextSize(name.c_str());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float pad = ui.px(kBadgePad);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + text.x + 2 * pad, at.y + text.y}, ui.theme.palette.accentSoft,
                     ui.px(3));
  list.AddText({at.x + pad, at.y}, ui.theme.palette.text, name.c_str());
  ImGui::Dummy({text.x + 2 * pad, text.y});
}

float rowHeight(const Ui& ui) { return ui.theme.small->FontSize + ui.px(kBetween); }

/// Every row that is left, one below the other.
std::string wholeText(const CaptionLayout& caption) {
  std::string text;
  for (const CaptionLayout::Row& row : caption.rows) text += (text.empty() ? "" : "\n") + row.text;
  return text;
}

}  // namespace

std::vector<std::string> flowedRows(std::span<const std::string> pieces, float width,
                                    const std::function<float(const std::string&)>& measure) {
  std::vector<std::string> rows;
  bool open = false;  // the last row can take more
  const auto add = [&](const std::string& text, const char* gap) {
    if (open) {
      std::string longer = rows.back() + gap + text;
      if (measure(longer) <= width) {
        rows.back() = std::move(longer);
        return;
      }
    }
    rows.push_back(text);
    open = true;
  };
  for (const std::string& piece : pieces) {
    if (measure(piece) <= width) {
      add(piece, "   ");
      continue;
    }
    open = false;
    for (const std::string& word : words(piece)) add(word, " ");
    open = false;  // what follows is another figure
  }
  return rows;
}

CaptionLayout layOutCaption(const Ui& ui, ComparePane pane, float width) {
  CaptionLayout caption;
  caption.words = paneCaption(ui.state, pane);
  caption.name = paneName(ui.state.compare, pane);
  const float room = width - 2 * ui.px(kPad);
  const float plate = textWidth(caption.name) + 2 * ui.px(kBadgePad) + ui.px(kGap);
  const float button = pane.live() ? 0 : ui.px(kButton) + ui.px(kGap);
  ImGui::PushFont(ui.theme.strong);
  const float method = textWidth(caption.words.method);
  ImGui::PopFont();
  caption.methodBelow = plate + method > room;
  caption.buttonBelow =
      button > 0 && (caption.methodBelow ? plate : plate + method) + button > room;

  ImGui::PushFont(ui.theme.small);
  const auto addRows = [&](std::span<const std::string> pieces, bool dim) {
    for (std::string& text : flowedRows(pieces, room, textWidth)) {
      caption.rows.push_back({std::move(text), dim});
    }
  };
  addRows(caption.words.figures, false);
  addRows(caption.words.problems, false);
  addRows(caption.words.differing, true);
  ImGui::PopFont();
  caption.height = ui.px(kAbove) + ui.px(kHead) + ui.px(kBelow) +
                   rowHeight(ui) * static_cast<float>(caption.rows.size());
  if (caption.methodBelow) caption.height += ui.theme.strong->FontSize + ui.px(kBetween);
  if (caption.buttonBelow) caption.height += ui.px(kHead + 2);
  return caption;
}

void paneCaption(const Ui& ui, ComparePane pane, const CaptionLayout& caption, ImVec2 low,
                 ImVec2 high) {
  const float pad = ui.px(kPad), room = high.x - low.x - 2 * pad;
  const std::string label = "caption/" + caption.name;
  ImGui::GetWindowDrawList()->AddRectFilled(low, high, ui.theme.palette.panel);
  ui.probe.rectangle(label, low, high);
  const float middle = (ui.px(kHead) - ImGui::GetFontSize()) / 2;
  ImGui::SetCursorScreenPos({low.x + pad, low.y + ui.px(kAbove) + middle});
  badge(ui, caption.name);
  float y = low.y + ui.px(kAbove) + ui.px(kHead);
  ImVec2 at{low.x + pad + textWidth(caption.name) + 2 * ui.px(kBadgePad) + ui.px(kGap),
            low.y + ui.px(kAbove) + middle};
  if (caption.methodBelow) {
    at = {low.x + pad, y};
    y += ui.theme.strong->FontSize + ui.px(kBetween);
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::PushFont(ui.theme.strong);
  fittedText(ui, caption.words.method, high.x - pad - at.x, ui.theme.palette.text);
  ui.probe.item(label + "/method");
  ImGui::PopFont();

  ImGui::PushFont(ui.theme.small);
  const float least = y, most = high.y - (caption.buttonBelow ? ui.px(kHead + 2) : 0);
  for (std::size_t i = 0; i < caption.rows.size(); ++i) {
    if (y + rowHeight(ui) > most) break;
    ImGui::SetCursorScreenPos({low.x + pad, y});
    fittedText(ui, caption.rows[i].text, room,
               caption.rows[i].dim ? ui.theme.palette.dim : ui.theme.palette.text);
    ui.probe.item(label + "/" + std::to_string(i));
    y += rowHeight(ui);
  }
  ImGui::PopFont();
  const float needed = least + rowHeight(ui) * static_cast<float>(caption.rows.size());
  if (needed > most) {
    ImGui::SetCursorScreenPos({low.x + pad, least});
    ImGui::Dummy({room, std::max(1.0f, most - least)});
    tooltip(ui, label, caption.words.method, wholeText(caption));
  }
  if (pane.live()) return;
  const float top = caption.buttonBelow ? high.y - ui.px(kHead + 4) : low.y + ui.px(kAbove);
  const float left = caption.buttonBelow ? low.x + pad : high.x - pad - ui.px(kButton);
  ImGui::SetCursorScreenPos({left, top});
  textButton(ui, ("Use " + caption.name).c_str(), "use " + caption.name,
             {ui.px(kButton), ui.px(kHead)});
}

}  // namespace chartflood
