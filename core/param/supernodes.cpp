#include "core/param/supernodes.h"

#include <algorithm>

namespace chartflood {

namespace {

/// Share of a front's entries that may be zeros, by its number of columns: fronts of few columns
/// cost more to handle than to fill.
double mostZeros(std::size_t columns) {
  return columns <= 4 ? 0.9 : columns <= 16 ? 0.3 : columns <= 48 ? 0.1 : 0.05;
}

/// Entries of columns on and below the diagonal.
double entriesOf(std::size_t columns, std::size_t below) {
  const double c = static_cast<double>(columns), b = static_cast<double>(below);
  return c * (c + 1) / 2 + c * b;
}

/// First columns of runs, and the number of columns at the end.
std::vector<Index> firstColumns(const EliminationTree& tree) {
  const auto size = static_cast<Index>(tree.parent.size());
  struct Run {
    Index first, end;
    double zeros;
  };
  std::vector<Run> runs;
  for (Index k = 0; k < size; ++k) {
    const bool same = k > 0 && tree.parent[k - 1] == k && tree.count[k - 1] == tree.count[k] + 1;
    if (same) {
      runs.back().end = k + 1;
    } else {
      runs.push_back({k, k + 1, 0});
    }
    // Join runs that are whole: the next column does not go on with the last.
    const bool whole =
        k + 1 == size || tree.parent[k] != k + 1 || tree.count[k] != tree.count[k + 1] + 1;
    while (whole && runs.size() > 1) {
      Run& child = runs[runs.size() - 2];
      const Run& last = runs.back();
      if (tree.parent[child.end - 1] < last.first || tree.parent[child.end - 1] >= last.end) break;
      const std::size_t columns = last.end - child.first;
      const std::size_t below = tree.count[last.end - 1];
      const double joined = entriesOf(columns, below);
      const double zeros =
          joined - (entriesOf(child.end - child.first, tree.count[child.end - 1]) - child.zeros) -
          (entriesOf(last.end - last.first, below) - last.zeros);
      if (zeros > mostZeros(columns) * joined) break;
      child.end = last.end;
      child.zeros = zeros;
      runs.pop_back();
    }
  }
  std::vector<Index> first;
  first.reserve(runs.size() + 1);
  for (const Run& run : runs) first.push_back(run.first);
  first.push_back(size);
  return first;
}

}  // namespace

EliminationTree eliminationTree(std::span<const Index> columnStart, std::span<const Index> row) {
  const auto size = static_cast<Index>(columnStart.size() - 1);
  EliminationTree tree{std::vector<Index>(size, kNone), std::vector<Index>(size, 0)};
  std::vector<Index> mark(size, kNone);
  for (Index k = 0; k < size; ++k) {
    mark[k] = k;
    for (Index entry = columnStart[k]; entry < columnStart[k + 1]; ++entry) {
      for (Index i = row[entry]; mark[i] != k; i = tree.parent[i]) {
        if (tree.parent[i] == kNone) tree.parent[i] = k;
        ++tree.count[i];
        mark[i] = k;
      }
    }
  }
  return tree;
}

std::vector<Index> postorder(const EliminationTree& tree) {
  const auto size = static_cast<Index>(tree.parent.size());
  std::vector<Index> firstChild(size, kNone), sibling(size, kNone), order, stack;
  for (Index k = size; k-- > 0;) {  // children of each ascending
    if (tree.parent[k] == kNone) continue;
    sibling[k] = firstChild[tree.parent[k]];
    firstChild[tree.parent[k]] = k;
  }
  order.reserve(size);
  for (Index root = 0; root < size; ++root) {
    if (tree.parent[root] != kNone) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const Index top = stack.back();
      if (const Index child = firstChild[top]; child != kNone) {
        firstChild[top] = sibling[child];
        stack.push_back(child);
      } else {
        order.push_back(top);
        stack.pop_back();
      }
    }
  }
  return order;
}

Supernodes findSupernodes(const EliminationTree& tree, std::span<const Index> columnStart,
                          std::span<const Index> row) {
  Supernodes nodes;
  nodes.first = firstColumns(tree);
  const auto size = static_cast<Index>(tree.parent.size());
  const auto count = static_cast<Index>(nodes.first.size() - 1);
  nodes.parent.assign(count, kNone);
  nodes.rowBegin.assign(1, 0);
  std::vector<Index> nodeOf(size), mark(size, kNone);
  for (Index s = 0; s < count; ++s) {
    for (Index k = nodes.first[s]; k < nodes.first[s + 1]; ++k) nodeOf[k] = s;
  }
  std::vector<Index> lastChild(count, kNone), before(count, kNone);  // lists of children
  for (Index s = 0; s < count; ++s) {
    const Index end = nodes.first[s + 1];
    const auto add = [&](Index place) {
      if (place < end || mark[place] == s) return;
      mark[place] = s;
      nodes.row.push_back(place);
    };
    for (Index e = columnStart[nodes.first[s]]; e < columnStart[end]; ++e) add(row[e]);
    for (Index child = lastChild[s]; child != kNone; child = before[child]) {
      const std::size_t childEnd = nodes.rowBegin[child + 1];
      for (std::size_t r = nodes.rowBegin[child]; r < childEnd; ++r) add(nodes.row[r]);
    }
    const std::size_t begin = nodes.rowBegin.back();
    std::sort(nodes.row.begin() + static_cast<std::ptrdiff_t>(begin), nodes.row.end());
    nodes.rowBegin.push_back(nodes.row.size());
    if (nodes.row.size() == begin) continue;
    const Index parent = nodeOf[nodes.row[begin]];
    nodes.parent[s] = parent;
    before[s] = lastChild[parent];
    lastChild[parent] = s;
  }
  return nodes;
}

}  // namespace chartflood
