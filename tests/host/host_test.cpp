// The host's small values: keys, script lines, undo, names of files, preferences, sliders.

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/actions/actions.h"
#include "app/host/files/file_name_template.h"
#include "app/host/script/action_registry.h"
#include "app/host/script/chord.h"
#include "app/host/script/command.h"
#include "app/host/settings/preferences.h"
#include "app/host/settings/slider_scale.h"
#include "app/host/settings/undo_history.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"
#include "tests/support/temporary_folder.h"

namespace chartflood {
namespace {

using ::testing::HasSubstr;

TEST(Chord, ReadsAndWrites) {
  for (const char* text : {"Ctrl+Shift+Z", "Space", "+", "Ctrl++", "Kp5", "Alt+["}) {
    EXPECT_EQ(chordText(parseChord(text)), text);
  }
  EXPECT_TRUE(parseChord("Ctrl++").ctrl);
  EXPECT_THROW(parseChord("Super+A"), UsageError);
  EXPECT_THROW(parseChord("Ctrl+"), UsageError);
}

TEST(Command, ReadsWordsKeysAndQuotes) {
  const Command command = parseCommand("set charts 24 drag=on file=\"a b\\\"c.obj\" # note");
  EXPECT_EQ(command.action, "set");
  EXPECT_EQ(command.arguments,
            (ArgumentMap{{"0", "charts"}, {"1", "24"}, {"drag", "on"}, {"file", "a b\"c.obj"}}));
  EXPECT_EQ(parseCommand(commandText(command)), command);
  EXPECT_EQ(parseCommand("  # only a comment").action, "");
}

TEST(Command, RefusesOpenQuotesAndRepeatedKeys) {
  EXPECT_THROW(parseCommand("open \"a.obj"), UsageError);
  EXPECT_THROW(parseCommand("open file=a file=b"), UsageError);
  EXPECT_THROW(parseCommand("open =a"), UsageError);
}

TEST(Command, QuotedNamesSurvive) {
  for (const char* name : {"plain.obj", "two words.obj", "a=b", "\"", "back\\slash", "#1", ""}) {
    EXPECT_EQ(parseCommand("open " + quotedArgument(name)).arguments.at("0"), name);
  }
}

TEST(Registry, EveryBindingRunsAnActionAndEveryActionHasHelp) {
  const ActionRegistry registry = makeActionRegistry();
  for (const Action& action : registry.actions()) {
    EXPECT_FALSE(action.title.empty()) << action.id;
    EXPECT_FALSE(action.help.empty()) << action.id;
    EXPECT_TRUE(static_cast<bool>(action.run)) << action.id;
  }
  for (const Binding& binding : registry.bindings()) {
    const Command command = parseCommand(binding.line);
    const Action* action = registry.find(command.action);
    ASSERT_NE(action, nullptr) << binding.line;
    EXPECT_NO_THROW(Arguments(action->id, action->arguments, command.arguments)) << binding.line;
    const Binding* found = registry.findBinding(binding.chord, binding.place);
    ASSERT_NE(found, nullptr) << binding.line;
    EXPECT_EQ(found->line, binding.line) << "another line hides it";
  }
  EXPECT_EQ(registry.shortcut("undo"), "Ctrl+Z");
}

TEST(Preferences, AreWrittenSoonAfterTheyChange) {
  const ActionRegistry registry = makeActionRegistry();
  AppState state(Session::Worker::Inline);
  int written = 0;
  state.keepPreferences = [&] { ++written; };
  state.perform(registry, "invert-zoom on");
  state.update(2);
  state.update(2);
  EXPECT_EQ(written, 0) << "they are not kept yet";
  state.preferencesAreKept();
  state.update(2);
  EXPECT_EQ(written, 0);
  state.perform(registry, "invert-zoom off");
  state.update(0.1);
  state.update(0.1);
  EXPECT_EQ(written, 0) << "more may follow";
  state.update(2);
  EXPECT_EQ(written, 1);
  state.update(2);
  EXPECT_EQ(written, 1);
}

TEST(Notices, ErrorsGoByAndAreCounted) {
  Notices notices;
  notices.add(Notice::Kind::Error, "It failed.");
  notices.update(0);
  notices.update(Notices::kToastSeconds + 1);
  EXPECT_EQ(notices.toasts().size(), 1u) << "longer than others";
  notices.update(Notices::kErrorSeconds);
  EXPECT_TRUE(notices.toasts().empty());
  EXPECT_EQ(notices.missedErrors(), 1u);
  notices.forgetMissed();
  EXPECT_EQ(notices.missedErrors(), 0u);
}

TEST(Registry, NamesTheNearestActionAndTheWrongArgument) {
  const ActionRegistry registry = makeActionRegistry();
  AppState state(Session::Worker::Inline);
  EXPECT_FALSE(state.perform(registry, "undoo"));
  EXPECT_THAT(state.notices.toasts().back().text, HasSubstr("'undo'"));
  EXPECT_FALSE(state.perform(registry, "color-mode rainbow"));
  EXPECT_THAT(state.notices.toasts().back().text, HasSubstr("charts"));
  EXPECT_FALSE(state.perform(registry, "step count=x"));
  EXPECT_THAT(state.notices.toasts().back().text, HasSubstr("whole number"));
  EXPECT_FALSE(state.perform(registry, "screenshot"));
  EXPECT_THAT(state.notices.toasts().back().text, HasSubstr("no model"));
  EXPECT_TRUE(state.journal().empty());
}

TEST(UndoHistory, MergesAnOpenEntryOfOneKey) {
  UndoHistory<int> history;
  history.changed(1, "to 2", "a");
  history.changed(2, "to 3", "a");
  EXPECT_EQ(history.size(), 1u);
  EXPECT_EQ(history.undoName(), "to 3");
  history.close();
  history.changed(3, "to 4", "a");
  EXPECT_EQ(history.size(), 2u);
  EXPECT_EQ(history.undo(4), 3);
  EXPECT_EQ(history.undo(3), 1);
  EXPECT_FALSE(history.canUndo());
  EXPECT_EQ(history.redo(1), 3);
  EXPECT_EQ(history.redo(3), 4);
  history.undo(4);
  history.changed(3, "to 9", "b");
  EXPECT_FALSE(history.canRedo());
}

TEST(FileName, NeverOneThatExists) {
  const TemporaryFolder folder;
  const auto next = [&] {
    return freeFileName(folder.path(), "{model}_{mode}_{n:3}.png", "a/b", "charts");
  };
  EXPECT_EQ(next().filename(), "a_b_charts_001.png");
  std::ofstream(next()) << "x";
  EXPECT_EQ(next().filename(), "a_b_charts_002.png");
  std::ofstream(folder.path() / "one.png") << "x";
  EXPECT_EQ(freeFileName(folder.path(), "one.png", "", "").filename(), "one_2.png");
  EXPECT_THROW(freeFileName(folder.path(), "{date}.png", "", ""), UsageError);
}

TEST(Preferences, RoundTrip) {
  const TemporaryFolder folder;
  Preferences wanted;
  wanted.uiScale = 1.5;
  wanted.navigation = NavigationStyle::Blender;
  wanted.live = LiveMode::Off;
  wanted.firstCard = false;
  wanted.windowWidth = 1600;
  rememberFile(wanted, "/models/a b.obj");
  writePreferences(wanted, folder.path() / "config", folder.path() / "state");
  std::string warning;
  EXPECT_EQ(readPreferences(folder.path() / "config", folder.path() / "state", warning), wanted);
  EXPECT_EQ(warning, "");
}

TEST(Preferences, BrokenFilesAreNamedAndNotFatal) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "config.json") << "{ \"ui-scale\": \"big\" }";
  std::string warning;
  EXPECT_EQ(readPreferences(folder.path(), folder.path(), warning), Preferences{});
  EXPECT_THAT(warning, HasSubstr("ui-scale"));
  std::ofstream(folder.path() / "config.json") << "not json";
  EXPECT_EQ(readPreferences(folder.path(), folder.path(), warning), Preferences{});
  EXPECT_THAT(warning, HasSubstr("config.json"));
}

