#include "app/host/actions/seed_edits.h"

#include <algorithm>
#include <cstdint>

#include "app/host/script/action.h"

namespace chartflood {

namespace {

using Seeds = std::vector<PlacedSeed>;

std::string seedName(std::size_t seed) { return "seed " + std::to_string(seed); }

const Mesh& requireMesh(const AppState& state) {
  if (!state.hasMesh()) throw Refusal("There is no model yet; open one first.");
  return *state.results().mesh;
}

Seeds requireSeed(const AppState& state, std::size_t seed) {
  requireMesh(state);
  Seeds seeds = state.presentSeeds();
  if (seeds.empty()) throw Refusal("There are no seeds yet; press Play.");
  if (seed >= seeds.size()) {
    throw Refusal("There is no seed " + std::to_string(seed) + "; seeds are 0 to " +
                  std::to_string(seeds.size() - 1) + '.');
  }
  return seeds;
}

void requireFree(const Mesh& mesh, const Seeds& seeds, Index face) {
  if (face >= mesh.faceCount()) throw Refusal("The model has no such face.");
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    if (seeds[i].face == face) {
      throw Refusal("Seed " + std::to_string(i) + " is on this face already.");
    }
  }
}

/// Each separate part of a model needs a seed: the method would place another one there.
void requireOther(const Mesh& mesh, const Seeds& seeds, std::size_t seed) {
  const auto component = mesh.faceComponent();
  const Index part = component[seeds[seed].face];
  const auto there = std::count_if(seeds.begin(), seeds.end(), [&](const PlacedSeed& each) {
    return component[each.face] == part;
  });
  if (there < 2) throw Refusal("This part of the model has no other seed and needs one.");
}

/// Makes `seeds` the document's own, with as many charts.
void change(AppState& state, Seeds seeds, std::string name, const std::string& key,
            bool dragging = false) {
  Document document = state.document();
  askCharts(document.parameters, static_cast<int>(seeds.size()));
  document.seeds = std::move(seeds);
  state.playback.follow();
  state.changeDocument(document, std::move(name), key, dragging);
}

/// The same without a change of the number of charts: the charts stay as they are.
void changeLocks(AppState& state, Seeds seeds, std::string name) {
  Document document = state.document();
  document.seeds = std::move(seeds);
  state.changeDocument(document, std::move(name), "locks", false);
}

/// The next number of a fixed sequence, so that a roll can be repeated.
int rolled(int seed) {
  return static_cast<int>((static_cast<std::uint64_t>(seed) * 48271u + 12345u) % 100000u);
}

}  // namespace

void addSeed(AppState& state, Index face) {
  const Mesh& mesh = requireMesh(state);
  Seeds seeds = state.presentSeeds();
  if (seeds.empty()) throw Refusal("There are no seeds yet; press Play.");
  requireFree(mesh, seeds, face);
  const std::size_t number = seeds.size();
  seeds.push_back({face});
  change(state, std::move(seeds), "Add " + seedName(number), "add-seed");
}

void moveSeed(AppState& state, std::size_t seed, Index face, bool dragging) {
  Seeds seeds = requireSeed(state, seed);
  const Mesh& mesh = requireMesh(state);
  if (seeds[seed].face != face) {
    requireFree(mesh, seeds, face);
    const auto component = mesh.faceComponent();
    if (component[face] != component[seeds[seed].face]) requireOther(mesh, seeds, seed);
  }
  seeds[seed].face = face;
  change(state, std::move(seeds), "Move " + seedName(seed), "move-" + seedName(seed), dragging);
}

void deleteSeed(AppState& state, std::size_t seed) {
  Seeds seeds = requireSeed(state, seed);
  if (seeds.size() == 1) throw Refusal("The last seed stays: there is always one chart.");
  requireOther(requireMesh(state), seeds, seed);
  seeds.erase(seeds.begin() + static_cast<std::ptrdiff_t>(seed));
  state.hoveredSeed = kNone;  // the later ones have new numbers
  if (state.chosenSeed != kNone && state.chosenSeed >= seed && state.chosenSeed > 0) {
    --state.chosenSeed;
  }
  change(state, std::move(seeds), "Delete " + seedName(seed), "delete-seed");
}

void lockSeed(AppState& state, std::size_t seed, std::optional<bool> on) {
  Seeds seeds = requireSeed(state, seed);
  const bool locked = on.value_or(!seeds[seed].locked);
  if (locked == seeds[seed].locked) return;
  seeds[seed].locked = locked;
  changeLocks(state, std::move(seeds), (locked ? "Lock " : "Unlock ") + seedName(seed));
}

void clearLocks(AppState& state) {
  requireMesh(state);
  Seeds seeds = state.presentSeeds();
  const bool any =
      std::any_of(seeds.begin(), seeds.end(), [](const PlacedSeed& seed) { return seed.locked; });
  if (!any) throw Refusal("No seed is locked.");
  for (PlacedSeed& seed : seeds) seed.locked = false;
  changeLocks(state, std::move(seeds), "Clear locks");
}

void spreadSeeds(AppState& state) {
  requireMesh(state);
  Document document = state.document();
  document.parameters.rngSeed = rolled(document.parameters.rngSeed);
  state.playback.follow();
  state.changeDocument(document, "Spread seeds", "spread-seeds", false);
}

std::string seedOptions(const AppState& state) {
  const Mesh& mesh = requireMesh(state);
  const Seeds seeds = state.presentSeeds();
  if (seeds.empty()) throw Refusal("There are no seeds yet; press Play.");
  std::string faces;
  for (const PlacedSeed& seed : seeds) {
    faces += (faces.empty() ? "" : ",") + std::to_string(mesh.inputFace(seed.face));
  }
  return "--charts=" + std::to_string(seeds.size()) + " --seeds=" + faces;
}

}  // namespace chartflood
