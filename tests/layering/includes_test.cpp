// The dependency rule, read off the #include lines: every installed header can be included anywhere
// on Debian, so the compiler alone does not hold it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/layering/source_tree.h"

namespace chartflood {
namespace {

using Names = std::vector<std::string>;

/// A folder with sources of its own; folders inside it are rooms of their own.
struct Room {
  std::string folder;
  Names mayUse;   ///< rooms that its files may include, beside itself
  Names mustNot;  ///< beginnings of headers of others
};

const Names kGl{"epoxy/", "GL/", "EGL/", "KHR/"};
const Names kWindow{"GLFW/", "imgui"};
const Names kCommandLine{"CLI/"};
const Names kImport{"assimp/"};

Names together(std::initializer_list<Names> lists) {
  Names all;
  for (const Names& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// Rooms of one floor: none of them includes another. Sub-rooms of a room are floors of their own,
/// from the lowest up to the room itself, which is its door.
using Floor = Names;

/// The floors from the lowest up: a room may include what lies on lower floors of its part.
const std::vector<Floor> kCore{{"core/base"},
                               {"core/model"},
                               {"core/gauss", "core/samples"},
                               {"core/flood"},
                               {"core/segment/parts"},
                               {"core/segment/borders"},
                               {"core/segment/rounds", "core/segment/creases"},
                               {"core/segment/fast", "core/segment/growth"},
                               {"core/segment"},
                               {"core/charts"},
                               {"core/io/text", "core/param", "core/pack"},
                               {"core/io/read", "core/io/write"},
                               {"core/io"},
                               {"core/session/settings"},
                               {"core/session/pipeline"},
                               {"core/session"},
                               {"core/session/files"}};
const std::vector<Floor> kRender{{"render/gl"}, {"render/text", "render/scene"}, {"render/passes"}};
const std::vector<Floor> kHost{{"app/host/script", "app/host/settings", "app/host/insight"},
                               {"app/host/film", "app/host/files"},
                               {"app/host/state"},
                               {"app/host/actions"}};
const std::vector<Floor> kGui{
    {"app/gui/widgets"}, {"app/gui/views"}, {"app/gui/panels"}, {"app/gui/tools"}, {"app/gui"}};

Names allOf(const std::vector<Floor>& floors) {
  Names all;
  for (const Floor& floor : floors) all.insert(all.end(), floor.begin(), floor.end());
  return all;
}

/// Adds the rooms of a part, each with what lies below it and what the part may use of others.
void addFloors(std::vector<Room>& rooms, const std::vector<Floor>& floors, const Names& others,
               const Names& mustNot) {
  Names below = others;
  for (const Floor& floor : floors) {
    for (const std::string& folder : floor) rooms.push_back({folder, below, mustNot});
    below.insert(below.end(), floor.begin(), floor.end());
  }
}

std::vector<Room> rooms() {
  const Names outside = together({kGl, kWindow, kCommandLine, kImport});
  const Names core = allOf(kCore), render = allOf(kRender), host = allOf(kHost);
  std::vector<Room> all;
  addFloors(all, kCore, {}, outside);
  addFloors(all, kRender, {"core/base", "core/model"}, together({kWindow, kCommandLine, kImport}));
  addFloors(all, kHost, together({core, render}), outside);
  addFloors(all, kGui, together({core, render, host}), together({kCommandLine, kImport}));
  all.push_back({"app/cli", together({core, render, host}), together({kGl, kWindow, kImport})});
  // A program of its own: what the import library does to it, it does to nothing else.
  all.push_back({"app/import", core, together({kGl, kWindow, kCommandLine})});
  all.push_back({"app", together({core, {"app/cli", "app/gui"}}), outside});
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

std::string folderOf(const std::string& path) { return path.substr(0, path.rfind('/')); }

bool isSource(const std::string& path) { return path.ends_with(".cpp") || path.ends_with(".h"); }

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
