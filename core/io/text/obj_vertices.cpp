#include "core/io/text/obj_vertices.h"

#include "core/io/text/text_blocks.h"

namespace chartflood {

void appendObjVertices(std::string& text, std::span<const glm::dvec3> positions) {
  const auto bound = [](std::size_t begin, std::size_t end) {
    return (end - begin) * (2 + 3 * (kLongestReal + 1));
  };
  appendBlocks(text, positions.size(), bound, [&](std::size_t begin, std::size_t end, char* out) {
    for (std::size_t v = begin; v < end; ++v) {
      *out++ = 'v';
      for (int axis = 0; axis < 3; ++axis) {
        *out++ = ' ';
        out = writeReal(out, positions[v][axis]);
      }
      *out++ = '\n';
    }
    return out;
  });
}

}  // namespace chartflood
