#pragma once
/// Edits of the hints: where seams are welcome and where they are to stay away.

#include <span>

#include "app/host/state/hint_stroke.h"

namespace chartflood {

class AppState;

/// Paints the edges between each vertex of the input file and the next, as one step of undo.
/// \throws Refusal where two of them have no edge
void paintHints(AppState& state, HintBrush brush, std::span<const Index> inputVertices);
/// Takes all hints away. \throws Refusal without any
void clearHints(AppState& state);

}  // namespace chartflood
