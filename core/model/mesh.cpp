#include "core/model/mesh.h"

#include <algorithm>

namespace chartflood {

long Mesh::eulerNumber() const {
  const auto used = std::count_if(d_.vertexSide.begin(), d_.vertexSide.end(),
                                  [](Index side) { return side != kNone; });
  return static_cast<long>(used) - static_cast<long>(edgeCount()) +
         static_cast<long>(triangleCount());
}

long Mesh::genus() const {
  const long twice = 2 * static_cast<long>(componentCount()) -
                     static_cast<long>(boundaryLoopCount()) - eulerNumber();
  return twice / 2;
}

}  // namespace chartflood
