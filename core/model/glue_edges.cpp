#include "core/model/glue_edges.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace chartflood {

namespace {

constexpr std::size_t kVertexBlock = 1 << 14;

/// What a block of vertices has to say.
struct BlockFindings : GlueFindings {
  std::vector<Index> slits;
};

struct SideEntry {
  Index larger;
  Index side;
};

/// Sides without an opposite one, listed by their smaller vertex.
struct SideLists {
  std::vector<Index> start;
  std::vector<SideEntry> entries;
};

SideLists listSides(const MeshData& d, std::size_t vertexCount) {
  const std::size_t sides = d.opposite.size();
  const auto endpoints = [&](std::size_t side) {
    const auto& t = d.triangles[side / 3];
    return std::pair<Index, Index>(t[side % 3], t[(side + 1) % 3]);
  };
  SideLists lists;
  lists.start.assign(vertexCount + 1, 0);
  for (std::size_t s = 0; s < sides; ++s) {
    if (d.opposite[s] != kNone) continue;
    const auto [a, b] = endpoints(s);
    ++lists.start[std::min(a, b) + 1];
  }
  for (std::size_t v = 0; v < vertexCount; ++v) lists.start[v + 1] += lists.start[v];
  lists.entries.resize(lists.start[vertexCount]);
  std::vector<Index> next(lists.start.begin(), lists.start.end() - 1);
  for (std::size_t s = 0; s < sides; ++s) {
    if (d.opposite[s] != kNone) continue;
    const auto [a, b] = endpoints(s);
    lists.entries[next[std::min(a, b)]++] = {std::max(a, b), static_cast<Index>(s)};
  }
  return lists;
}

/// Glues the sides of one vertex's list.
void glueList(MeshData& d, Index vertex, SideEntry* begin, SideEntry* end, BlockFindings& found) {
  std::sort(begin, end, [](const SideEntry& x, const SideEntry& y) {
    return x.larger != y.larger ? x.larger < y.larger : x.side < y.side;
  });
  for (SideEntry* run = begin; run < end;) {
    SideEntry* stop = run + 1;
    while (stop < end && stop->larger == run->larger) ++stop;
    if (stop - run == 2) {
      const Index first = run[0].side, second = run[1].side;
      const bool forward0 = d.triangles[first / 3][first % 3] == vertex;
      const bool forward1 = d.triangles[second / 3][second % 3] == vertex;
      if (forward0 != forward1) {
        d.opposite[first] = second;
        d.opposite[second] = first;
        if (isWithinFace(d, first, second)) found.slits.insert(found.slits.end(), {first, second});
      } else {
        found.conflicts.emplace_back(first, second);
      }
    } else if (stop - run > 2) {
      ++found.nonManifoldEdges;
      for (const SideEntry* e = run; e < stop; ++e) found.nonManifoldSides.push_back(e->side);
    }
    run = stop;
  }
}

}  // namespace

GlueFindings glueEdges(MeshData& d, std::size_t vertexCount) {
  SideLists lists = listSides(d, vertexCount);
  const std::size_t blocks = (vertexCount + kVertexBlock - 1) / kVertexBlock;
  std::vector<BlockFindings> ofBlock(blocks);
  parallelFor(blocks, [&](std::size_t block) {
    const std::size_t last = std::min((block + 1) * kVertexBlock, vertexCount);
    for (std::size_t v = block * kVertexBlock; v < last; ++v) {
      glueList(d, static_cast<Index>(v), lists.entries.data() + lists.start[v],
               lists.entries.data() + lists.start[v + 1], ofBlock[block]);
    }
  });
  GlueFindings found;
  for (const BlockFindings& part : ofBlock) {
    found.nonManifoldEdges += part.nonManifoldEdges;
    found.nonManifoldSides.insert(found.nonManifoldSides.end(), part.nonManifoldSides.begin(),
                                  part.nonManifoldSides.end());
    d.slits.insert(d.slits.end(), part.slits.begin(), part.slits.end());
    found.conflicts.insert(found.conflicts.end(), part.conflicts.begin(), part.conflicts.end());
  }
  std::sort(found.nonManifoldSides.begin(), found.nonManifoldSides.end());
  std::sort(found.conflicts.begin(), found.conflicts.end());
  return found;
}

}  // namespace chartflood
