// Reading and writing what a user likes.

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

std::optional<SettingValue> settingValueOf(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  return std::nullopt;
}

Json settingJson(const Setting<Preferences>& row, const Preferences& preferences) {
  const SettingValue value = row.get(preferences);
  if (const bool* on = std::get_if<bool>(&value)) return *on;
  if (const std::string* text = std::get_if<std::string>(&value)) return *text;
  const double number = std::get<double>(value);
  if (row.value.domain.type == SettingType::Whole) return static_cast<std::int64_t>(number);
  return number;
}

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

  /// What is absent stays.
  void read(const SettingTable<Preferences>& rows, Preferences& result) {
    for (const Setting<Preferences>& row : rows) {
      if (!json_.contains(row.id)) continue;
      const std::optional<SettingValue> value = settingValueOf(json_[row.id]);
      if (!value || !row.set(result, *value).empty()) {
        warn(std::string("holds an unusable value for '") + row.id + "'");
      }
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
  for (const auto& row : pictureSettingTable()) {
    list.push_back(std::string(row.id) + '=' + row.text(picture));
  }
  return list;
}

}  // namespace

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
  PreferenceValues config(configFolder / kConfigName, warning);
  config.read(preferenceTable(), result);
  config.readPresets(result);
  readPicture(config, result.picture, warning);
  PreferenceValues state(stateFolder / kStateName, warning);
  state.read(windowPlaceTable(), result);
  state.readStrings("recent-files", result.recentFiles);
  if (result.recentFiles.size() > Preferences::kMostRecent) {
    result.recentFiles.resize(Preferences::kMostRecent);
  }
  return result;
}

void writePreferences(const Preferences& preferences, const std::filesystem::path& configFolder,
                      const std::filesystem::path& stateFolder) {
  Json config, state;
  for (const auto& row : preferenceTable()) config[row.id] = settingJson(row, preferences);
  config["presets"] = presetsJson(preferences);
  config["picture"] = pictureJson(preferences.picture);
  for (const auto& row : windowPlaceTable()) state[row.id] = settingJson(row, preferences);
  state["recent-files"] = preferences.recentFiles;
  writeSettingsFile(configFolder / kConfigName, config);
  writeSettingsFile(stateFolder / kStateName, state);
}

}  // namespace chartflood
