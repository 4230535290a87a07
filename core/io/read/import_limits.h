#pragma once
/// How much memory and time the importing program may take for a file.

#include <chrono>
#include <cstddef>
#include <string_view>

namespace chartflood {

/// In place of an extension: glTF with geometry that Draco compressed, to a tenth of its size.
inline constexpr std::string_view kDracoGltf = "draco-gltf";

/// Grows with the file: what holds for all formats is that a scene takes a few tens of its bytes
/// and that a megabyte is read in far less than a second.
struct ImportLimits {
  /// \param extension what is read, see readAssimp() and readDracoGltf()
  ImportLimits(std::size_t fileSize, std::string_view extension)
      : memory((std::size_t{1} << 30) + (extension == kDracoGltf ? 256 : 32) * fileSize),
        work(20 + static_cast<long>(fileSize >> 20)), wait(10 * work) {}

  std::size_t memory;         ///< bytes of address space
  std::chrono::seconds work;  ///< of a processor
  /// By the clock: ends one that waits instead of working. Far more than `work`, because the
  /// machine may be busy with other things.
  std::chrono::seconds wait;
};

}  // namespace chartflood
