#pragma once
/// The container of a GLB file with one mesh of one primitive: JSON, then one buffer (glTF 2.0
/// specification, sections 3.6 and 4.4).

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace chartflood {

/// Takes note of arrays, which must stay where they are, then writes them out with their
/// description.
class GlbContainer {
 public:
  /// \returns the accessor's number
  int addIndices(std::span<const std::uint32_t> indices);
  /// With `bounds` its accessor tells the smallest and largest values.
  void addAttribute(std::string_view name, std::span<const glm::vec3> values, bool bounds);
  void addAttribute(std::string_view name, std::span<const glm::vec2> values);
  void addAttribute(std::string_view name, std::span<const float> values);

  /// The file; `texturePng` may be empty. \throws Error when it would exceed 4 GB
  std::string finish(int indices, std::string_view texturePng);

 private:
  /// The bytes become a view of the buffer. \returns its number
  int addView(const void* bytes, std::size_t size, int target);
  int addAccessor(int view, const char* componentAndType, std::size_t count,
                  const std::string& bounds);
  void name(std::string_view attribute, int accessor);

  std::vector<std::string_view> content_;  ///< of each view; each begins at a multiple of 4
  std::size_t bufferSize_ = 0;
  std::string views_, accessors_, attributes_;  ///< elements of JSON lists, with commas between
  int accessorCount_ = 0;
};

}  // namespace chartflood
