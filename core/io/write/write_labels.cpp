#include "core/io/write/write_labels.h"

#include <array>
#include <charconv>
#include <vector>

#include "core/base/check.h"
#include "core/io/write/file_output.h"

namespace chartflood {

std::string labelsText(const Mesh& mesh, std::span<const Index> label) {
  CF_CHECK(label.size() == mesh.faceCount());
  std::vector<Index> ofInputFace(mesh.input().faceCount(), kNone);
  for (std::size_t f = 0; f < label.size(); ++f) {
    ofInputFace[mesh.inputFace(static_cast<Index>(f))] = label[f];
  }
  std::string text;
  text.reserve(4 * ofInputFace.size());
  std::array<char, 16> digits;
  for (const Index chart : ofInputFace) {
    if (chart == kNone) {
      text += "-1\n";
      continue;
    }
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), chart).ptr;
    text.append(digits.data(), end).push_back('\n');
  }
  return text;
}

void writeLabels(const std::filesystem::path& file, const Mesh& mesh,
                 std::span<const Index> label) {
  writeFileAtomically(file, labelsText(mesh, label));
}

}  // namespace chartflood
