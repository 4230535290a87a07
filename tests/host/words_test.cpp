// One word for one thing, in everything that a user reads in tables.

#include <cctype>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/settings/preferences.h"
#include "app/host/settings/slider_scale.h"
#include "core/segment/registry.h"
#include "core/session/settings/parameter_table.h"
#include "render/scene/color_modes.h"

namespace chartflood {
namespace {

/// A text and where it stands.
using Text = std::pair<std::string, std::string>;

std::vector<Text> allTexts() {
  std::vector<Text> texts;
  const ActionRegistry registry = makeActionRegistry();
  for (const Action& action : registry.actions()) {
    texts.emplace_back(action.title + ". " + action.help, action.id);
    for (const ArgumentInfo& argument : action.arguments) {
      texts.emplace_back(argument.help, action.id);
      for (const std::string& label : argument.labels) texts.emplace_back(label, action.id);
    }
  }
  for (const ParameterInfo& info : parameterTable()) {
    texts.emplace_back(std::string(info.label) + ". " + info.help, info.id);
    for (const ParameterChoice& choice : info.choices) texts.emplace_back(choice.label, info.id);
  }
  for (const Preset& preset : presetTable()) {
    texts.emplace_back(std::string(preset.label) + ". " + preset.help, preset.id);
  }
  for (const ColorModeInfo& mode : colorModeTable()) {
    texts.emplace_back(std::string(mode.label) + ". " + mode.title + ". " + mode.help, mode.id);
  }
  for (const Setting<Preferences>& row : preferenceTable()) {
    texts.emplace_back(std::string(row.title) + ". " + row.help, row.id);
  }
  return texts;
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  return words;
}

TEST(Words, AChartIsAChart) {
  for (const auto& [text, where] : allTexts()) {
    for (const std::string& word : wordsOf(text)) {
      for (const char* other : {"piece", "pieces", "island", "islands", "patch", "patches"}) {
        EXPECT_NE(word, other) << where << ": " << text;
      }
    }
  }
}

TEST(Words, ARoundIsARound) {
  for (const ParameterInfo& info : parameterTable()) {
    for (const std::string& word : wordsOf(std::string(info.label) + ' ' + info.help)) {
      EXPECT_NE(word, "iteration") << info.id;
      EXPECT_NE(word, "iterations") << info.id;
    }
  }
}

TEST(Words, CountsSayOfWhat) {
  EXPECT_EQ(sliderText(*findParameter("patience"), 10), "10 rounds");
  EXPECT_EQ(sliderText(*findParameter("patience"), 1), "1 round");
  EXPECT_EQ(sliderText(*findParameter("margin"), 8), "8 px");
}

}  // namespace
}  // namespace chartflood
