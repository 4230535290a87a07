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
#include "render/scene/scalar_range.h"

namespace chartflood {

class ChartLayer {
 public:
  /// Starts without charts.
  explicit ChartLayer(std::shared_ptr<const Mesh> mesh);

  /// Takes the labels and the Gauss areas; null removes them.
  void setSegmentation(const Segmentation* segmentation);
  /// Other labels of the same charts, one a face: colours and areas stay.
  void setLabels(std::span<const Index> label);
  /// Gauss areas of the charts at another moment, in place of those of the segmentation.
  void setBalance(std::span<const double> gaussArea);
  /// Makes room for charts known by their seeds alone and gives them colours.
  void setSeeds(std::span<const glm::dvec3> places);
  /// Makes room for at least so many charts.
  void growTo(std::size_t chartCount);
  /// Gives the first charts these numbers of colours, which they keep as long as neighbours differ.
  void paint(std::span<const Index> numbers);
  std::span<const Index> colorNumbers() const { return colorNumber_; }
  /// Uploads colours, states and values for a picture where they changed. `longestTime` holds each
  /// chart's last local time.
  void update(const RenderSettings& settings, std::span<const float> longestTime);

  std::size_t chartCount() const { return colorNumber_.size(); }
  bool labelled() const { return labelled_; }
  /// Chart of a triangle, kNone while it has none.
  Index chartOf(std::size_t triangle) const { return label_[triangle]; }
  /// sRGB in [0, 1].
  glm::vec3 chartColor(Index chart, const std::string& palette) const;
  /// Gauss areas of the charts against their mean, per cent.
  const ScalarRange& balanceRange() const { return balanceRange_; }
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
  std::vector<float> balance_;
  ScalarRange balanceRange_;
  std::size_t seamCount_ = 0;
  std::vector<glm::vec4> uploadedColors_;
  std::vector<glm::vec2> uploadedValues_;
  gl::TextureBuffer labels_, colors_, values_, seams_;
};

}  // namespace chartflood
