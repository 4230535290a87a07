#include "app/host/actions/hint_edits.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/host/script/action.h"
#include "app/host/state/app_state.h"

namespace chartflood {

namespace {

bool isEdge(const std::vector<std::pair<Index, Index>>& edges, Index a, Index b) {
  return std::binary_search(edges.begin(), edges.end(), std::pair(std::min(a, b), std::max(a, b)));
}

void change(AppState& state, EdgeHints hints, std::string name) {
  Document document = state.document();
  document.hints = std::move(hints);
  state.playback.follow();
  state.changeDocument(document, std::move(name), "hints", false);
}

}  // namespace

void paintHints(AppState& state, HintBrush brush, std::span<const Index> inputVertices) {
  const Mesh& mesh = *state.results().mesh;
  std::vector<std::pair<Index, Index>> edges;
  for (Index s = 0; s < 3 * mesh.triangleCount(); ++s) {
    const Index a = mesh.inputVertex(mesh.sideStart(s)), b = mesh.inputVertex(mesh.sideEnd(s));
    edges.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(edges.begin(), edges.end());
  // Vertices of the file that were joined have one name.
  const auto standIn = [&](Index v) {
    return v < mesh.input().positions.size() ? mesh.standIn(v) : v;
  };
  EdgeHints hints = state.document().hints;
  for (std::size_t i = 0; i + 1 < inputVertices.size(); ++i) {
    const auto [a, b] = std::pair(standIn(inputVertices[i]), standIn(inputVertices[i + 1]));
    if (!isEdge(edges, a, b)) {
      throw Refusal("The model has no edge between vertices " + std::to_string(inputVertices[i]) +
                    " and " + std::to_string(inputVertices[i + 1]) + '.');
    }
    if (brush != HintBrush::Erase) {
      addHint(hints, a, b, brush == HintBrush::Cut ? HintKind::Cut : HintKind::Never);
      continue;
    }
    std::erase_if(hints, [&](const EdgeHint& hint) {
      return hint.a == std::min(a, b) && hint.b == std::max(a, b);
    });
  }
  if (hints == state.document().hints) return;
  change(state, std::move(hints), brush == HintBrush::Erase ? "Erase hints" : "Paint hints");
}

void clearHints(AppState& state) {
  if (state.document().hints.empty()) throw Refusal("No edge has a hint.");
  change(state, {}, "Clear hints");
}

}  // namespace chartflood
