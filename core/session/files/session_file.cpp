#include "core/session/files/session_file.h"

#include <algorithm>

namespace chartflood {

namespace {

std::vector<Index> inputFaces(const Mesh& mesh, const std::vector<Index>& faces) {
  std::vector<Index> result;
  result.reserve(faces.size());
  for (const Index face : faces) result.push_back(mesh.inputFace(face));
  return result;
}

bool distinct(std::vector<Index> faces) {
  std::sort(faces.begin(), faces.end());
  return std::adjacent_find(faces.begin(), faces.end()) == faces.end();
}

}  // namespace

bool isSessionFile(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  return ending == kSessionEnding;
}

SessionFile sessionOf(const SessionModel& model, const Document& document, const Results& results) {
  SessionFile session;
  const Mesh& mesh = *results.mesh;
  session.model = model;
  session.parameters = document.parameters;
  for (const PlacedSeed& seed : document.seeds) {
    session.seeds.push_back({mesh.inputFace(seed.face), seed.locked});
  }
  session.hints = document.hints;
  session.charts = momentOf(results);
  session.charts.start.seeds = inputFaces(mesh, session.charts.start.seeds);
  return session;
}

SessionContent sessionContent(const SessionFile& session, const Mesh& mesh,
                              const std::string& checksum) {
  SessionContent content;
  content.document.parameters = session.parameters;
  for (const EdgeHint& hint : session.hints) {
    // Vertices that were joined have one name, whichever the session knows them by.
    const auto name = [&](Index v) {
      return v < mesh.input().positions.size() ? mesh.standIn(v) : v;
    };
    addHint(content.document.hints, name(hint.a), name(hint.b), hint.kind);
  }
  const std::string& wanted = session.model.checksum;
  const bool changed = !wanted.empty() && !checksum.empty() && wanted != checksum;
  if (changed) {
    content.warnings.push_back(mesh.input().file +
                               " was changed since the session was saved; its charts are made "
                               "anew and seeds may lie elsewhere.");
  }
  std::size_t lost = 0;
  for (const PlacedSeed& seed : session.seeds) {
    const Index face = meshFace(mesh, seed.face);
    const auto& seeds = content.document.seeds;
    const bool twice = std::any_of(seeds.begin(), seeds.end(),
                                   [&](const PlacedSeed& other) { return other.face == face; });
    if (face == kNone || twice) {
      ++lost;
    } else {
      content.document.seeds.push_back({face, seed.locked});
    }
  }
  if (lost > 0) {
    content.warnings.push_back(std::to_string(lost) +
                               (lost == 1 ? " seed is no face" : " seeds are no faces") +
                               " of this model and " + (lost == 1 ? "was" : "were") + " left out.");
  }
  if (changed || lost > 0) return content;
  content.moment = session.charts;
  for (Index& face : content.moment.start.seeds) face = meshFace(mesh, face);
  const auto& faces = content.moment.start.seeds;
  if (std::find(faces.begin(), faces.end(), kNone) != faces.end() || !distinct(faces)) {
    content.moment = {};
  }
  return content;
}

}  // namespace chartflood
