// Lines, discs and seeds on the model.

#include <algorithm>

#include "render/passes/renderer.h"
#include "render/passes/renderer_colors.h"
#include "render/passes/texture_units.h"

namespace chartflood {

void Renderer::drawSegments(const Frame& frame, std::size_t count, const glm::vec2& widths,
                            const glm::vec4& color, float dash, std::size_t first) {
  if (count == 0) return;
  gl::Program& program = lineProgram_;
  program.set("uSegments", static_cast<int>(units::kValues));
  program.set("uFirst", static_cast<int>(first));
  program.set("uDash", dash);
  program.set("uWidths", widths * frame.settings.pixelScale);
  program.set("uColor", color);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * count));
}

void Renderer::drawCuts(const Frame& frame, const std::vector<Index>& triangleOf, float width) {
  const std::vector<Index>& hidden = frame.settings.hiddenCharts;
  const auto seen = [&](std::size_t i) {
    const Index chart = charts_->chartOf(triangleOf[i]);
    return std::find(hidden.begin(), hidden.end(), chart) == hidden.end();
  };
  for (std::size_t first = 0; first < triangleOf.size();) {
    std::size_t end = first + 1;
    const bool draws = seen(first);
    while (end < triangleOf.size() && seen(end) == draws) ++end;
    if (draws) {
      drawSegments(frame, end - first, glm::vec2(width + 1.6f), colors::kInk, 0, first);
      drawSegments(frame, end - first, glm::vec2(width), colors::kCut, frame.dash, first);
    }
    first = end;
  }
}

/// Lines of the marks, where the picture has them; the program of lines must be in use.
void Renderer::drawMarkLines(const Frame& frame) {
  if (!frame.settings.problems || !marks_) return;
  for (const MarkLayer::Lines& line : marks_->lines()) {
    if (frame.inTexture)
      line.inTexture.bind(units::kValues);
    else
      line.edges.bind(units::kValues);
    const std::size_t count = frame.inTexture ? line.inTextureCount : line.edges.edges().size();
    drawSegments(frame, count, glm::vec2(line.look.width + 2), colors::kInk);
    drawSegments(frame, count, glm::vec2(line.look.width), glm::vec4(line.look.color, 1),
                 line.look.dashed ? frame.dash : 0);
  }
}

void Renderer::drawLines(const Frame& frame) {
  const RenderSettings& settings = frame.settings;
  const ColorMode mode = canShow(settings.colorMode) ? settings.colorMode : ColorMode::Shaded;
  using colors::kChalk, colors::kInk;
  constexpr glm::vec4 kByValue(0);
  glEnable(GL_DEPTH_TEST);
  glBindVertexArray(emptyVertexArray_.id());
  lineProgram_.use();
  setEye(lineProgram_, frame.eye);
  setScale(lineProgram_, ScalarRange{}, settings);
  const ColorMode onEdges = modeOfElement(mode, ValueDomain::Edge);
  const bool valued = colorModeInfo(onEdges).domain == ValueDomain::Edge;
  if (settings.sharpEdges && gauss_ && !valued) {
    gauss_->bindEdges(units::kValues);
    drawSegments(frame, gauss_->edgeCount(), glm::vec2(1.4f), kChalk);
  }
  if (settings.seams) {
    const glm::vec2 width(settings.seamWidth);
    if (settings.playhead) {
      flood_->bindSeams(units::kValues);
      drawSegments(frame, flood_->seamCount(*settings.playhead), width, kInk);
    } else {
      charts_->bindSeams(units::kValues);
      charts_->bindColors(units::kChartColors);
      lineProgram_.set("uByCharts", settings.hiddenCharts.empty() ? 0 : 1);
      lineProgram_.set("uChartColors", static_cast<int>(units::kChartColors));
      drawSegments(frame, charts_->seamCount(), width, kInk);
      lineProgram_.set("uByCharts", 0);
    }
  }
  if (settings.cuts && cuts_ && !settings.playhead) {
    cuts_->bind(units::kValues);
    drawCuts(frame, cuts_->triangle(), settings.cutWidth);
  }
  drawMarkLines(frame);
  for (const LineLayer& line : lines_) {
    line.edges.bind(units::kValues);
    const std::size_t count = line.edges.edges().size();
    drawSegments(frame, count, glm::vec2(line.look.width + 1.6f), kInk);
    drawSegments(frame, count, glm::vec2(line.look.width), glm::vec4(line.look.color, 1),
                 line.look.dashed ? frame.dash : 0);
  }
  if (valued) {
    setScale(lineProgram_, onEdges == mode ? *scalarRange(settings) : valuesOf(onEdges).range,
             settings);
    gauss_->bindEdges(units::kValues);
    // All dark outlines lie under all colours, or they would cut the chain into pieces.
    drawSegments(frame, gauss_->edgeCount(), {3.2f, 6.2f}, kInk);
    drawSegments(frame, gauss_->edgeCount(), {1.6f, 4.4f}, kByValue);
  }
}

