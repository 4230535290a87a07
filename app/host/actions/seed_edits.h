#pragma once
/// The hand on the algorithm: seeds added, moved, removed and locked, each an undoable step.
/// Whoever touches one seed takes over all present ones, so that the others stay where they are.
///
/// Seeds are numbered as their charts. All throw Refusal with one sentence when they cannot.

#include <optional>
#include <string>

#include "app/host/state/app_state.h"

namespace chartflood {

/// One chart more, which begins at a face of the mesh.
void addSeed(AppState& state, Index face);
/// The seed goes to a face of the mesh. While `dragging` all moves are one step.
void moveSeed(AppState& state, std::size_t seed, Index face, bool dragging);
/// One chart less; the last one stays.
void deleteSeed(AppState& state, std::size_t seed);
/// Locks or unlocks; without `on` turns it over.
void lockSeed(AppState& state, std::size_t seed, std::optional<bool> on);
void clearLocks(AppState& state);
/// Another layout of all seeds that are not locked.
void spreadSeeds(AppState& state);
/// "--charts=K --seeds=F,F,.." with faces of the file.
std::string seedOptions(const AppState& state);

}  // namespace chartflood
