#pragma once
/// GLB files for tests, from JSON and bytes.

#include <cstdint>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "io_support.h"

namespace chartflood::test {

/// A GLB file around a document, whose version is added, and the binary part.
inline std::string glbFile(nlohmann::json document, std::string_view data) {
  document["asset"]["version"] = "2.0";
  std::string text = document.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string binary(data);
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  const auto total = static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + binary.size());
  return "glTF" + bytesOf(std::uint32_t{2}) + bytesOf(total) +
         bytesOf(static_cast<std::uint32_t>(text.size())) + "JSON" + text +
         bytesOf(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) + binary;
}

}  // namespace chartflood::test
