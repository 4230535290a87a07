#pragma once
/// The choice of a file to read or to write: typing, filter, recent files, double click, keyboard,
/// formats.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/gui/widgets/ui.h"

namespace chartflood {

class FileBrowser {
 public:
  /// Shows the window while the state asks for it; emits `open` or the action that exports.
  void draw(const Ui& ui);

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    std::uintmax_t bytes = 0;
  };

  void begin(const Ui& ui);
  void enter(const std::filesystem::path& folder);
  void list();
  bool matches(const Entry& entry) const;
  void drawPlaces(const Ui& ui, float width);
  void drawFolder(const Ui& ui);
  void drawEntries(const Ui& ui);
  void drawName(const Ui& ui);
  void drawRecent(const Ui& ui);
  void drawFormats(const Ui& ui);
  void moveSelection();
  void activate(const Ui& ui, const Entry& entry);
  void accept(const Ui& ui);
  void save(const Ui& ui);
  void choose(const Ui& ui, const std::filesystem::path& file);
  bool saving() const { return purpose_ != PanelState::Browse::Open; }

  PanelState::Browse purpose_ = PanelState::Browse::Nothing;
  std::filesystem::path folder_;
  std::string folderText_;
  std::string name_;      ///< typed: a filter while reading, the new name while writing
  std::string selected_;  ///< entry that was clicked or reached by keys; "": none
  std::string problem_;   ///< why the folder or name cannot be used
  std::vector<Entry> entries_;
  bool focusName_ = false;
  bool showSelected_ = false;  ///< the selected entry is to be brought into view
  bool confirmed_ = false;     ///< writing over a file was asked for twice
};

}  // namespace chartflood
