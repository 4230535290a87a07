#pragma once
/// Charts on the graphics card: label of each triangle, colour and value of each chart, seams.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/model/mesh.h"
#include "core/model/segmentation.h"
#include "render/gl/objects.h"
#include "render/scene/chart_palette.h"
#include "render/scene/render_settings.h"

namespace chartflood {

class ChartLayer {
 public:
  /// Starts without charts.
  explicit ChartLayer(std::shared_ptr<const Mesh> mesh);

  /// Makes room for these charts and gives them colours; setLabels() gives their labels.
  void setSegmentation(const Segmentation& segmentation);
  /// One a face, or none: colours stay.
  void setLabels(std::span<const Index> label);
  /// Makes room for charts known by their seeds alone and gives them colours.
  void setSeeds(std::span<const glm::dvec3> places);
  /// Makes room for at least so many charts.
  void growTo(std::size_t chartCount);
  /// Gives the first charts these numbers of colours, which they keep as long as neighbours differ.
  void paint(std::span<const Index> numbers);
  std::span<const Index> colorNumbers() const { return colorNumber_; }
  /// Uploads colours, states and values for a picture where they changed. `longestTime` holds each
  /// chart's last local time; `values` may know fewer charts.
  void update(const RenderSettings& settings, std::span<const float> longestTime,
              std::span<const float> values);

  std::size_t chartCount() const { return colorNumber_.size(); }
  /// Chart of a triangle, kNone while it has none.
  Index chartOf(std::size_t triangle) const { return label_[triangle]; }
  /// sRGB in [0, 1].
  glm::vec3 chartColor(Index chart, const std::string& palette) const;
  std::size_t seamCount() const { return seamCount_; }

  void bindLabels(GLuint unit) const { labels_.bind(unit); }
  void bindColors(GLuint unit) const { colors_.bind(unit); }
  void bindValues(GLuint unit) const { values_.bind(unit); }
  /// Two texels an edge: (start, chart), (end, chart across).
  void bindSeams(GLuint unit) const { seams_.bind(unit); }

 private:
  void recolor(std::span<const ChartPair> neighbours);
  void uploadSeams();

  std::shared_ptr<const Mesh> mesh_;
  bool labelled_ = false;
  std::vector<Index> label_;        // of each triangle
  std::vector<Index> colorNumber_;  // of each chart, in the default palette
  std::size_t seamCount_ = 0;
  std::vector<glm::vec4> uploadedColors_;
  std::vector<glm::vec2> uploadedValues_;
  gl::TextureBuffer labels_, colors_, values_, seams_;
};

}  // namespace chartflood
