// The dependency rule, read off the #include lines: every installed header can be included anywhere
// on Debian, so the compiler alone does not hold it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/layering/floors.h"
#include "tests/layering/source_tree.h"

namespace chartflood {
namespace {

using Names = std::vector<std::string>;

struct Room {
  std::string folder;
  Names mayUse;   ///< rooms that its files may include, beside itself
  Names mustNot;  ///< beginnings of headers of others
};

/// The rooms of the house, each with what lies below it and what its part may use of others.
std::vector<Room> rooms() {
  std::vector<Room> all;
  for (const HousePart& part : house()) {
    Names below = borrowedBy(part);
    for (const Floor& floor : part.floors) {
      for (const RoomInfo& room : floor) all.push_back({room.folder, below, part.forbidden});
      for (const RoomInfo& room : floor) below.push_back(room.folder);
    }
  }
  return all;
}

bool startsWithAny(const std::string& name, const Names& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& beginning) { return name.starts_with(beginning); });
}

/// A header of the project, not one that the build generates beside the object files.
bool isOurs(const Include& include) {
  return include.quoted && startsWithAny(include.name, {"core/", "render/", "app/", "tests/"});
}

void checkFile(const SourceFile& file, const Room& room) {
  for (const Include& include : includesOf(file)) {
    EXPECT_FALSE(startsWithAny(include.name, room.mustNot)) << file.path << ": " << include.name;
    if (!isOurs(include)) continue;
    const std::string folder = folderOf(include.name);
    EXPECT_TRUE(folder == room.folder ||
                std::find(room.mayUse.begin(), room.mayUse.end(), folder) != room.mayUse.end())
        << file.path << ": " << include.name;
  }
}

TEST(Includes, FollowTheDependencyRule) {
  const std::vector<Room> all = rooms();
  std::size_t checked = 0;
  for (const char* top : {"core", "render", "app"}) {
    for (const SourceFile& file : sourceFiles(top)) {
      if (!isSource(file.path)) continue;
      const auto room = std::find_if(all.begin(), all.end(), [&](const Room& candidate) {
        return candidate.folder == folderOf(file.path);
      });
      ASSERT_NE(room, all.end()) << file.path << " stands in a folder without a rule";
      checkFile(file, *room);
      checked += includesOf(file).size();
    }
  }
  EXPECT_GT(checked, 200u) << "the scan reads no include lines";
}

TEST(Includes, EveryRoomThatIsNamedIsThere) {
  for (const Room& room : rooms()) {
    EXPECT_TRUE(std::filesystem::is_directory(sourceRoot() / room.folder)) << room.folder;
  }
}

TEST(Includes, HeavyHeadersStayInSourceFiles) {
  std::size_t commandLine = 0, json = 0;
  for (const char* top : {"core", "render", "app"}) {
    for (const SourceFile& file : sourceFiles(top)) {
      for (const Include& include : includesOf(file)) {
        const bool heavy =
            startsWithAny(include.name, {"OpenMesh/", "CLI/", "assimp/", "draco/", "Eigen/"}) ||
            include.name == "nlohmann/json.hpp";
        EXPECT_FALSE(heavy && file.path.ends_with(".h")) << file.path << ": " << include.name;
        commandLine += include.name.starts_with("CLI/") ? 1 : 0;
        json += include.name == "nlohmann/json.hpp" ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(commandLine, 1u);
  EXPECT_GE(json, 1u);
  EXPECT_LE(json, 5u);
}

TEST(Includes, HeadersAreGuarded) {
  for (const char* top : {"core", "render", "app", "tests"}) {
    for (const SourceFile& file : sourceFiles(top)) {
      if (!file.path.ends_with(".h")) continue;
      EXPECT_TRUE(file.text.starts_with("#pragma once\n")) << file.path;
    }
  }
}

}  // namespace
}  // namespace chartflood