void Renderer::drawMarks(const Frame& frame) {
  const RenderSettings& settings = frame.settings;
  const ColorMode mode = canShow(settings.colorMode) ? settings.colorMode : ColorMode::Shaded;
  gl::Program& program = pointProgram_;
  const float scale = settings.pixelScale;
  glBindVertexArray(emptyVertexArray_.id());
  program.use();
  setEye(program, frame.eye);
  program.set("uPoints", static_cast<int>(units::kValues));
  program.set("uOpacity", 1.0f);
  const ColorMode onVertices = modeOfElement(mode, ValueDomain::Vertex);
  if (colorModeInfo(onVertices).domain == ValueDomain::Vertex) {
    setScale(program, onVertices == mode ? *scalarRange(settings) : valuesOf(onVertices).range,
             settings);
    gauss_->bindVertices(units::kValues);
    program.set("uByValue", 1);
    program.set("uBall", 0);
    program.set("uRing", 1.1f * scale);
    program.set("uRadii", glm::vec2(2.6f, 7.0f) * scale);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * gauss_->vertexCount()));
  }
  if (!settings.seedMarks || !scene_.seeds || scene_.seeds->empty()) return;
  setScale(program, ScalarRange{}, settings);
  uploadSeeds(settings);
  seeds_.bind(units::kValues);
  program.set("uByValue", 0);
  program.set("uBall", 1);
  program.set("uRing", 1.5f * scale);
  program.set("uRadii", glm::vec2(settings.seedRadius) * scale);
  // Seeds behind the model shine through faintly; those in front cover it.
  const auto count = static_cast<GLsizei>(6 * (uploadedSeeds_.size() / 2));
  glDepthFunc(GL_GREATER);
  program.set("uOpacity", 0.14f);
  glDrawArrays(GL_TRIANGLES, 0, count);
  glDepthFunc(GL_LEQUAL);
  program.set("uOpacity", 1.0f);
  glDrawArrays(GL_TRIANGLES, 0, count);
}

void Renderer::uploadSeeds(const RenderSettings& settings) {
  std::vector<glm::vec4> texels;
  const std::vector<Index>& hidden = settings.hiddenCharts;
  for (const SeedMark& seed : *scene_.seeds) {
    if (std::find(hidden.begin(), hidden.end(), seed.chart) != hidden.end()) continue;
    texels.emplace_back(glm::vec3(faceMiddle(*mesh_, seed.face)), 0.0f);
    texels.emplace_back(chartColor(seed.chart, settings), (seed.emphasis ? 1.0f : 0.0f) +
                                                              (seed.locked ? 2.0f : 0.0f) +
                                                              (seed.closed ? 4.0f : 0.0f));
  }
  if (texels == uploadedSeeds_) return;
  seeds_.upload<glm::vec4>(GL_RGBA32F, texels);
  uploadedSeeds_ = std::move(texels);
}

}  // namespace chartflood
