#include "core/io/read/read_hints.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/file_bytes.h"
#include "core/io/text/source.h"
#include "core/io/text/text_rows.h"

namespace chartflood {

namespace {

/// All edges by the vertices of the file, ascending.
std::vector<std::pair<Index, Index>> edgesOf(const Mesh& mesh) {
  std::vector<std::pair<Index, Index>> edges;
  edges.reserve(3 * mesh.triangleCount());
  for (Index s = 0; s < 3 * mesh.triangleCount(); ++s) {
    const Index a = mesh.inputVertex(mesh.sideStart(s)), b = mesh.inputVertex(mesh.sideEnd(s));
    edges.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The vertex that the mesh knows a vertex of the file by.
Index standIn(const Mesh& mesh, std::int64_t vertex) {
  const bool exists = vertex < static_cast<std::int64_t>(mesh.input().positions.size());
  return exists ? mesh.standIn(static_cast<Index>(vertex)) : kNone;
}

}  // namespace

EdgeHints readHints(const std::filesystem::path& file, const Mesh& mesh) {
  constexpr FileLimit kLimit{std::size_t{1'000'000'000}, "a list of edges"};
  const FileBytes bytes(file, kLimit);
  const Source source{bytes.view(), file.string()};
  source.requireText("list of edges");
  const std::vector<std::pair<Index, Index>> edges = edgesOf(mesh);
  EdgeHints hints;
  TextRows rows(source, source.text(), '#');
  while (rows.next()) {
    const char* const line = rows.position();
    const std::string_view word = rows.word();
    if (word != "cut" && word != "never") {
      source.failAtLine(line,
                        "has " + quotedWord(line, source.end()) + " where cut or never is due");
    }
    const std::int64_t a = rows.integer("the number of a vertex");
    const std::int64_t b = rows.integer("the number of a vertex");
    const bool fits = std::min(a, b) >= 0 && std::max(a, b) < std::int64_t{kNone};
    auto edge = std::pair(kNone, kNone);
    if (fits) {
      const Index from = standIn(mesh, a), to = standIn(mesh, b);
      edge = {std::min(from, to), std::max(from, to)};
    }
    if (!std::binary_search(edges.begin(), edges.end(), edge)) {
      source.failAtLine(line, "names vertices " + std::to_string(a) + " and " + std::to_string(b) +
                                  ", between which the mesh has no edge");
    }
    hints.push_back({edge.first, edge.second, word == "cut" ? HintKind::Cut : HintKind::Never});
  }
  // The last of equals wins.
  std::reverse(hints.begin(), hints.end());
  std::stable_sort(hints.begin(), hints.end());
  hints.erase(
      std::unique(hints.begin(), hints.end(),
                  [](const EdgeHint& x, const EdgeHint& y) { return !(x < y) && !(y < x); }),
      hints.end());
  return hints;
}

std::string hintsText(const EdgeHints& hints) {
  std::string text;
  for (const EdgeHint& hint : hints) {
    text += (hint.kind == HintKind::Cut ? "cut " : "never ") + std::to_string(hint.a) + ' ' +
            std::to_string(hint.b) + '\n';
  }
  return text;
}

}  // namespace chartflood
