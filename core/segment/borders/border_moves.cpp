#include "core/segment/borders/border_moves.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/segment/borders/bordered_charts.h"
#include "core/segment/borders/crease_lines.h"
#include "core/segment/parts/chart_areas.h"

namespace chartflood {

namespace {

constexpr std::size_t kBlock = 1 << 14;  // faces or triangles; whole words of the active set

/// What mu = 1 counts in a clean-up of 70,000 faces. Tuned with 20 charts, as a sum over charts.
constexpr double kCleanUp = 20 * 20;

/// Mean length of the edges, 0 without any.
double meanEdgeLength(const Mesh& mesh) {
  const auto positions = mesh.positions();
  std::vector<double> sums((mesh.triangleCount() + kBlock - 1) / kBlock, 0);
  parallelBlocks(mesh.triangleCount(), kBlock, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (Index s = static_cast<Index>(3 * begin); s < 3 * end; ++s) {
      if (mesh.edgeOfSide(s) != s) continue;
      sum += glm::length(positions[mesh.sideStart(s)] - positions[mesh.sideEnd(s)]);
    }
    sums[begin / kBlock] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(mesh.edgeCount());
}

}  // namespace

/// What a move adds up. Few sides are ever asked about, so what they have is not tabled.
struct BorderMoves::Tables {
  const Mesh& mesh;
  const GaussArea& gauss;
  const Options options;
  double unit;  ///< of lengths, normalised units; 0 when there is none
  std::span<const double> faceGauss;
  std::vector<std::uint8_t> line;   ///< of each sharp edge: 1 where it is part of a line
  std::vector<double> vertexGauss;  ///< empty when no vertex has Gauss area

