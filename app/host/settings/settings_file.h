#pragma once
/// A file of settings as JSON. What a user wrote into it is never lost: what is not understood
/// stays in it, and a file that cannot be used is put aside, not overwritten.

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace chartflood {

/// The object in the file; an empty one when there is no file or it cannot be used. Why not is
/// added to `problem` as the end of a sentence: "is not a JSON object".
nlohmann::ordered_json readSettingsFile(const std::filesystem::path& file, std::string& problem);

/// Replaces the values of the file that `values` names; others stay. A file that cannot be used, or
/// whose values are of other types, is kept beside under keptName().
/// \throws WriteError
void writeSettingsFile(const std::filesystem::path& file, const nlohmann::ordered_json& values);

/// The free name that such a file is kept under: "config.json.broken", "config.json.broken-2", ..
std::filesystem::path keptName(const std::filesystem::path& file);

}  // namespace chartflood
