#include "core/session/pipeline/document.h"

#include <algorithm>

namespace chartflood {

std::vector<Index> seedFaces(std::span<const PlacedSeed> seeds) {
  std::vector<Index> faces;
  for (const PlacedSeed& seed : seeds) faces.push_back(seed.face);
  return faces;
}

std::vector<Index> lockedFaces(std::span<const PlacedSeed> seeds) {
  std::vector<Index> faces;
  for (const PlacedSeed& seed : seeds) {
    if (seed.locked) faces.push_back(seed.face);
  }
  return faces;
}

void dropNewestUnlocked(std::vector<PlacedSeed>& seeds, std::size_t wanted) {
  std::size_t toDrop = seeds.size() > wanted ? seeds.size() - wanted : 0;
  for (std::size_t i = seeds.size(); i-- > 0 && toDrop > 0;) {
    if (seeds[i].locked) continue;
    seeds.erase(seeds.begin() + static_cast<std::ptrdiff_t>(i));
    --toDrop;
  }
}

Document withFittingSeeds(const Document& before, Document document) {
  if (document.parameters.rngSeed != before.parameters.rngSeed) {
    std::erase_if(document.seeds, [](const PlacedSeed& seed) { return !seed.locked; });
  }
  if (document.parameters.charts < before.parameters.charts) {
    dropNewestUnlocked(document.seeds, static_cast<std::size_t>(document.parameters.charts));
  }
  return document;
}

Index meshFace(const Mesh& mesh, Index inputFace) {
  // Faces keep their order, so the numbers in the file ascend.
  Index low = 0, high = static_cast<Index>(mesh.faceCount());
  while (low < high) {
    const Index middle = low + (high - low) / 2;
    if (mesh.inputFace(middle) < inputFace) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  const bool found = low < mesh.faceCount() && mesh.inputFace(low) == inputFace;
  return found ? low : kNone;
}

}  // namespace chartflood
