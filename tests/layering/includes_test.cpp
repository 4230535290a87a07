// The dependency rule, read off the #include lines: every installed header can be included anywhere
// on Debian, so the compiler alone does not hold it.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "tests/layering/source_tree.h"

namespace chartflood {
namespace {

using Names = std::vector<std::string>;

struct Room {
  std::string folder;
  Names mayUse;   ///< folders of the project
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

std::vector<Room> rooms() {
  const Names outside = together({kGl, kWindow, kCommandLine, kImport});
  const Names noWindow = together({kWindow, kCommandLine, kImport});
  const Names methods{"core/base",    "core/model",  "core/io",    "core/gauss", "core/flood",
                      "core/segment", "core/charts", "core/param", "core/pack"};
  std::vector<Room> all{
      {"core/base", {"core/base"}, outside},
      {"core/model", {"core/base", "core/model"}, outside},
      {"core/session", {"core"}, outside},
      {"render", {"core/base", "core/model", "render"}, noWindow},
      {"app/host", {"core", "render", "app/host"}, outside},
      {"app/gui", {"core", "render", "app/host", "app/gui"}, together({kCommandLine, kImport})},
      {"app/cli", {"core", "render", "app/host", "app/cli"}, together({kGl, kWindow, kImport})},
      // A program of its own: what the import library does to it, it does to nothing else.
      {"app/import", {"core", "app/import"}, together({kGl, kWindow, kCommandLine})},
      {"app/main.cpp", {"core", "app"}, outside},
  };
  for (const char* folder : {"io", "gauss", "flood", "segment", "charts", "param", "pack"}) {
    all.push_back({std::string("core/") + folder, methods, outside});
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
    Names allowed;
    for (const std::string& folder : room.mayUse) allowed.push_back(folder + "/");
    EXPECT_TRUE(startsWithAny(include.name, allowed)) << file.path << ": " << include.name;
  }
}

TEST(Includes, FollowTheDependencyRule) {
  std::size_t checked = 0;
  for (const Room& room : rooms()) {
    for (const SourceFile& file : sourceFiles(room.folder)) {
      checkFile(file, room);
      checked += includesOf(file).size();
    }
  }
  EXPECT_GT(checked, 200u) << "the scan reads no include lines";
}

TEST(Includes, EveryFolderWithSourcesHasARule) {
  const std::vector<Room> all = rooms();
  for (const char* top : {"core", "render", "app"}) {
    for (const SourceFile& file : sourceFiles(top)) {
      if (!file.path.ends_with(".cpp") && !file.path.ends_with(".h")) continue;
      EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Room& room) {
        return file.path == room.folder || file.path.starts_with(room.folder + "/");
      })) << file.path;
    }
  }
}

/// Headers that take seconds to compile stay in few source files.
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