/// What is in the folder beside the settings themselves: the content by the name.
std::map<std::string, std::string> keptIn(const std::filesystem::path& folder) {
  std::map<std::string, std::string> kept;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream stream(entry.path());
    std::ostringstream text;
    text << stream.rdbuf();
    const std::string name = entry.path().filename().string();
    if (name != "config.json" && name != "state.json") kept[name] = text.str();
  }
  return kept;
}

TEST(Preferences, WhatCannotBeReadIsKeptBeside) {
  const TemporaryFolder folder;
  const std::string typed = "{ \"theme\": \"light\", }";  // one comma too many
  const std::string odd = "{ \"ui-scale\": \"big\" }";
  const std::string deep(200'000, '[');
  const auto save = [&](const std::string& text) {
    std::ofstream(folder.path() / "config.json") << text;
    std::string warning;
    const Preferences read = readPreferences(folder.path(), folder.path(), warning);
    EXPECT_NE(warning, "");
    writePreferences(read, folder.path(), folder.path());
    EXPECT_EQ(readPreferences(folder.path(), folder.path(), warning), read);
    EXPECT_EQ(warning, "");
  };
  save(typed);
  save(odd);
  save(deep);
  EXPECT_EQ(keptIn(folder.path()),
            (std::map<std::string, std::string>{{"config.json.broken", typed},
                                                {"config.json.broken-2", odd},
                                                {"config.json.broken-3", deep}}));
}

TEST(Preferences, WhatIsNotKnownStays) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "config.json")
      << R"({"of-a-newer-version": [1, 2], "theme": "light"})";
  std::string warning;
  Preferences likes = readPreferences(folder.path(), folder.path(), warning);
  EXPECT_EQ(warning, "");
  likes.theme = ThemeKind::Dark;
  writePreferences(likes, folder.path(), folder.path());
  std::ifstream stream(folder.path() / "config.json");
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_THAT(text.str(), HasSubstr("of-a-newer-version"));
  EXPECT_THAT(text.str(), HasSubstr(R"("theme": "dark")"));
  EXPECT_TRUE(keptIn(folder.path()).empty());
}

