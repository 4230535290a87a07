#pragma once
/// What a session file holds, as plain values: everything that is needed to go on with a piece of
/// work another day.

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/model/mesh.h"
#include "core/session/session.h"

namespace chartflood {

/// The ending of session files.
inline constexpr const char* kSessionEnding = ".chartflood";

/// True for a name that ends in kSessionEnding, whatever the case.
bool isSessionFile(const std::filesystem::path& file);

/// Where the model of a session comes from: a mesh file, or a sample that the program makes.
struct SessionModel {
  std::filesystem::path file;  ///< "": a sample
  std::string checksum;        ///< of the file, "" when not known
  std::string sample;
  std::size_t triangles = 0;  ///< asked of the sample; 0: its own number

  bool operator==(const SessionModel&) const = default;
};

/// One setting of the view; the meaning of its name is the reader's business.
using SessionValue = std::variant<bool, double, std::string, std::vector<double>>;

/// What a session file holds. Faces are those of the input file, so that they mean the same
/// whatever the program drops or splits.
struct SessionFile {
  SessionModel model;
  Parameters parameters;
  std::vector<PlacedSeed> seeds;
  EdgeHints hints;
  FloodMoment charts;
  std::map<std::string, SessionValue> view;
  /// The session file that this one continues when it was saved by itself; "": none.
  std::filesystem::path continues;
  /// Where the file lies: other files that it names, beside the model, must be there or below.
  std::filesystem::path folder;
  std::string unknown;                ///< JSON of what this version does not know, written back
  std::vector<std::string> warnings;  ///< sentences of reading: what was left out
};

/// What is open, as a session. \pre results.mesh is there
SessionFile sessionOf(const SessionModel& model, const Document& document, const Results& results);

/// Document and charts of a session on its mesh.
struct SessionContent {
  Document document;
  FloodMoment moment;
  std::vector<std::string> warnings;  ///< what does not fit the mesh
};
/// Seeds that are no faces of the mesh are left out. When the mesh's checksum is another than the
/// session's, or any face of the charts is not there, the charts are left out.
SessionContent sessionContent(const SessionFile& session, const Mesh& mesh,
                              const std::string& checksum);

}  // namespace chartflood
