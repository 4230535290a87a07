#include "render/scene/surface_marks.h"

#include <array>

namespace chartflood {

glm::vec3 markColor(TriangleMark mark) {
  static constexpr std::array<glm::vec3, kTriangleMarks> kColors = {
      glm::vec3(0), glm::vec3(0.835f, 0.369f, 0.0f), glm::vec3(0.0f, 0.447f, 0.698f),
      glm::vec3(0.800f, 0.475f, 0.655f), glm::vec3(0.941f, 0.894f, 0.259f)};
  return kColors[static_cast<std::size_t>(mark)];
}

}  // namespace chartflood
