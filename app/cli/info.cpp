#include "app/cli/info.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <numbers>

#include <glm/common.hpp>

#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "core/samples/samples.h"
#include "core/session/pipeline/make_report.h"
#include "render/scene/color_map.h"

namespace chartflood {

namespace {

[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...) {
  std::va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, arguments);
  va_end(arguments);
  std::string text(static_cast<std::size_t>(std::max(length, 0)) + 1, '\0');
  std::vsnprintf(text.data(), text.size(), format, again);
  va_end(again);
  text.pop_back();
  return text;
}

/// Lengths of the bounding box's sides in model units.
glm::dvec3 boxSize(const Mesh& mesh) {
  glm::dvec3 low(1e300), high(-1e300);
  for (const auto& triangle : mesh.triangles()) {
    for (const Index vertex : triangle) {
      low = glm::min(low, mesh.positions()[vertex]);
      high = glm::max(high, mesh.positions()[vertex]);
    }
  }
  return mesh.scale() * (high - low);
}

std::string countsText(const Mesh& mesh) {
  const InputReport input = inputReport(mesh);
  const glm::dvec3 size = boxSize(mesh);
  std::string text = input.file + "\n";
  text += formatted("  faces           %zu\n", input.faces);
  text += formatted("  triangles       %zu\n", input.triangles);
  text += formatted("  vertices        %zu\n", input.vertices);
  text += formatted("  components      %zu\n", input.components);
  text += formatted("  boundary loops  %zu\n", input.boundaryLoops);
  text += formatted("  genus           %ld\n", input.genus);
  text += formatted("  size            %.6g x %.6g x %.6g, diagonal %.6g\n", size.x, size.y, size.z,
                    mesh.scale());
  return text;
}

std::string gaussText(const GaussArea& gauss) {
  std::string text = formatted("  Gauss area      %.6f sr at a sharp angle of %g degrees\n",
                               gauss.total(), gauss.sharpAngle);
  text += formatted("    vertices      %.6f sr on %zu corners\n", gauss.cornerTotal,
                    gauss.corners.size());
  text += formatted("    edges         %.6f sr on %zu sharp edges\n", gauss.edgeTotal,
                    gauss.sharpEdges.size());
  text += formatted("    triangles     %.6f sr\n", gauss.triangleTotal);
  // Rounded as printed, so that a vanishing total has no minus sign.
  const double signedTotal = std::abs(gauss.signedTotal) < 5e-7 ? 0 : gauss.signedTotal;
  text += formatted("    signed total  %.6f sr, %.6f times 4 pi\n", signedTotal,
                    signedTotal / (4 * std::numbers::pi));
  return text;
}

std::string repairsText(const Mesh& mesh) {
  if (mesh.repairs().empty()) return "  repairs         none\n";
  std::string text = "  repairs\n";
  for (const Repair& repair : mesh.repairs()) text += "    " + repair.text + "\n";
  return text;
}

}  // namespace

std::string infoText(const Results& results) {
  return countsText(*results.mesh) + gaussText(*results.gaussArea) + repairsText(*results.mesh);
}

std::string sampleList() {
  std::string text;
  for (const SampleInfo& sample : sampleTable()) {
    text +=
        formatted("%-14s %s (%zu triangles)\n", sample.id, sample.help, sample.defaultTriangles);
  }
  return text;
}

std::string colorMapList() {
  std::string text;
  for (const ColorMap& map : colorMapTable()) {
    text += formatted("%-14s %s%s\n", map.id, map.label, map.diverging ? ", diverging" : "");
  }
  return text;
}

std::string bindingList() {
  const ActionRegistry registry = makeActionRegistry();
  std::string text;
  for (const Binding& binding : registry.bindings()) {
    text += formatted("%-14s %s\n", chordText(binding.chord).c_str(), binding.line.c_str());
  }
  return text;
}

}  // namespace chartflood
