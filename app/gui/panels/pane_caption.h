#pragma once
/// What stands under a half of a comparison: its letter and method, then its figures in as many
/// rows as they need.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/gui/widgets/ui.h"
#include "app/host/state/compare_look.h"

namespace chartflood {

/// Pieces of text in rows no wider than `width`, as `measure` has it: a piece stays whole where a
/// row has room for it and is broken between words else. A word is never broken.
std::vector<std::string> flowedRows(std::span<const std::string> pieces, float width,
                                    const std::function<float(const std::string&)>& measure);

/// A caption laid out for a width.
struct CaptionLayout {
  struct Row {
    std::string text;
    bool dim = false;  ///< less important
  };
  PaneCaption words;
  std::string name;  ///< of the half
  std::vector<Row> rows;
  bool methodBelow = false;  ///< the method has no room beside the letter
  bool buttonBelow = false;  ///< the button has no room beside the method
  float height = 0;          ///< pixels
};
/// For a caption so many pixels wide.
CaptionLayout layOutCaption(const Ui& ui, ComparePane pane, float width);

/// Draws it between two corners. Rows that have no room are left out and said by a tooltip.
void paneCaption(const Ui& ui, ComparePane pane, const CaptionLayout& caption, ImVec2 low,
                 ImVec2 high);

}  // namespace chartflood
