#include "core/segment/borders/crease_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/index.h"

namespace chartflood {

namespace {

/// Edges of a line. Of the length of sharp edges, chains of as many hold 8 % on a rough scan (a
/// statue of 20,000 triangles) and 84 to 100 % on machine parts.
constexpr std::size_t kLineEdges = 8;
/// Length of a line of fewer edges, in square roots of its part's surface: coarse models have few
/// edges a crease. On the rough scan 1 % of the length is in longer chains.
constexpr double kLineLength = 0.15;
constexpr double kChainCosine = -0.5;  // between edges of a chain: they turn by 60 degrees at most
/// Edges of a net, more than go around one face, and for each of its dead ends. Nets of machine
/// parts have none or one for 60 edges and more, those of rough scans one for 15 and fewer.
constexpr std::size_t kNetEdges = 4, kEdgesToDeadEnd = 20;
/// Sharp edges at a vertex from which it is a tip, through which nothing goes on.
constexpr std::size_t kTipEdges = 9;

/// The chains of the sharp edges, and what they are.
class CreaseChains {
 public:
  CreaseChains(const Mesh& mesh, const GaussArea& gauss)
      : mesh_(mesh), sharp_(gauss.sharpEdges), next_(sharp_.size(), {kNone, kNone}) {
    listEnds();
    for (std::size_t i = 0; i < ends_.size();) {
      std::size_t end = i + 1;
      while (end < ends_.size() && ends_[end].vertex == ends_[i].vertex) ++end;
      join(std::span(ends_).subspan(i, end - i));
      i = end;
    }
    follow();
  }

  std::vector<std::uint8_t> lines() const {
    const std::vector<std::uint8_t> line = lineChains();
    // Length of chains by what they are, of each part.
    std::vector<std::array<double, 2>> length(mesh_.componentCount(), {0.0, 0.0});
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      length[partOf(chains_[c])][line[c]] += chains_[c].length;
    }
    std::vector<std::uint8_t> flag(sharp_.size());
    for (std::size_t i = 0; i < sharp_.size(); ++i) {
      const auto [rest, lines] = length[partOf(chains_[chain_[i]])];
      flag[i] = line[chain_[i]] != 0 || rest <= lines;
    }
    return flag;
  }

 private:
  /// Where a sharp edge ends.
  struct End {
    Index vertex;
    Index edge;  ///< place in sharp_
  };
  struct Chain {
    std::size_t edges = 0;
    double length = 0;
    Index first = 0;  ///< one of its edges
  };
  /// Two edges that may go on in each other.
  struct Pair {
    double cosine;  ///< of the angle between them: -1 is straight on
    Index a, b;
    bool operator<(const Pair& o) const {
      return cosine != o.cosine ? cosine < o.cosine : a != o.a ? a < o.a : b < o.b;
    }
  };

  Index partOf(const Chain& chain) const {
    return mesh_.faceComponent()[mesh_.faceOf(sharp_[chain.first] / 3)];
  }

  /// 1 for each chain that is a line.
  std::vector<std::uint8_t> lineChains() const {
    std::vector<double> area(mesh_.componentCount(), 0);
    for (Index t = 0; t < mesh_.triangleCount(); ++t) {
      area[mesh_.faceComponent()[mesh_.faceOf(t)]] += mesh_.triangleArea()[t];
    }
    const std::vector<std::uint8_t> net = nets();
    std::vector<std::uint8_t> line(chains_.size(), 0);
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      const Chain& chain = chains_[c];
      line[c] = chain.edges >= kLineEdges || net[chain.first] != 0 ||
                chain.length >= kLineLength * std::sqrt(area[partOf(chain)]);
    }
    return line;
  }

  /// 1 for each sharp edge of a net, a connected set that has hardly any dead ends.
  std::vector<std::uint8_t> nets() const {
    std::vector<std::uint8_t> flag(sharp_.size(), 0);
    std::vector<std::uint8_t> seen(sharp_.size(), 0);
    std::vector<Index> set;
    for (Index first = 0; first < sharp_.size(); ++first) {
      if (std::exchange(seen[first], std::uint8_t{1}) != 0) continue;
      set.assign(1, first);
      std::size_t deadEnds = 0;
      for (std::size_t i = 0; i < set.size(); ++i) {
        for (const Index v : {mesh_.sideStart(sharp_[set[i]]), mesh_.sideEnd(sharp_[set[i]])}) {
          const std::span<const End> meeting = endsAt(v);
          // A crease may end where the surface does.
          deadEnds += meeting.size() == 1 && mesh_.opposite()[mesh_.vertexSide()[v]] != kNone;
          for (const End& end : meeting) {
            if (std::exchange(seen[end.edge], std::uint8_t{1}) == 0) set.push_back(end.edge);
          }
        }
      }
      if (set.size() < kNetEdges || kEdgesToDeadEnd * deadEnds > set.size()) continue;
      for (const Index edge : set) flag[edge] = 1;
    }
    return flag;
  }

