#pragma once
/// From the words of the command line to what is to be done.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/base/log.h"
#include "core/session/files/session_io.h"
#include "core/session/settings/parameters.h"
#include "render/scene/camera.h"
#include "render/scene/render_settings.h"
#include "render/scene/uv_camera.h"

namespace chartflood {

/// Where the picture is taken from. What is absent comes from the view that shows the whole model.
struct CameraOptions {
  std::optional<glm::dvec3> direction, viewUp;     ///< not zero
  std::optional<glm::dvec3> position, focalPoint;  ///< model units
  std::optional<double> viewAngle;                 ///< degrees, in (0, 170]
  double zoomFactor = 1;                           ///< > 0
  double azimuthAngle = 0, elevationAngle = 0;     ///< degrees
  bool orthographic = false;
  std::optional<UpAxis> up;     ///< nothing: the likely one of the model
  bool given = false;           ///< any of the above was written
  std::optional<Camera> saved;  ///< of the session; counts where nothing was written
};

/// What the picture shows, and how large.
struct PictureOptions {
  enum class View { Model, Uv, Both };
  View view = View::Model;
  bool backgroundGiven = false;  ///< --background was written
  RenderSettings settings;
  int width = 1280, height = 960;    ///< pixels
  int supersampling = 2;             ///< samples a pixel in each direction
  double lineScale = 0;              ///< of lines and letters; 0: by the picture's size
  std::vector<Index> chartColors;    ///< that the charts begin with, see Renderer::setChartColors()
  std::optional<UvCamera> uvCamera;  ///< nothing: the whole texture
  UvStyle uv;
  CameraOptions camera;
  std::size_t turntable = 0;  ///< pictures of a whole turn; 0: a single picture
  std::size_t floodFilm = 0;  ///< pictures of the last flood; 0: a single picture
};

/// One call of the program.
struct Invocation {
  enum class Task { Window, Batch, Info, Help, Version, ListSamples, ListColormaps, ListBindings };
  Task task = Task::Window;

  std::filesystem::path file;  ///< "": the sample
  std::string sample = kFirstSample;
  std::size_t triangles = 0;  ///< of the sample; 0: its own number

  std::optional<SessionFile> session;  ///< the input is a session with this content
  std::filesystem::path sessionFile;   ///< where it was read from; "": from a picture
  std::vector<std::string> warnings;   ///< about its view, or a preset

  Parameters parameters;
  bool chartsGiven = false;          ///< --charts was written
  bool findsCharts = false;          ///< --charts=auto
  std::filesystem::path hints;       ///< painted edges; "": none
  std::vector<Index> seeds;          ///< faces of the input file; empty: placed by the method
  std::optional<std::size_t> steps;  ///< faces of the first flood
  std::optional<std::size_t> iterations;

  std::filesystem::path output;        ///< picture; "": none
  std::filesystem::path exportLabels;  ///< "": none
  std::filesystem::path exportMesh;    ///< .obj, .ply or .glb; "": none
  std::filesystem::path exportUv;      ///< .png or .svg; "": none
  std::filesystem::path exportSeams;   ///< .obj; "": none
  std::filesystem::path saveSession;   ///< "": none
  std::vector<std::string> compare;    ///< methods to run side by side; empty: the one asked for
  std::vector<ColorMode> compareRows;  ///< of their pictures, one row each; empty: a single one
  bool overwrite = false;              ///< results may replace the file that they are made from
  std::string report;                  ///< file name, "-" for standard output, "": none
  PictureOptions picture;

  /// Names and values of preferences that hold this time.
  std::vector<std::pair<std::string, std::string>> preferences;

  LogLevel verbose = LogLevel::Warning;
  unsigned threads = 0;  ///< 0: one a core
  std::string renderingBackend = "auto";

  static constexpr const char* kFirstSample = "rocket";
};

/// The files that the call writes, in the order of its members.
std::vector<std::filesystem::path> outputFiles(const Invocation& call);

/// Reads the words after the program's name. \throws UsageError
Invocation readOptions(std::span<const std::string> words);

}  // namespace chartflood
