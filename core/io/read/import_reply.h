#pragma once
/// What the importing program answers: a mesh or the reason why there is none, as checked bytes.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/model/input_mesh.h"

namespace chartflood {

enum class ImportOutcome : std::uint32_t {
  Mesh = 1,        ///< positions, corners and faces follow
  Refused = 2,     ///< the reason follows: the library's words
  OutOfMemory = 3  ///< reading asked for more than it may have
};

/// An answer on its way: what comes first in its bytes, then the parts that it counts.
struct ImportReply {
  ImportOutcome outcome = ImportOutcome::Refused;
  std::string reason;
  InputMesh mesh;                    ///< positions, corners, faceStart and repairs alone
  std::uint64_t pointsAndLines = 0;  ///< left out
};

/// Hands the bytes of an answer to `put`, which says whether it could take them.
bool writeImportReply(const ImportReply& reply,
                      const std::function<bool(std::span<const std::byte>)>& put);

/// Takes an answer from `get`, which fills its argument or says that it cannot. Nothing in it is
/// trusted: numbers of vertices, faces and corners are held against each other.
/// \param longest most bytes that the answer may have
/// \returns false when bytes are missing or no answer of writeImportReply()
bool readImportReply(ImportReply& reply, std::size_t longest,
                     const std::function<bool(std::span<std::byte>)>& get);

}  // namespace chartflood
