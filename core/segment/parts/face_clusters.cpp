#include "core/segment/parts/face_clusters.h"

#include <algorithm>
#include <utility>

namespace chartflood {

namespace {

/// Calls `visit(g)` for each face g across a side of f.
template <class Visit>
void forNeighbours(const Mesh& mesh, Index f, const Visit& visit) {
  const auto opposite = mesh.opposite();
  for (Index s = 3 * mesh.triangleBegin(f); s < 3 * mesh.triangleBegin(f + 1); ++s) {
    if (opposite[s] == kNone) continue;
    const Index g = mesh.faceOf(opposite[s] / 3);
    if (g != f) visit(g);
  }
}

/// Gives the cluster of each face in the queue to its unclustered neighbours in the same chart. The
/// queue is as long as there are faces to come and filled up to `filled`.
void spread(const Mesh& mesh, std::span<const Index> label, std::span<Index> cluster,
            std::span<Index> queue, std::size_t filled) {
  constexpr std::size_t kAhead = 16;  // faces between fetching and use
  for (std::size_t i = 0; i < filled; ++i) {
    if (i + kAhead < filled) {
      __builtin_prefetch(&mesh.opposite()[3 * mesh.triangleBegin(queue[i + kAhead])]);
    }
    const Index f = queue[i], own = cluster[f];
    forNeighbours(mesh, f, [&](Index g) {
      if (cluster[g] != kNone || (!label.empty() && label[g] != label[f])) return;
      cluster[g] = own;
      queue[filled++] = g;
    });
  }
}

}  // namespace

FaceClusters clusterFaces(const Mesh& mesh, std::span<const Index> label, std::size_t size,
                          std::span<const Index> alsoStarts) {
  FaceClusters clusters;
  const Index faces = static_cast<Index>(mesh.faceCount());
  clusters.ofFace.assign(faces, kNone);
  std::vector<Index> queue(faces);
  std::size_t queued = 0;
  const auto begin = [&](Index f) {
    clusters.ofFace[f] = static_cast<Index>(clusters.count++);
    clusters.start.push_back(f);
    queue[queued++] = f;
  };
  auto also = alsoStarts.begin();
  for (std::size_t f = 0; f < faces; f += size) {
    for (; also != alsoStarts.end() && *also <= f; ++also) {
      if (*also < f) begin(*also);
    }
    begin(static_cast<Index>(f));
  }
  for (; also != alsoStarts.end(); ++also) begin(*also);
  spread(mesh, label, clusters.ofFace, queue, queued);
  // Parts of charts without a start are clusters of their own.
  for (Index f = 0; f < faces; ++f) {
    if (clusters.ofFace[f] != kNone) continue;
    queued = 0;
    begin(f);
    spread(mesh, label, clusters.ofFace, queue, queued);
  }
  clusters.firstFixed = clusters.count;
  return clusters;
}

FaceClusters clusterNearSeams(const Mesh& mesh, std::span<const Index> label, std::size_t rings) {
  FaceClusters clusters;
  const Index faces = static_cast<Index>(mesh.faceCount());
  std::vector<Index> ring(faces, kNone), queue;
  for (Index f = 0; f < faces; ++f) {
    forNeighbours(mesh, f, [&](Index g) {
      if (label[g] == label[f] || ring[f] == 0) return;
      ring[f] = 0;
      queue.push_back(f);
    });
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index f = queue[i];
    if (ring[f] == rings) break;
    forNeighbours(mesh, f, [&](Index g) {
      if (ring[g] != kNone) return;
      ring[g] = ring[f] + 1;
      queue.push_back(g);
    });
  }
  clusters.ofFace.assign(faces, kNone);
  for (Index f = 0; f < faces; ++f) {
    if (ring[f] != kNone) clusters.ofFace[f] = static_cast<Index>(clusters.count++);
  }
  clusters.firstFixed = clusters.count;
  queue.resize(faces);
  for (Index f = 0; f < faces; ++f) {
    if (clusters.ofFace[f] != kNone) continue;
    clusters.ofFace[f] = static_cast<Index>(clusters.count++);
    queue[0] = f;
    spread(mesh, label, clusters.ofFace, queue, 1);
  }
  return clusters;
}

bool clustersAround(const Mesh& mesh, std::span<const Index> ofFace, Index vertex,
                    std::vector<Index>& around) {
  around.clear();
  const Index first = mesh.vertexSide()[vertex];
  if (first == kNone) return false;
  Index side = first;
  do {
    const Index cluster = ofFace[mesh.faceOf(side / 3)];
    if (std::find(around.begin(), around.end(), cluster) == around.end()) around.push_back(cluster);
    side = mesh.turn(side);
  } while (side != kNone && side != first);
  return side == first;
}

}  // namespace chartflood
