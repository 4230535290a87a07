#pragma once
/// Which files a file may name: those of its own folder or below. The one rule for buffers,
/// materials, pictures and whatever else a mesh or session points at.

#include <filesystem>
#include <string>
#include <string_view>

namespace chartflood {

/// A file that another one names.
struct Reference {
  std::filesystem::path file;  ///< canonical path of a regular file; "" when it may not be read
  std::string refusal;         ///< why not, as the end of "its buffer a.bin ..": "is not there"

  explicit operator bool() const { return refusal.empty(); }
};

/// Looks for `name` below `folder` (""; the present one), links followed: what lies outside is
/// refused whether it is there or not, and so is whatever is no regular file. Nothing is opened.
/// \param name relative, or absolute as long as it leads into the folder
Reference findReference(const std::filesystem::path& folder, std::string_view name);

}  // namespace chartflood
