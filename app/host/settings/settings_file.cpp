#include "app/host/settings/settings_file.h"

#include <algorithm>
#include <string>
#include <system_error>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/io/write/file_output.h"

namespace chartflood {

namespace {

using Json = nlohmann::ordered_json;

/// What is nested deeper is no settings file; writing it again would need as deep a recursion.
constexpr int kDeepest = 32;
constexpr std::uintmax_t kLargest = 16 << 20;  // bytes

/// Parses without exceptions; discarded when it is no JSON or nested too deeply.
Json parse(std::string_view text) {
  bool deep = false;
  const Json json = Json::parse(
      text,
      [&](int depth, Json::parse_event_t, Json&) {
        deep = deep || depth > kDeepest;
        return !deep;
      },
      false);
  return deep ? Json(Json::value_t::discarded) : json;
}

bool sameKind(const Json& a, const Json& b) {
  return a.type() == b.type() || (a.is_number() && b.is_number());
}

/// Whether every value that will be replaced is one that could be read.
bool fits(const Json& old, const Json& values) {
  const auto entries = values.items();
  return std::all_of(entries.begin(), entries.end(), [&](const auto& entry) {
    return !old.contains(entry.key()) || sameKind(old[entry.key()], entry.value());
  });
}

}  // namespace

Json readSettingsFile(const std::filesystem::path& file, std::string& problem) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return Json::object();
  if (std::filesystem::is_regular_file(file, error) &&
      std::filesystem::file_size(file, error) > kLargest) {
    problem = "is larger than settings are";
    return Json::object();
  }
  try {
    Json json = parse(FileBytes(file).view());
    if (json.is_object()) return json;
    problem = "is not a JSON object";
  } catch (const ReadError& failure) {
    problem = "could not be read: " + failure.cause();
  }
  return Json::object();
}

std::filesystem::path keptName(const std::filesystem::path& file) {
  const std::string name = file.string() + ".broken";
  std::filesystem::path kept = name;
  std::error_code unknown;
  for (int i = 2; std::filesystem::exists(std::filesystem::symlink_status(kept, unknown)); ++i) {
    kept = name + '-' + std::to_string(i);
  }
  return kept;
}

void writeSettingsFile(const std::filesystem::path& file, const Json& values) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error) throw WriteError(file.string(), error.message());
  std::string problem;
  Json all = readSettingsFile(file, problem);
  const std::filesystem::path kept = keptName(file);
  // What is no file at all is refused below.
  if (std::filesystem::is_regular_file(file, error) && !(problem.empty() && fits(all, values))) {
    // What may not be read cannot be copied, but be moved.
    std::filesystem::copy_file(file, kept, error);
    if (error) std::filesystem::rename(file, kept, error);
    if (error) throw WriteError(kept.string(), error.message());
  }
  for (const auto& [key, value] : values.items()) all[key] = value;
  writeFileAtomically(file, all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace chartflood
