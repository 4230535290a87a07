// Everything can be reached: each action by a key, a menu or the search, and with it by the
// keyboard alone; each parameter has its tooltip and its option.

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "app/host/actions/action_search.h"
#include "tests/gui/headless_frame.h"

namespace chartflood {
namespace {

/// An argument that the table takes.
std::string sample(const ArgumentInfo& argument) {
  switch (argument.type) {
  case ArgumentType::Choice:
    return argument.choices.front();
  case ArgumentType::Switch:
    return "on";
  case ArgumentType::Integer:
  case ArgumentType::Number:
    return "1";
  case ArgumentType::Text:
    break;
  }
  return "x";
}

/// The line with all that the action must be told.
std::string lineOf(const Action& action) {
  std::string line = action.id;
  for (const ArgumentInfo& argument : action.arguments) {
    if (argument.required) line += ' ' + sample(argument);
  }
  return line;
}

bool hasKey(const ActionRegistry& actions, const Action& action) {
  return std::any_of(
      actions.bindings().begin(), actions.bindings().end(),
      [&](const Binding& binding) { return parseCommand(binding.line).action == action.id; });
}

/// What was seen of the menus.
struct Menus {
  std::set<std::string> lines;            ///< entries, as script lines, and names of menus
  std::map<std::string, float> height;    ///< of each menu
  std::map<std::string, int> entryCount;  ///< of each menu, menus in it included
};

std::set<std::string> menuLabels(HeadlessFrame& ui) {
  std::set<std::string> labels;
  for (const auto& [label, item] : ui.frame().probe().items()) {
    if (label.starts_with("menu/")) labels.insert(label.substr(5));
  }
  return labels;
}

/// By a click beside them.
void closeMenus(HeadlessFrame& ui) {
  ui.moveTo({640, 560});
  ui.press();
  ui.release();
  ui.frames(3);
}

/// Opens a menu by clicks on it and those that it is in, and then all that are in it.
void walk(HeadlessFrame& ui, const std::vector<std::string>& path, Menus& menus) {
  closeMenus(ui);
  std::set<std::string> before;
  for (const std::string& each : path) {
    const std::set<std::string> now = menuLabels(ui);
    before.insert(now.begin(), now.end());
    ui.click("menu/" + each);
    ui.frames(3);
  }
  const std::string& name = path.back();
  if (!ui.has("menu-body/" + name)) return;  // it cannot be opened now
  const ProbedItem body = ui.item("menu-body/" + name);
  menus.height[name] = body.max.y - body.min.y;
  std::set<std::string> own = menuLabels(ui);
  std::erase_if(own, [&](const std::string& label) { return before.contains(label); });
  menus.entryCount[name] = static_cast<int>(own.size());
  menus.lines.insert(own.begin(), own.end());
  for (const std::string& label : own) {
    const bool isMenu = std::isupper(static_cast<unsigned char>(label.front())) != 0;
    if (!isMenu) continue;
    std::vector<std::string> deeper = path;
    deeper.push_back(label);
    walk(ui, deeper, menus);
  }
}

/// All menus of the bar and in them.
Menus allMenus(HeadlessFrame& ui) {
  Menus menus;
  for (const char* menu : {"File", "Edit", "View", "Seeds", "Run", "Compare", "Help"}) {
    walk(ui, {menu}, menus);
  }
  closeMenus(ui);
  return menus;
}

TEST(Reach, EveryMenuFitsASmallWindow) {
  HeadlessFrame ui({1024, 640});
  ui.openFlooded("sphere", 300);
  const Menus menus = allMenus(ui);
  EXPECT_GT(menus.height.size(), 20u);
  for (const auto& [name, height] : menus.height) {
    EXPECT_LE(height, 600) << name << " is higher than a window below its bar";
  }
  for (const auto& [name, entries] : menus.entryCount) {
    const bool inBar = ui.has("menu/" + name);
    if (!inBar) EXPECT_LE(entries, 14) << name;
  }
}

TEST(Reach, EveryActionByKeyMenuOrSearch) {
  HeadlessFrame ui;
  ui.openFlooded("sphere", 300);
  const std::set<std::string> menus = allMenus(ui).lines;
  EXPECT_GT(menus.size(), 60u);
  for (const Action& action : ui.actions().actions()) {
    const bool inMenu = std::any_of(menus.begin(), menus.end(), [&](const std::string& line) {
      return line.substr(0, line.find(' ')) == action.id;
    });
    const std::string line = lineOf(action);
    const std::vector<FoundAction> found = searchActions(ui.actions(), ui.state(), line);
    const bool inSearch = std::any_of(found.begin(), found.end(), [&](const FoundAction& each) {
      return parseCommand(each.line).action == action.id;
    });
    EXPECT_TRUE(hasKey(ui.actions(), action) || inMenu || inSearch) << line;
    EXPECT_FALSE(action.title.empty()) << action.id;
    EXPECT_FALSE(action.help.empty()) << action.id;
    EXPECT_TRUE(action.help.ends_with('.')) << action.id;
  }
  // The way to the search itself.
  EXPECT_FALSE(ui.actions().shortcut("find-action").empty());
}

TEST(Reach, AWholeLineCanBeTypedIntoTheSearch) {
  HeadlessFrame ui;
  ui.openFlooded("sphere", 300);
  ui.key("Ctrl+P");
  ui.frames(3);
  ui.type("checker-size 30");
  ui.frames(2);
  ui.enter();
  EXPECT_EQ(ui.state().view.render.checkerSquares, 30);
  EXPECT_FALSE(ui.state().panels.search);
}

TEST(Reach, AMenuEntryIsReachedByArrowsAndRunByEnter) {
  HeadlessFrame ui;
  ui.openFlooded("sphere", 300);
  ui.click("menu/Help");
  ui.frames(2);
  for (int i = 0; i < 12 && !ui.state().panels.about; ++i) {
    ui.arrow(ImGuiKey_UpArrow);  // round to the last entry
    ui.arrow(ImGuiKey_Space);
    ui.frames(2);
    if (!ui.has("menu/about")) break;  // one was run
  }
  EXPECT_TRUE(ui.state().panels.about || ui.state().panels.log || ui.state().panels.keys ||
              ui.state().panels.firstCard || ui.state().panels.search);
}

/// Paper parameters and the others of the interface's table have a row with a tooltip, and an
/// option of the same name (tests/cli walks the options).
TEST(Reach, EveryParameterRowHasItsTooltipAndOption) {
  HeadlessFrame ui({1280, 4000});
  ui.openFlooded("sphere", 300);
  for (const char* group : {"Model", "Balance", "Cutting", "Stopping", "Method"}) {
    ui.click(std::string("section/") + group);
    ui.frames(2);
  }
  for (const ParameterInfo& info : parameterTable()) {
    const std::string label = std::string("label/") + info.id;
    ASSERT_TRUE(ui.has(label)) << info.id;
    ASSERT_TRUE(ui.has(info.id)) << info.id;
    EXPECT_GE(std::string_view(info.help).size(), 20u) << info.id;
    ui.moveTo(ui.item(label).center());
    ui.frames(40);  // more than the delay
    const ImGuiWindow* tip = nullptr;
    for (const ImGuiWindow* window : GImGui->Windows) {
      if (window->Active && (window->Flags & ImGuiWindowFlags_Tooltip) != 0) tip = window;
    }
    EXPECT_NE(tip, nullptr) << info.id << " has no tooltip";
    Parameters trial;
    const std::string value = parameterText(parameterDefault(info));
    EXPECT_NO_THROW(setParameterFromText(trial, info, value)) << info.id;
    EXPECT_EQ(findParameter(info.id), &info);
  }
}

}  // namespace
}  // namespace chartflood
