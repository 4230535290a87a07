#include "app/host/preferences.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/io/file_output.h"

namespace chartflood {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kConfigName = "config.json";
constexpr const char* kStateName = "state.json";

/// One file's values, with a note of what could not be used.
class Values {
 public:
  Values(const std::filesystem::path& file, std::string& warning) : file_(file), warning_(warning) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return;
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    json_ = Json::parse(text.str(), nullptr, false);
    if (!stream || json_.is_discarded() || !json_.is_object()) {
      warn("is not a JSON object and was not used");
      json_ = Json::object();
    }
  }

  template <typename T>
  void read(const char* key, T& value, bool (Json::*isType)() const noexcept) {
    if (!json_.contains(key)) return;
    if ((json_[key].*isType)()) {
      value = json_[key].get<T>();
    } else {
      warn(std::string("holds an unusable value for '") + key + "'");
    }
  }
  void readStrings(const char* key, std::vector<std::string>& list) {
    if (!json_.contains(key) || !json_[key].is_array()) return;
    for (const Json& entry : json_[key]) {
      if (entry.is_string()) list.push_back(entry.get<std::string>());
    }
  }

 private:
  void warn(const std::string& cause) {
    warning_ = "The settings file " + file_.string() + ' ' + cause + '.';
  }

  std::filesystem::path file_;
  std::string& warning_;
  Json json_ = Json::object();
};

void writeJson(const std::filesystem::path& folder, const char* name, const Json& json) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw WriteError((folder / name).string(), error.message());
  writeFileAtomically(folder / name,
                      json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace

const char* liveModeId(LiveMode mode) {
  switch (mode) {
  case LiveMode::On:
    return "on";
  case LiveMode::Off:
    return "off";
  case LiveMode::Auto:
    break;
  }
  return "auto";
}

const char* navigationStyleId(NavigationStyle style) {
  switch (style) {
  case NavigationStyle::Blender:
    return "blender";
  case NavigationStyle::Maya:
    return "maya";
  case NavigationStyle::Simple:
    break;
  }
  return "simple";
}

LiveMode liveModeFromId(const std::string& id) {
  return id == "on" ? LiveMode::On : id == "off" ? LiveMode::Off : LiveMode::Auto;
}

NavigationStyle navigationStyleFromId(const std::string& id) {
  return id == "blender" ? NavigationStyle::Blender
         : id == "maya"  ? NavigationStyle::Maya
                         : NavigationStyle::Simple;
}

void rememberFile(Preferences& preferences, const std::filesystem::path& file) {
  const std::string name = std::filesystem::absolute(file).lexically_normal().string();
  std::vector<std::string>& recent = preferences.recentFiles;
  recent.erase(std::remove(recent.begin(), recent.end(), name), recent.end());
  recent.insert(recent.begin(), name);
  if (recent.size() > Preferences::kMostRecent) recent.resize(Preferences::kMostRecent);
}

Preferences readPreferences(const std::filesystem::path& configFolder,
                            const std::filesystem::path& stateFolder, std::string& warning) {
  warning.clear();
  Preferences result;
  std::string navigation = navigationStyleId(result.navigation), live = liveModeId(result.live);
  Values config(configFolder / kConfigName, warning);
  config.read("ui-scale", result.uiScale, &Json::is_number);
  config.read("navigation", navigation, &Json::is_string);
  config.read("invert-zoom", result.invertZoom, &Json::is_boolean);
  config.read("live", live, &Json::is_string);
  config.read("first-steps", result.firstCard, &Json::is_boolean);
  config.read("ask-unsaved", result.askUnsaved, &Json::is_boolean);
  config.read("screenshot-scale", result.screenshotScale, &Json::is_number_integer);
  result.navigation = navigationStyleFromId(navigation);
  result.live = liveModeFromId(live);
  if (result.uiScale != 0) result.uiScale = std::clamp(result.uiScale, 0.75, 2.5);
  result.screenshotScale = std::clamp(result.screenshotScale, 1, 4);

  Values state(stateFolder / kStateName, warning);
  state.read("window-width", result.windowWidth, &Json::is_number_integer);
  state.read("window-height", result.windowHeight, &Json::is_number_integer);
  state.readStrings("recent-files", result.recentFiles);
  result.windowWidth = std::clamp(result.windowWidth, 640, 16384);
  result.windowHeight = std::clamp(result.windowHeight, 480, 16384);
  if (result.recentFiles.size() > Preferences::kMostRecent) {
    result.recentFiles.resize(Preferences::kMostRecent);
  }
  return result;
}

void writePreferences(const Preferences& preferences, const std::filesystem::path& configFolder,
                      const std::filesystem::path& stateFolder) {
  writeJson(configFolder, kConfigName,
            {{"ui-scale", preferences.uiScale},
             {"navigation", navigationStyleId(preferences.navigation)},
             {"invert-zoom", preferences.invertZoom},
             {"live", liveModeId(preferences.live)},
             {"first-steps", preferences.firstCard},
             {"ask-unsaved", preferences.askUnsaved},
             {"screenshot-scale", preferences.screenshotScale}});
  writeJson(stateFolder, kStateName,
            {{"window-width", preferences.windowWidth},
             {"window-height", preferences.windowHeight},
             {"recent-files", preferences.recentFiles}});
}

}  // namespace chartflood