  double faceArea(Index face) const {
    double area = 0;
    for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
      area += mesh.triangleArea()[t];
    }
    return area;
  }
  /// Gauss area plus eta times area.
  double faceValue(Index face) const { return faceGauss[face] + options.eta * faceArea(face); }
  /// Entry of the side's edge among the sharp ones, kNone for others.
  Index sharpEdge(Index side) const {
    const Index edge = mesh.edgeOfSide(side);
    const auto found = std::lower_bound(gauss.sharpEdges.begin(), gauss.sharpEdges.end(), edge);
    const bool sharp = found != gauss.sharpEdges.end() && *found == edge;
    return sharp ? static_cast<Index>(found - gauss.sharpEdges.begin()) : kNone;
  }
  double sideGauss(Index side) const {
    const Index sharp = sharpEdge(side);
    return sharp == kNone ? 0.0 : gauss.edge[sharp];
  }
  /// Crease-weighted, in the unit.
  double sideLength(Index side) const {
    const auto positions = mesh.positions();
    float length = static_cast<float>(
        glm::length(positions[mesh.sideStart(side)] - positions[mesh.sideEnd(side)]));
    if (unit > 0) {
      length = static_cast<float>(static_cast<double>(length) / unit);
      const Index sharp = sharpEdge(side);
      if (sharp != kNone && line[sharp] != 0) {
        length = static_cast<float>(static_cast<double>(length) * options.creaseFactor);
      }
    }
    if (!options.sideFactor.empty()) length *= static_cast<float>(options.sideFactor[side]);
    return static_cast<double>(length);
  }
};

/// A face's change of chart and what it does.
struct BorderMoves::Move {
  Index to = kNone;
  double length = 0;  ///< change of the seam length term
  double loss = 0;    ///< what the old chart loses
  double gain = 0;    ///< what the new chart gains
};

namespace {

/// Sides of a face against other faces or the mesh border, in a cycle; false when they are not one
/// cycle.
bool boundarySides(const Mesh& mesh, Index face, std::vector<Index>& sides) {
  sides.clear();
  const Index begin = 3 * mesh.triangleBegin(face), end = 3 * mesh.triangleBegin(face + 1);
  if (end - begin == 3) {
    sides.assign({begin, begin + 1, begin + 2});
    return true;
  }
  const auto opposite = mesh.opposite();
  const auto outer = [&](Index s) {
    return opposite[s] == kNone || mesh.faceOf(opposite[s] / 3) != face;
  };
  std::size_t count = 0;
  Index first = kNone;
  for (Index s = begin; s < end; ++s) {
    if (!outer(s)) continue;
    ++count;
    if (first == kNone) first = s;
  }
  if (first == kNone) return false;
  Index side = first;
  do {
    sides.push_back(side);
    side = Mesh::nextSide(side);
    while (!outer(side)) side = Mesh::nextSide(opposite[side]);
  } while (side != first && sides.size() <= count);
  return sides.size() == count;
}

/// True when the vertex is interior and every face around it but `except` has the label.
bool surroundedBy(const Mesh& mesh, std::span<const Index> label, Index vertex, Index except,
                  Index chart) {
  const Index first = mesh.vertexSide()[vertex];
  Index side = first;
  do {
    const Index face = mesh.faceOf(side / 3);
    if (face != except && label[face] != chart) return false;
    side = mesh.turn(side);
  } while (side != kNone && side != first);
  return side == first;
}

}  // namespace

BorderMoves::BorderMoves(const Mesh& mesh, const GaussArea& gauss,
                         std::span<const double> faceGauss, std::vector<Index> label,
                         std::size_t charts, std::span<const Index> seeds, const Options& options)
    : mesh_(mesh), label_(std::move(label)), fixed_(mesh.faceCount(), false),
      sweepsLeft_(options.maxSweeps), active_((mesh.faceCount() + 63) / 64, 0) {
  const double unit = options.likeCuts ? std::sqrt(mesh.surfaceArea()) : meanEdgeLength(mesh);
  auto tables = std::make_unique<Tables>(
      Tables{mesh, gauss, options, unit, faceGauss, creaseLines(mesh, gauss), {}});
  if (!gauss.corners.empty()) {
    tables->vertexGauss.assign(mesh.vertexCount(), 0);
    for (std::size_t i = 0; i < gauss.corners.size(); ++i) {
      tables->vertexGauss[gauss.corners[i]] = gauss.corner[i];
    }
  }
  tables_ = std::move(tables);
  for (const Index seed : seeds) fixed_[seed] = true;
  value_ = chartAreas(mesh, gauss, faceGauss, label_, charts).gaussArea;
  for (Index f = 0; f < label_.size(); ++f) value_[label_[f]] += options.eta * tables_->faceArea(f);
  const std::vector<std::uint8_t> bordered = borderedCharts(mesh, label_, charts);
  for (std::size_t c = 0; c < charts; ++c) {
    if (bordered[c] == 0) continue;
    ++evened_;
    sum_ += value_[c];
    squares_ += value_[c] * value_[c];
  }
  const double faces = static_cast<double>(mesh.faceCount());
  weight_ = options.weight / static_cast<double>(evened_);
  if (!options.likeCuts) weight_ *= kCleanUp * std::sqrt(faces / 70000);
  mostLonger_ = options.mostLonger < 0 ? std::numeric_limits<double>::infinity()
                                       : options.mostLonger * seamLength();
  findBorders();
}

/// Only faces at borders can move; moves put their neighbours in later.
void BorderMoves::findBorders() {
  const auto opposite = mesh_.opposite();
  parallelBlocks(mesh_.faceCount(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (Index f = static_cast<Index>(begin); f < end; ++f) {
      const Index last = 3 * mesh_.triangleBegin(f + 1);
      bool border = false;
      for (Index s = 3 * mesh_.triangleBegin(f); s < last; ++s) {
        border =
            border || (opposite[s] != kNone && label_[mesh_.faceOf(opposite[s] / 3)] != label_[f]);
      }
      if (border) activate(f);
    }
  });
}

BorderMoves::~BorderMoves() = default;

bool BorderMoves::run(Progress& progress) {
  const std::size_t faces = mesh_.faceCount();
  std::size_t untilLook = 4096;
  while (sweepsLeft_ > 0) {
    while (position_ < faces) {
      const std::uint64_t word = active_[position_ / 64] >> (position_ % 64);
      if (word == 0) {
        position_ = (position_ / 64 + 1) * 64;
        continue;
      }
      position_ += static_cast<std::size_t>(std::countr_zero(word));
      if (position_ >= faces) break;
      const Index face = static_cast<Index>(position_++);
      Move move;
      if (findMove(face, move)) {
        apply(face, move);
        ++movedInSweep_;
      }
      if (--untilLook == 0) {
        untilLook = 4096;
        if (progress.cancelled()) return false;
      }
    }
    --sweepsLeft_;
    position_ = 0;
    if (std::exchange(movedInSweep_, 0) == 0) sweepsLeft_ = 0;
  }
  return true;
}

/// The face's only possible move, if it lowers the energy. Takes faces inside charts out of the
/// active set.
bool BorderMoves::findMove(Index face, Move& move) {
  const Index from = label_[face];
  const auto opposite = mesh_.opposite();
  const auto across = [&](Index side) { return label_[mesh_.faceOf(opposite[side] / 3)]; };
  const bool cycle = boundarySides(mesh_, face, sides_);
  bool border = false, meshBorder = false;
  for (const Index side : sides_) {
    meshBorder = meshBorder || opposite[side] == kNone;
    border = border || opposite[side] == kNone || across(side) != from;
  }
  if (!border) {
    active_[face / 64] &= ~(std::uint64_t{1} << (face % 64));
    return false;
  }
  if (!cycle || meshBorder || fixed_[face]) return false;

  std::size_t inside = 0, changes = 0;
  Index to = kNone;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Index chart = across(sides_[i]);
    if (chart == from) {
      ++inside;
    } else if (to == kNone) {
      to = chart;
    } else if (to != chart) {
      return false;
    }
    const Index before = across(sides_[i == 0 ? sides_.size() - 1 : i - 1]);
    changes += (before == from) != (chart == from) ? 1 : 0;
  }
  if (inside == 0 || to == kNone || changes != 2) return false;

