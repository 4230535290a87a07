#include "app/cli/compare_options.h"

#include <string>
#include <vector>

#include "app/cli/values.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

/// Reads "a,b,..", each one of the choices.
std::vector<std::string> readChoices(const Tokens& tokens, const std::string& option,
                                     const std::vector<std::string>& choices) {
  std::vector<std::string> read;
  std::string rest = tokens.text(option);
  for (std::size_t comma = 0; comma != std::string::npos;) {
    comma = rest.find(',');
    read.push_back(readChoice(option, rest.substr(0, comma), choices));
    if (comma != std::string::npos) rest.erase(0, comma + 1);
  }
  return read;
}

void refuseOthers(const Tokens& tokens, const Invocation& call) {
  for (const char* other :
       {"method", "steps", "iterations", "export-labels", "export-mesh", "export-uv",
        "export-seams", "save-session", "turntable", "flood-film"}) {
    if (tokens.has(other)) {
      throw UsageError("--compare and --" + std::string(other) +
                       " exclude each other: leave one out.");
    }
  }
  if (call.session) throw UsageError("--compare needs a mesh, not a session: give its mesh.");
}

}  // namespace

void readCompare(const Tokens& tokens, Invocation& call) {
  if (!tokens.has("compare")) return;
  std::vector<std::string> methods;
  for (const ParameterChoice& choice : findParameter("method")->choices) {
    methods.push_back(choice.id);
  }
  call.compare = readChoices(tokens, "compare", methods);
  refuseOthers(tokens, call);
  if (!tokens.has("color-by")) return;
  for (const std::string& mode : readChoices(tokens, "color-by", colorModeIds())) {
    call.compareRows.push_back(findColorMode(mode)->mode);
  }
  call.picture.settings.colorMode = call.compareRows.front();
}

}  // namespace chartflood
