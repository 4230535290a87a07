#pragma once
/// The rooms of the house in their true order: what the layering test holds and the architecture
/// page shows.

#include <string>
#include <vector>

namespace chartflood {

/// A folder with sources of its own; folders inside it are rooms of their own.
struct RoomInfo {
  std::string folder;
  std::string holds;  ///< in a few words
};

/// Rooms that do not include each other.
using Floor = std::vector<RoomInfo>;

/// A top part of the program.
struct HousePart {
  std::string name;
  std::vector<Floor> floors;           ///< from the lowest up; a room may include lower floors
  std::vector<std::string> mayUse;     ///< names of other parts, whole, or single rooms of them
  std::vector<std::string> forbidden;  ///< beginnings of headers of others
};

/// core, render, host, gui, cli, import and the program itself.
const std::vector<HousePart>& house();

/// Folders of a part's rooms.
std::vector<std::string> foldersOf(const HousePart& part);

/// Folders of others that the rooms of a part may include, beside lower floors of their own.
std::vector<std::string> borrowedBy(const HousePart& part);

}  // namespace chartflood
