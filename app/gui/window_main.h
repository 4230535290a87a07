#pragma once
/// Opens the viewer on a file or a sample and runs it to its end.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/window.h"
#include "core/session/files/session_io.h"
#include "core/session/session.h"
#include "render/scene/render_settings.h"

namespace chartflood {

struct WindowOptions {
  Parameters parameters;
  std::vector<Index> seeds;     ///< faces of the input file; empty: placed by the method
  std::filesystem::path hints;  ///< painted edges; "": none
  std::filesystem::path file;   ///< "": the sample
  std::string sample = "rocket";
  std::size_t triangles = 0;           ///< of the sample; 0: its own number
  std::optional<SessionFile> session;  ///< to go on with; `parameters` and `render` win over it
  std::filesystem::path sessionFile;   ///< where it was read from
  /// Names and values of preferences that hold this time.
  std::vector<std::pair<std::string, std::string>> preferences;
  RenderSettings render;
  std::optional<UpAxis> up;  ///< nothing: the likely one of the model
  bool orthographic = false;
};

/// Returns the program's exit code. Reads the user's preferences and writes them at the end.
/// The variables CHARTFLOOD_PROBE_FILE and CHARTFLOOD_FRAME_LOG name the files of WindowWatch.
/// \throws Error when no window can be opened
int runWindow(const WindowOptions& options);

}  // namespace chartflood