TEST(Preferences, APipeIsNeitherReadNorReplaced) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder.path() / "config.json").c_str(), 0600), 0);
  std::string warning;
  EXPECT_EQ(readPreferences(folder.path(), folder.path(), warning), Preferences{});
  EXPECT_THAT(warning, HasSubstr("config.json"));
  EXPECT_THROW(writePreferences({}, folder.path(), folder.path()), WriteError);
  EXPECT_TRUE(std::filesystem::is_fifo(folder.path() / "config.json"));
}

TEST(Preferences, RecentFilesAreNewestFirstWithoutRepeats) {
  Preferences preferences;
  for (int i = 0; i < 15; ++i) rememberFile(preferences, "/m/" + std::to_string(i));
  rememberFile(preferences, "/m/9");
  ASSERT_EQ(preferences.recentFiles.size(), Preferences::kMostRecent);
  EXPECT_EQ(preferences.recentFiles[0], "/m/9");
  EXPECT_EQ(preferences.recentFiles[1], "/m/14");
}

TEST(SliderScale, EveryDefaultRoundTripsWithinItsFormat) {
  for (const ParameterInfo& info : parameterTable()) {
    const ParameterValue value = parameterDefault(info);
    if (!std::holds_alternative<int>(value) && !std::holds_alternative<double>(value)) continue;
    const double number = asNumber(value);
    const double again = sliderValue(info, sliderFraction(info, number));
    EXPECT_NEAR(again, number, 0.02 * number + 1e-12) << info.id;
    EXPECT_EQ(sliderText(info, again).find("e-0"), std::string::npos) << info.id;
  }
}

TEST(SliderScale, EndsAreReached) {
  for (const ParameterInfo& info : parameterTable()) {
    const ParameterValue value = parameterDefault(info);
    if (!std::holds_alternative<int>(value) && !std::holds_alternative<double>(value)) continue;
    EXPECT_DOUBLE_EQ(sliderValue(info, 1), info.sliderMax) << info.id;
    const double low = info.scale == SliderScale::LogZero ? 0 : info.sliderMin;
    EXPECT_DOUBLE_EQ(sliderValue(info, 0), low) << info.id;
  }
}

}  // namespace
}  // namespace chartflood
