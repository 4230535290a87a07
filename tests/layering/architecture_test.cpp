// The architecture page against the sources: the drawing of the floors, the table of rooms, and the
// recipes. Set CHARTFLOOD_WRITE_README=1 to write the drawing and the table anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/layering/floors.h"
#include "tests/layering/source_tree.h"

namespace chartflood {
namespace {

using Arrows = std::map<std::string, std::set<std::string>>;

const char* const kPage = "assets/docs/architecture.md";
const char* const kDrawing = "assets/docs/pictures/architecture.svg";

std::string textOf(const std::string& path) {
  std::ifstream stream(sourceRoot() / path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

bool writesAnew() { return std::getenv("CHARTFLOOD_WRITE_README") != nullptr; }

/// From each room to those whose headers it includes.
Arrows arrowsOfIncludes() {
  Arrows arrows;
  for (const char* top : {"core", "render", "app"}) {
    for (const SourceFile& file : sourceFiles(top)) {
      if (!isSource(file.path)) continue;
      const std::string from = folderOf(file.path);
      for (const Include& include : includesOf(file)) {
        const bool ours = include.name.starts_with("core/") || include.name.starts_with("app/") ||
                          include.name.starts_with("render/");
        if (!include.quoted || !ours || folderOf(include.name) == from) continue;
        arrows[from].insert(folderOf(include.name));
      }
    }
  }
  return arrows;
}

/// Everything below a room, over any number of arrows.
void collectBelow(const Arrows& arrows, const std::string& room, std::set<std::string>& below) {
  const auto found = arrows.find(room);
  if (found == arrows.end()) return;
  for (const std::string& next : found->second) {
    if (below.insert(next).second) collectBelow(arrows, next, below);
  }
}

/// Only the arrows that no way over another room replaces.
Arrows withoutDetours(const Arrows& arrows) {
  Arrows fewer;
  for (const auto& [from, targets] : arrows) {
    std::set<std::string> over;
    for (const std::string& next : targets) collectBelow(arrows, next, over);
    for (const std::string& to : targets) {
      if (!over.contains(to)) fewer[from].insert(to);
    }
  }
  return fewer;
}

/// Rooms of one frame of the drawing, floor on floor from the lowest up; each stands for itself and
/// the folders inside it, or for itself alone.
struct PlanFrame {
  std::string title;
  std::vector<std::vector<std::string>> floors;
  bool foldersInside = false;
};

/// "core/segment" of "core/segment/parts".
std::string familyOf(const std::string& folder) {
  const std::size_t first = folder.find('/');
  const std::size_t second = first == std::string::npos ? first : folder.find('/', first + 1);
  return folder.substr(0, second);
}

/// core with one box for each of its rooms, then a frame for every room of core that has rooms
/// inside, then the other parts.
std::vector<PlanFrame> planFrames() {
  std::vector<PlanFrame> frames;
  for (const HousePart& part : house()) {
    if (part.name != "core") {
      PlanFrame frame{part.name, {}, false};
      for (const Floor& floor : part.floors) {
        frame.floors.emplace_back();
        for (const RoomInfo& room : floor) frame.floors.back().push_back(room.folder);
      }
      frames.push_back(frame);
      continue;
    }
    PlanFrame core{"core", {}, true};
    std::map<std::string, PlanFrame> families;
    // A room with rooms inside stands where the highest of them does.
    std::set<std::string> placed;
    for (auto floor = part.floors.rbegin(); floor != part.floors.rend(); ++floor) {
      std::vector<std::string> row;
      std::map<std::string, std::vector<std::string>> inner;
      for (const RoomInfo& room : *floor) {
        const std::string family = familyOf(room.folder);
        if (placed.insert(family).second) row.push_back(family);
        inner[family].push_back(room.folder);
      }
      if (!row.empty()) core.floors.insert(core.floors.begin(), row);
      for (const auto& [family, rooms] : inner) {
        auto& frame = families.try_emplace(family, PlanFrame{family, {}, false}).first->second;
        frame.floors.insert(frame.floors.begin(), rooms);
      }
    }
    frames.push_back(core);
    for (const auto& [family, frame] : families) {
      if (frame.floors.size() > 1) frames.push_back(frame);
    }
  }
  return frames;
}

/// The drawing: frames side by side, floors one on the other, arrows down to what is included.
class FloorPlan {
 public:
  std::string svg() {
    place();
    std::ostringstream out;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width_ << "\" height=\""
        << height_ << "\" viewBox=\"0 0 " << width_ << ' ' << height_
        << "\" font-family=\"Inter, Helvetica, sans-serif\" font-size=\"13\">\n"
        << "<defs><marker id=\"tip\" markerWidth=\"8\" markerHeight=\"8\" refX=\"7\" refY=\"4\" "
           "orient=\"auto\"><path d=\"M0,0 L8,4 L0,8 z\" fill=\"#5a6472\"/></marker></defs>\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
        << drawing_ << "</svg>\n";
    return out.str();
  }

 private:
  using Places = std::map<std::string, std::pair<int, int>>;  ///< left top of boxes
  static constexpr int kWide = 96, kHigh = 28, kGapX = 12, kGapY = 30, kEdge = 16, kTitle = 26;
  static constexpr int kMargin = 12;

  static int widthOf(const PlanFrame& frame) {
    std::size_t most = 1;
    for (const auto& floor : frame.floors) most = std::max(most, floor.size());
    return static_cast<int>(most) * (kWide + kGapX) - kGapX + 2 * kEdge;
  }
  static int heightOf(const PlanFrame& frame) {
    return kTitle + 2 * kEdge + static_cast<int>(frame.floors.size()) * (kHigh + kGapY) - kGapY;
  }

  void place() {
    const std::vector<PlanFrame> frames = planFrames();
    const std::vector<std::vector<std::string>> columns{
        {"core"}, {"core/segment"},      {"core/session", "core/io"}, {"import", "render"},
        {"host"}, {"main", "cli", "gui"}};
    std::size_t drawn = 0;
    int x = kMargin;
    for (const auto& column : columns) {
      int widest = 0, y = kMargin;
      for (const std::string& name : column) {
        const auto frame = std::find_if(frames.begin(), frames.end(),
                                        [&](const PlanFrame& f) { return f.title == name; });
        ASSERT_NE(frame, frames.end()) << name;
        draw(*frame, x, y);
        ++drawn;
        widest = std::max(widest, widthOf(*frame));
        y += heightOf(*frame) + kMargin;
      }
      height_ = std::max(height_, y);
      x += widest + kMargin;
    }
    width_ = x;
    EXPECT_EQ(drawn, frames.size()) << "a frame has no column";
  }

  void draw(const PlanFrame& frame, int x, int y) {
    std::ostringstream out;
    out << "<rect x=\"" << x << "\" y=\"" << y << "\" width=\"" << widthOf(frame) << "\" height=\""
        << heightOf(frame) << "\" rx=\"8\" fill=\"#f3f5f8\" stroke=\"#c8ced8\"/>\n<text x=\""
        << x + kEdge << "\" y=\"" << y + kEdge + 8 << "\" font-weight=\"600\" fill=\"#1c2430\">"
        << frame.title << "</text>\n";
    Places places;
    std::ostringstream boxes;
    const int count = static_cast<int>(frame.floors.size());
    for (int f = 0; f < count; ++f) {
      const auto& floor = frame.floors[static_cast<std::size_t>(f)];
      const int row = static_cast<int>(floor.size()) * (kWide + kGapX) - kGapX;
      int left = x + (widthOf(frame) - row) / 2;
      for (const std::string& room : floor) {
        const int top = y + kTitle + kEdge + (count - 1 - f) * (kHigh + kGapY);
        places[room] = {left, top};
        addBox(room, left, top, boxes);
        left += kWide + kGapX;
      }
    }
    addArrows(frame, places, out);
    drawing_ += out.str() + boxes.str();
  }

  static void addBox(const std::string& room, int left, int top, std::ostringstream& out) {
    out << "<rect x=\"" << left << "\" y=\"" << top << "\" width=\"" << kWide << "\" height=\""
        << kHigh << "\" rx=\"5\" fill=\"#ffffff\" stroke=\"#5a6472\"/><text x=\""
        << left + kWide / 2 << "\" y=\"" << top + kHigh / 2 + 5
        << "\" text-anchor=\"middle\" fill=\"#1c2430\">" << room.substr(room.rfind('/') + 1)
        << "</text>\n";
  }

  static void addArrows(const PlanFrame& frame, const Places& places, std::ostringstream& out) {
    const auto boxOf = [&](const std::string& folder) {
      return frame.foldersInside ? familyOf(folder) : folder;
    };
    Arrows inside;
    for (const auto& [from, targets] : arrowsOfIncludes()) {
      for (const std::string& to : targets) {
        const std::string a = boxOf(from), b = boxOf(to);
        if (a != b && places.contains(a) && places.contains(b)) inside[a].insert(b);
      }
    }
    for (const auto& [from, targets] : withoutDetours(inside)) {
      for (const std::string& to : targets) {
        const auto [x1, y1] = places.at(from);
        const auto [x2, y2] = places.at(to);
        out << "<path d=\"M" << x1 + kWide / 2 << ',' << y1 + kHigh << " C" << x1 + kWide / 2 << ','
            << y1 + kHigh + 18 << ' ' << x2 + kWide / 2 << ',' << y2 - 18 << ' ' << x2 + kWide / 2
            << ',' << y2
            << "\" fill=\"none\" stroke=\"#5a6472\" stroke-width=\"1.2\" "
               "marker-end=\"url(#tip)\"/>\n";
      }
    }
  }

  std::string drawing_;
  int width_ = 0, height_ = 0;
};

TEST(ArchitecturePage, DrawsTheFloorsAsTheIncludesAre) {
  const std::string made = FloorPlan().svg();
  if (writesAnew()) {
    std::ofstream(sourceRoot() / kDrawing, std::ios::binary) << made;
    GTEST_SKIP() << kDrawing << " was written";
  }
  EXPECT_EQ(textOf(kDrawing), made) << "CHARTFLOOD_WRITE_README=1 makes it anew";
}

std::string roomTable() {
  const Arrows arrows = arrowsOfIncludes();
  std::string text = "| room | holds | includes |\n|---|---|---|\n";
  for (const HousePart& part : house()) {
    for (const Floor& floor : part.floors) {
      for (const RoomInfo& room : floor) {
        std::string uses;
        if (const auto found = arrows.find(room.folder); found != arrows.end()) {
          for (const std::string& to : found->second) uses += (uses.empty() ? "" : ", ") + to;
        }
        text += "| `" + room.folder + "` | " + room.holds + " | " + uses + " |\n";
      }
    }
  }
  return text;
}

TEST(ArchitecturePage, TellsEachRoomAndWhatItIncludes) {
  const std::string begin = "<!-- rooms: made from the includes -->\n",
                    end = "<!-- end of rooms -->";
  std::string text = textOf(kPage);
  const std::size_t from = text.find(begin), to = text.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::size_t start = from + begin.size();
  const std::string made = "\n" + roomTable() + "\n";
  if (writesAnew()) {
    text.replace(start, to - start, made);
    std::ofstream(sourceRoot() / kPage, std::ios::binary) << text;
    GTEST_SKIP() << kPage << " was written";
  }
  EXPECT_EQ(text.substr(start, to - start), made) << "CHARTFLOOD_WRITE_README=1 makes it anew";
}

struct Recipe {
  std::string title, example;
  std::set<std::string> files;
};

/// The sections "### ..." below "## Recipes": their example and the files that they name.
std::vector<Recipe> recipesOf(const std::string& page) {
  std::vector<Recipe> recipes;
  std::istringstream lines(page.substr(std::min(page.find("## Recipes"), page.size())));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && !line.starts_with("## ")) {
    if (line.starts_with("### ")) recipes.push_back({line.substr(4), "", {}});
    if (recipes.empty()) continue;
    for (std::size_t open = line.find('`'); open != std::string::npos;) {
      const std::size_t close = line.find('`', open + 1);
      if (close == std::string::npos) break;
      const std::string word = line.substr(open + 1, close - open - 1);
      if (line.starts_with("Follow ")) {
        recipes.back().example = word;
      } else {
        recipes.back().files.insert(word);
      }
      open = line.find('`', close + 1);
    }
  }
  return recipes;
}

/// Whoever follows a recipe meets every file that knows of its example.
TEST(ArchitecturePage, RecipesNameEveryFileOfTheirExample) {
  const std::vector<Recipe> recipes = recipesOf(textOf(kPage));
  ASSERT_EQ(recipes.size(), 5u);
  for (const Recipe& recipe : recipes) {
    SCOPED_TRACE(recipe.title);
    ASSERT_NE(recipe.example, "");
    std::set<std::string> found;
    for (const char* top : {"core", "render", "app", "shaders"}) {
      for (const SourceFile& file : sourceFiles(top)) {
        const bool named = file.path.find(recipe.example) != std::string::npos;
        if (named || file.text.find(recipe.example) != std::string::npos) {
          found.insert(file.path);
        }
      }
    }
    EXPECT_EQ(found, recipe.files);
  }
}

/// Files that the page names elsewhere are there, too.
TEST(ArchitecturePage, NamesOnlyWhatIsThere) {
  const std::string text = textOf(kPage);
  std::size_t found = 0;
  for (const char* top : {"`core/", "`render/", "`app/", "`tests/"}) {
    for (std::size_t at = text.find(top); at != std::string::npos; at = text.find(top, at + 1)) {
      const std::string path = text.substr(at + 1, text.find('`', at + 1) - at - 1);
      EXPECT_TRUE(std::filesystem::exists(sourceRoot() / path)) << path;
      ++found;
    }
  }
  EXPECT_GT(found, 60u);
}

}  // namespace
}  // namespace chartflood
