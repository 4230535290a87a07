#include "core/segment/borders/hint_factors.h"

#include <algorithm>

namespace chartflood {

namespace {

constexpr double kCut = 0.02;
constexpr double kNever = 50;

}  // namespace

std::shared_ptr<const std::vector<double>> hintFactors(const Mesh& mesh,
                                                       std::span<const EdgeHint> hints) {
  if (hints.empty()) return nullptr;
  std::vector<EdgeHint> sorted(hints.begin(), hints.end());
  std::sort(sorted.begin(), sorted.end());
  auto factor = std::make_shared<std::vector<double>>(3 * mesh.triangleCount(), 1.0);
  for (Index s = 0; s < factor->size(); ++s) {
    const Index from = mesh.inputVertex(mesh.sideStart(s)), to = mesh.inputVertex(mesh.sideEnd(s));
    const EdgeHint edge{std::min(from, to), std::max(from, to), HintKind::Cut};
    const auto hint = std::lower_bound(sorted.begin(), sorted.end(), edge);
    if (hint == sorted.end() || hint->a != edge.a || hint->b != edge.b) continue;
    (*factor)[s] = hint->kind == HintKind::Cut ? kCut : kNever;
  }
  return factor;
}

}  // namespace chartflood
