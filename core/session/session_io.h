#pragma once
/// Session files (`.chartflood`, JSON) in and out.

#include <filesystem>
#include <string>

#include "core/session/session_file.h"

namespace chartflood {

/// Text of a session file that is to stand at `target`: the model's place is also noted relative
/// to it, so that both can be moved together.
std::string sessionText(const SessionFile& session, const std::filesystem::path& target);

/// Reads a session file. The model's file is the one beside it by the relative path, or else the
/// one at the absolute path. Unusable single values keep their defaults and are named in
/// `warnings`.
/// \throws ReadError when the file cannot be read, is not a whole session file, or was written by
///   a newer program.
SessionFile readSession(const std::filesystem::path& file);

}  // namespace chartflood