  std::span<const End> endsAt(Index vertex) const {
    const auto before = [](const End& a, const End& b) { return a.vertex < b.vertex; };
    const auto [begin, end] = std::equal_range(ends_.begin(), ends_.end(), End{vertex, 0}, before);
    return {begin, end};
  }

  void listEnds() {
    ends_.reserve(2 * sharp_.size());
    for (Index i = 0; i < sharp_.size(); ++i) {
      ends_.push_back({mesh_.sideStart(sharp_[i]), i});
      ends_.push_back({mesh_.sideEnd(sharp_[i]), i});
    }
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
      return a.vertex != b.vertex ? a.vertex < b.vertex : a.edge < b.edge;
    });
  }

  int sideOf(Index edge, Index vertex) const {
    return mesh_.sideStart(sharp_[edge]) == vertex ? 0 : 1;
  }
  Index otherEnd(Index edge, Index vertex) const {
    return sideOf(edge, vertex) == 0 ? mesh_.sideEnd(sharp_[edge]) : mesh_.sideStart(sharp_[edge]);
  }
  glm::dvec3 from(Index vertex, Index edge) const {
    const auto positions = mesh_.positions();
    const glm::dvec3 way = positions[otherEnd(edge, vertex)] - positions[vertex];
    const double length = glm::length(way);
    return length > 0 ? way / length : way;
  }

  /// Pairs the sharp edges that meet at a vertex, straightest first.
  void join(std::span<const End> ends) {
    if (ends.size() >= kTipEdges) return;
    const Index vertex = ends.front().vertex;
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t j = i + 1; j < ends.size(); ++j) {
        const double cosine = glm::dot(from(vertex, ends[i].edge), from(vertex, ends[j].edge));
        if (ends.size() == 2 || cosine < kChainCosine) {
          pairs.push_back({cosine, ends[i].edge, ends[j].edge});
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [cosine, a, b] : pairs) {
      Index& ofA = next_[a][static_cast<std::size_t>(sideOf(a, vertex))];
      Index& ofB = next_[b][static_cast<std::size_t>(sideOf(b, vertex))];
      if (ofA != kNone || ofB != kNone) continue;
      ofA = b;
      ofB = a;
    }
  }

  void follow() {
    chain_.assign(sharp_.size(), kNone);
    for (Index first = 0; first < sharp_.size(); ++first) {
      if (chain_[first] != kNone) continue;
      Chain chain;
      chain.first = first;
      add(first, chain);
      for (const Index v : {mesh_.sideStart(sharp_[first]), mesh_.sideEnd(sharp_[first])}) {
        walk(first, v, chain);
      }
      chains_.push_back(chain);
    }
  }

  void add(Index edge, Chain& chain) {
    const auto positions = mesh_.positions();
    chain_[edge] = static_cast<Index>(chains_.size());
    ++chain.edges;
    chain.length += glm::length(positions[mesh_.sideStart(sharp_[edge])] -
                                positions[mesh_.sideEnd(sharp_[edge])]);
  }

  /// Takes what goes on at a vertex of an edge, as far as it is not taken.
  void walk(Index edge, Index vertex, Chain& chain) {
    while (true) {
      edge = next_[edge][static_cast<std::size_t>(sideOf(edge, vertex))];
      if (edge == kNone || chain_[edge] != kNone) return;
      add(edge, chain);
      vertex = otherEnd(edge, vertex);
    }
  }

  const Mesh& mesh_;
  const std::vector<Index>& sharp_;
  std::vector<End> ends_;                   ///< by vertex
  std::vector<std::array<Index, 2>> next_;  ///< of each sharp edge: what goes on at start and end
  std::vector<Index> chain_;                ///< of each sharp edge
  std::vector<Chain> chains_;
};

}  // namespace

std::vector<std::uint8_t> creaseLines(const Mesh& mesh, const GaussArea& gauss) {
  if (gauss.sharpEdges.empty()) return {};
  return CreaseChains(mesh, gauss).lines();
}

}  // namespace chartflood
