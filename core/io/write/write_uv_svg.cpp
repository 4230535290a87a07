#include "core/io/write/write_uv_svg.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/charts/chart_surface.h"
#include "core/io/text/text_blocks.h"
#include "core/io/write/label_point.h"

namespace chartflood {

namespace {

constexpr int kDefaultSize = 1024;
constexpr std::uint32_t kGrey = 0xB0B0B0;

void appendNumber(std::string& text, double value) {
  std::array<char, kLongestReal> digits;
  const double rounded = std::round(value * 1000) / 1000 + 0.0;  // -0 becomes 0
  text.append(digits.data(), writeReal(digits.data(), rounded));
}

std::string colorText(std::uint32_t color) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text = "#";
  for (int shift = 20; shift >= 0; shift -= 4) text += kDigits[(color >> shift) & 15u];
  return text;
}

/// Black, or white where the ground is dark (Rec. 709 luma).
const char* inkOn(std::uint32_t ground) {
  const auto part = [&](int shift) { return static_cast<double>((ground >> shift) & 255u) / 255; };
  return 0.2126 * part(16) + 0.7152 * part(8) + 0.0722 * part(0) < 0.4 ? "#ffffff" : "#000000";
}

class SvgWriter {
 public:
  SvgWriter(const ChartedMesh& charted, const UvSvgOptions& options)
      : m_(charted), options_(options), size_(options.size) {
    if (size_ <= 0)
      size_ = charted.atlas.textureSize > 0 ? charted.atlas.textureSize : kDefaultSize;
  }

  std::string write() const;

 private:
  std::string head() const;
  std::string group(std::size_t chart) const;
  Outline outline(std::size_t chart) const;
  std::string path(const Outline& outline) const;
  std::string number(std::size_t chart, const Outline& outline) const;
  std::uint32_t color(std::size_t chart) const {
    return chart < options_.colors.size() ? options_.colors[chart] : kGrey;
  }

  const ChartedMesh& m_;
  const UvSvgOptions& options_;
  int size_;
};

std::string SvgWriter::write() const {
  std::vector<std::string> groups(m_.chartCount());
  parallelFor(groups.size(), [&](std::size_t c) {
    if (!m_.uv(c).empty()) groups[c] = group(c);
  });
  std::string text = head();
  for (const std::string& one : groups) text += one;
  return text + "</g>\n</svg>\n";
}

std::string SvgWriter::head() const {
  const std::string size = std::to_string(size_);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" height=\"" +
                     size + "\" viewBox=\"0 0 " + size + " " + size + "\">\n" +
                     "<rect id=\"frame\" width=\"" + size + "\" height=\"" + size + "\" fill=\"" +
                     (options_.transparent ? "none" : "#ffffff") +
                     "\" stroke=\"#808080\" stroke-width=\"2\"/>\n" +
                     "<g stroke=\"#202020\" stroke-linejoin=\"round\" stroke-width=\"";
  appendNumber(text, options_.lineWidth);
  return text + "\" font-family=\"sans-serif\" text-anchor=\"middle\">\n";
}

std::string SvgWriter::group(std::size_t chart) const {
  const Outline shape = outline(chart);
  std::string text = "<g id=\"" + chartName(static_cast<Index>(chart)) + "\" fill=\"" +
                     (options_.fill ? colorText(color(chart)) : "none") + "\">\n" + path(shape);
  if (options_.numbers) text += number(chart, shape);
  return text + "</g>\n";
}

/// In pixels, y downwards.
Outline SvgWriter::outline(std::size_t chart) const {
  const ChartSurface& s = m_.surface(chart);
  const std::span<const glm::dvec2> uv = m_.uv(chart);
  Outline shape;
  for (const std::vector<Index>& loop : boundaryLoops(s)) {
    std::vector<glm::dvec2>& points = shape.emplace_back();
    for (const Index side : loop) {
      const glm::dvec2& p = uv[s.sideStart(side)];
      points.emplace_back(size_ * p.x, size_ * (1 - p.y));
    }
  }
  return shape;
}

std::string SvgWriter::path(const Outline& shape) const {
  std::string text = "<path fill-rule=\"evenodd\" d=\"";
  for (const auto& loop : shape) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      text += i == 0 ? 'M' : 'L';
      appendNumber(text, loop[i].x);
      text += ' ';
      appendNumber(text, loop[i].y);
    }
    text += 'Z';
  }
  return text + "\"/>\n";
}

std::string SvgWriter::number(std::size_t chart, const Outline& shape) const {
  const LabelPoint place = labelPoint(shape);
  if (!(place.room > 0)) return "";
  const std::string digits = std::to_string(chart);
  // A digit is about 0.6 of the letters' height wide.
  const double widest = 2 * place.room / std::hypot(0.6 * static_cast<double>(digits.size()), 0.75);
  const double height = std::min(0.9 * widest, size_ / 32.0);
  std::string text = std::string("<text fill=\"") +
                     (options_.fill ? inkOn(color(chart)) : "#000000") +
                     "\" stroke=\"none\" font-size=\"";
  appendNumber(text, height);
  text += "\" x=\"";
  appendNumber(text, place.at.x);
  text += "\" y=\"";
  appendNumber(text, place.at.y + 0.36 * height);
  return text + "\">" + digits + "</text>\n";
}

}  // namespace

std::string uvSvgText(const ChartedMesh& charted, const UvSvgOptions& options) {
  return SvgWriter(charted, options).write();
}

}  // namespace chartflood
