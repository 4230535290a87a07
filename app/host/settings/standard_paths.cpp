#include "app/host/settings/standard_paths.h"

#include <cstdlib>

namespace chartflood {

namespace {

std::filesystem::path folderFrom(const char* variable, const std::filesystem::path& underHome) {
  const char* value = std::getenv(variable);
  if (value != nullptr && std::filesystem::path(value).is_absolute()) return value;
  return homeFolder() / underHome;
}

}  // namespace

std::filesystem::path homeFolder() {
  const char* home = std::getenv("HOME");
  return home != nullptr && *home != '\0' ? std::filesystem::path(home)
                                          : std::filesystem::path("/");
}

std::filesystem::path configFolder() {
  return folderFrom("XDG_CONFIG_HOME", ".config") / "chartflood";
}

std::filesystem::path stateFolder() {
  return folderFrom("XDG_STATE_HOME", ".local/state") / "chartflood";
}

std::filesystem::path picturesFolder() {
  return folderFrom("XDG_PICTURES_DIR", "Pictures") / "chartflood";
}

}  // namespace chartflood
