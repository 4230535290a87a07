#include "core/base/spelling.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace chartflood {

namespace {

/// Insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// (optimal string alignment).
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, previous(b.size() + 1), current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({previous[j] + 1, current[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) current[j] = std::min(current[j], before[j - 2] + 1);
    }
    before = previous;
    std::swap(previous, current);
  }
  return previous[b.size()];
}

/// How far a candidate is: first by edits, where a word that was cut short counts as one, then by
/// all its edits.
std::pair<std::size_t, std::size_t> distance(std::string_view word, std::string_view candidate) {
  constexpr std::size_t kShortestStart = 3;
  const std::size_t edits = editDistance(word, candidate);
  const bool start = word.size() >= kShortestStart && candidate.starts_with(word);
  return {start ? std::min<std::size_t>(edits, 1) : edits, edits};
}

}  // namespace

std::string nearestSpelling(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::size_t kFar = std::numeric_limits<std::size_t>::max();
  std::pair best{kFar, kFar};
  std::string nearest;
  for (const std::string& candidate : candidates) {
    const auto found = distance(word, candidate);
    if (found >= best) continue;
    best = found;
    nearest = candidate;
  }
  const std::size_t limit = std::max<std::size_t>(1, word.size() / 3);
  return best.first <= limit && best.first < word.size() ? nearest : "";
}

}  // namespace chartflood