  move.to = to;
  move.loss = move.gain = tables_->faceValue(face);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Index side = sides_[i], next = sides_[i + 1 == sides_.size() ? 0 : i + 1];
    const bool stays = across(side) == from;
    const double length = tables_->sideLength(side);
    move.length += stays ? length : -length;
    const double edge = tables_->sideGauss(side);
    (stays ? move.loss : move.gain) += edge;
    if ((across(next) == from) != stays) continue;
    const Index vertex = mesh_.sideStart(next);
    if (!surroundedBy(mesh_, label_, vertex, face, stays ? from : to)) return false;
    const double corner = tables_->vertexGauss.empty() ? 0.0 : tables_->vertexGauss[vertex];
    (stays ? move.loss : move.gain) += corner;
  }
  if (move.length > 0 && longer_ + move.length > mostLonger_) return false;
  const double a = value_[from], b = value_[to];
  const double sum = sum_ - move.loss + move.gain;
  const double squares = squares_ - a * a - b * b + (a - move.loss) * (a - move.loss) +
                         (b + move.gain) * (b + move.gain);
  double change = move.length + balanceEnergy(sum, squares) - balanceEnergy(sum_, squares_);
  const ChartPrice* price = tables_->options.price;
  if (price != nullptr) change += price->of(face, to) - price->of(face, from);
  return change < -1e-9;
}

/// The balance term from the sum and the sum of squares of the charts' values.
double BorderMoves::balanceEnergy(double sum, double squares) const {
  const double count = static_cast<double>(evened_);
  const double mean = sum / count;
  return mean > 1e-12 ? weight_ * (squares / (mean * mean) - count) : 0;
}

void BorderMoves::apply(Index face, const Move& move) {
  double& a = value_[label_[face]];
  double& b = value_[move.to];
  squares_ -= a * a + b * b;
  a -= move.loss;
  b += move.gain;
  squares_ += a * a + b * b;
  sum_ += move.gain - move.loss;
  longer_ += move.length;
  label_[face] = move.to;
  ++moves_;
  activate(face);
  for (const Index side : sides_) activate(mesh_.faceOf(mesh_.opposite()[side] / 3));
}

double BorderMoves::deviation() const {
  const double count = static_cast<double>(evened_);
  const double mean = sum_ / count;
  return mean > 1e-12 ? std::sqrt(std::max(0.0, squares_ / (mean * mean * count) - 1)) : 0;
}

double BorderMoves::seamLength() const {
  double length = 0;
  for (Index s = 0; s < mesh_.opposite().size(); ++s) {
    const Index other = mesh_.opposite()[s];
    if (other == kNone || other < s) continue;
    if (label_[mesh_.faceOf(s / 3)] == label_[mesh_.faceOf(other / 3)]) continue;
    length += tables_->sideLength(s);
  }
  return length;
}

}  // namespace chartflood
