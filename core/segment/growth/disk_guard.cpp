#include "core/segment/growth/disk_guard.h"

namespace chartflood {

namespace {

bool touches(const Mesh& mesh, Index vertex, Index chart, const std::vector<GrowthFace>& faces) {
  const Index first = mesh.vertexSide()[vertex];
  Index side = first;
  do {
    if (faces[mesh.faceOf(side / 3)].label == chart) return true;
    side = mesh.turn(side);
  } while (side != kNone && side != first);
  return false;
}

}  // namespace

bool DiskGuard::staysDisk(Index face, Index chart, const std::vector<GrowthFace>& faces) const {
  const auto opposite = mesh_.opposite();
  const auto inner = [&](Index s) {
    return opposite[s] != kNone && mesh_.faceOf(opposite[s] / 3) == face;
  };
  const Index begin = 3 * mesh_.triangleBegin(face), end = 3 * mesh_.triangleBegin(face + 1);
  Index first = begin;
  while (first < end && inner(first)) ++first;
  if (first == end) return false;
  // Once around: corner, side, corner, side; each change is an end of a shared arc.
  const auto shares = [&](Index s) {
    return opposite[s] != kNone && faces[mesh_.faceOf(opposite[s] / 3)].label == chart;
  };
  bool before = shares(first), any = before;
  std::size_t changes = 0, steps = 0;
  Index side = first;
  do {
    side = Mesh::nextSide(side);
    while (inner(side)) side = Mesh::nextSide(opposite[side]);
    for (const bool now : {touches(mesh_, mesh_.sideStart(side), chart, faces), shares(side)}) {
      changes += now != before ? 1 : 0;
      any = any || now;
      before = now;
    }
  } while (side != first && ++steps < end - begin);
  return any && changes == 2;
}

}  // namespace chartflood
