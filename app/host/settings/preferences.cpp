#include "app/host/settings/preferences.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/host/settings/settings_file.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kConfigName = "config.json";
constexpr const char* kStateName = "state.json";

/// One file's values, with a note of what could not be used.
class PreferenceValues {
 public:
  PreferenceValues(const std::filesystem::path& file, std::string& warning)
      : file_(file), warning_(warning) {
    std::string problem;
    json_ = readSettingsFile(file, problem);
    if (problem.empty()) return;
    warn(problem + "; it was not used, and will be kept as " + keptName(file).filename().string() +
         " beside new settings");
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
  /// {name: {option: value, ..}, ..}
  void readPresets(Preferences& result) {
    if (!json_.contains("presets")) return;
    std::vector<UserPreset>& presets = result.presets;
    for (const auto& [name, values] : json_["presets"].items()) {
      const std::string problem = presetNameProblem(presets, name);
      if (!values.is_object() || !problem.empty()) {
        warn("holds an unusable preset '" + name + "', which is kept as it is");
        result.unusablePresets.emplace_back(name, values.dump());
        continue;
      }
      UserPreset preset{name, {}};
      for (const auto& [id, value] : values.items()) {
        preset.values.emplace_back(id, value.is_string() ? value.get<std::string>() : value.dump());
      }
      presets.push_back(std::move(preset));
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
    warning_ = "The settings file " + file_.string() + ' ' + cause;
    if (warning_.back() != '.') warning_ += '.';
  }

  std::filesystem::path file_;
  std::string& warning_;
  Json json_;
};

Json presetsJson(const Preferences& preferences) {
  Json json = Json::object();
  for (const auto& [name, text] : preferences.unusablePresets) {
    json[name] = Json::parse(text, nullptr, false);
  }
  for (const UserPreset& preset : preferences.presets) {
    Json values = Json::object();
    for (const auto& [id, text] : preset.values) values[id] = text;
    json[preset.name] = std::move(values);
  }
  return json;
}

/// Each as "key=value", so that one that cannot be used does not cost the others.
void readPicture(PreferenceValues& config, PictureSettings& picture, std::string& warning) {
  std::vector<std::string> list;
  config.readStrings("picture", list);
  picture.lockRatio = false;  // both sides of the own size are read as they are
  for (const std::string& each : list) {
    const std::size_t equals = std::min(each.find('='), each.size());
    const bool known = each.starts_with("lock-ratio=");
    if (known || equals == each.size()) continue;
    try {
      setPictureValue(picture, each.substr(0, equals), each.substr(equals + 1));
    } catch (const UsageError& error) {
      warning = error.what();
    }
  }
  picture.lockRatio =
      std::find(list.begin(), list.end(), std::string("lock-ratio=off")) == list.end();
}

Json pictureJson(const PictureSettings& picture) {
  Json list = Json::array();
  for (const std::string& key : pictureKeys())
    list.push_back(key + '=' + pictureValue(picture, key));
  return list;
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
  std::string navigation = navigationStyleId(result.navigation), live = liveModeId(result.live),
              theme = themeInfo(result.theme).id;
  PreferenceValues config(configFolder / kConfigName, warning);
  config.read("theme", theme, &Json::is_string);
  config.read("ui-scale", result.uiScale, &Json::is_number);
  config.read("navigation", navigation, &Json::is_string);
  config.read("invert-zoom", result.invertZoom, &Json::is_boolean);
  config.read("trackball", result.trackball, &Json::is_boolean);
  config.read("invert-turn-x", result.invertTurnX, &Json::is_boolean);
  config.read("invert-turn-y", result.invertTurnY, &Json::is_boolean);
  config.read("live", live, &Json::is_string);
  config.read("first-steps", result.firstCard, &Json::is_boolean);
  config.read("ask-unsaved", result.askUnsaved, &Json::is_boolean);
  config.readPresets(result);
  readPicture(config, result.picture, warning);
  std::string many = manyFacesId(result.film.many);
  config.read("many", many, &Json::is_string);
  result.film.many = manyFacesFromId(many);
  config.read("reduced-motion", result.film.reducedMotion, &Json::is_boolean);
  result.navigation = navigationStyleFromId(navigation);
  result.live = liveModeFromId(live);
  if (const ThemeInfo* known = findTheme(theme)) result.theme = known->kind;
  if (result.uiScale != 0) result.uiScale = std::clamp(result.uiScale, 0.75, 2.5);

  PreferenceValues state(stateFolder / kStateName, warning);
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
  writeSettingsFile(configFolder / kConfigName,
                    {{"theme", themeInfo(preferences.theme).id},
                     {"ui-scale", preferences.uiScale},
                     {"navigation", navigationStyleId(preferences.navigation)},
                     {"invert-zoom", preferences.invertZoom},
                     {"trackball", preferences.trackball},
                     {"invert-turn-x", preferences.invertTurnX},
                     {"invert-turn-y", preferences.invertTurnY},
                     {"live", liveModeId(preferences.live)},
                     {"first-steps", preferences.firstCard},
                     {"ask-unsaved", preferences.askUnsaved},
                     {"presets", presetsJson(preferences)},
                     {"many", manyFacesId(preferences.film.many)},
                     {"reduced-motion", preferences.film.reducedMotion},
                     {"picture", pictureJson(preferences.picture)}});
  writeSettingsFile(stateFolder / kStateName, {{"window-width", preferences.windowWidth},
                                               {"window-height", preferences.windowHeight},
                                               {"recent-files", preferences.recentFiles}});
}

}  // namespace chartflood
