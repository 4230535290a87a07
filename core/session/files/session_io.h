#pragma once
/// Session files (`.chartflood`, JSON) in and out.

#include <filesystem>
#include <string>
#include <string_view>

#include "core/session/files/session_file.h"

namespace chartflood {

/// Text of a session file that is to stand at `target`: the model's place is also noted relative
/// to it, so that both can be moved together. Without a target of the model's file only the name
/// is noted, so that the text tells nobody where the user keeps it.
std::string sessionText(const SessionFile& session, const std::filesystem::path& target);

/// Reads a session file. The model's file is the one beside it by the relative path, or else the
/// one at the absolute path. Unusable single values keep their defaults and are named in
/// `warnings`.
/// \throws ReadError when the file cannot be read, is not a whole session file, or was written by
///   a newer program.
SessionFile readSession(const std::filesystem::path& file);

/// Reads the text of a session that stands in `name`. Its model is `model`, whatever the text says,
/// unless that is a sample.
/// \throws ReadError like readSession()
SessionFile readSessionText(std::string_view text, const std::string& name,
                            const std::filesystem::path& model);

}  // namespace chartflood
