#include "core/io/read/reference_path.h"

#include <algorithm>
#include <system_error>

namespace chartflood {

namespace {

bool isBelow(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const auto [inFolder, inFile] =
      std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return inFolder == folder.end() && inFile != file.end();
}

}  // namespace

Reference findReference(const std::filesystem::path& folder, std::string_view name) {
  namespace fs = std::filesystem;
  if (name.empty() || name.find('\0') != std::string_view::npos) return {{}, "is not there"};
  std::error_code error;
  const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) return {{}, "is not there"};
  // Of what does not exist only the beginning has links; the rest is taken by its words.
  const fs::path file = fs::weakly_canonical(root / fs::path(name), error);
  if (error) return {{}, "cannot be reached (" + error.message() + ")"};
  if (!isBelow(root, file)) {
    return {{}, "lies outside of the file's folder; put it beside the file or below"};
  }
  switch (fs::status(file, error).type()) {
  case fs::file_type::regular:
    return {file, ""};
  case fs::file_type::not_found:
    return {{}, "is not in the file's folder"};
  case fs::file_type::directory:
    return {{}, "is a folder"};
  case fs::file_type::fifo:
    return {{}, "is a pipe; only files can be read"};
  case fs::file_type::none:
  case fs::file_type::unknown:
    return {{}, "cannot be reached (" + error.message() + ")"};
  default:
    return {{}, "is a device or socket; only files can be read"};
  }
}

}  // namespace chartflood
