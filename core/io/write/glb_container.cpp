#include "core/io/write/glb_container.h"

#include <array>
#include <limits>

#include <glm/common.hpp>

#include "core/base/error.h"
#include "core/io/text/text_blocks.h"

namespace chartflood {

namespace {

// Numbers that the specification gives to OpenGL's constants.
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr const char* kFloat3 = R"("componentType":5126,"type":"VEC3")";
constexpr const char* kFloat2 = R"("componentType":5126,"type":"VEC2")";
constexpr const char* kFloat1 = R"("componentType":5126,"type":"SCALAR")";
constexpr const char* kWhole = R"("componentType":5125,"type":"SCALAR")";

void addElement(std::string& list, const std::string& element) {
  if (!list.empty()) list += ",";
  list += element;
}

std::string vectorJson(const glm::vec3& p) {
  std::string text = "[";
  std::array<char, kLongestReal> digits;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) text += ",";
    // As a double: the text then names the single-precision number exactly.
    text.append(digits.data(), writeReal(digits.data(), p[axis]));
  }
  return text + "]";
}

void appendWord(std::string& bytes, std::size_t value) {
  char word[4];
  writeRaw(word, static_cast<std::uint32_t>(value));
  bytes.append(word, 4);
}

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

void pad(std::string& bytes, char filler) { bytes.resize(padded(bytes.size()), filler); }

}  // namespace

int GlbContainer::addView(const void* bytes, std::size_t size, int target) {
  std::string view = "{\"buffer\":0,\"byteOffset\":" + std::to_string(bufferSize_) +
                     ",\"byteLength\":" + std::to_string(size);
  if (target != 0) view += ",\"target\":" + std::to_string(target);
  addElement(views_, view + "}");
  content_.emplace_back(static_cast<const char*>(bytes), size);
  bufferSize_ += padded(size);
  return static_cast<int>(content_.size()) - 1;
}

int GlbContainer::addAccessor(int view, const char* componentAndType, std::size_t count,
                              const std::string& bounds) {
  addElement(accessors_, "{\"bufferView\":" + std::to_string(view) + ",\"count\":" +
                             std::to_string(count) + "," + componentAndType + bounds + "}");
  return accessorCount_++;
}

void GlbContainer::name(std::string_view attribute, int accessor) {
  addElement(attributes_, "\"" + std::string(attribute) + "\":" + std::to_string(accessor));
}

int GlbContainer::addIndices(std::span<const std::uint32_t> indices) {
  const int view = addView(indices.data(), indices.size_bytes(), kElementArrayBuffer);
  return addAccessor(view, kWhole, indices.size(), "");
}

void GlbContainer::addAttribute(std::string_view attribute, std::span<const glm::vec3> values,
                                bool bounds) {
  const int view = addView(values.data(), values.size_bytes(), kArrayBuffer);
  std::string range;
  if (bounds) {
    glm::vec3 low(std::numeric_limits<float>::max()), high(-std::numeric_limits<float>::max());
    for (const glm::vec3& p : values) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    range = ",\"min\":" + vectorJson(low) + ",\"max\":" + vectorJson(high);
  }
  name(attribute, addAccessor(view, kFloat3, values.size(), range));
}

void GlbContainer::addAttribute(std::string_view attribute, std::span<const glm::vec2> values) {
  const int view = addView(values.data(), values.size_bytes(), kArrayBuffer);
  name(attribute, addAccessor(view, kFloat2, values.size(), ""));
}

void GlbContainer::addAttribute(std::string_view attribute, std::span<const float> values) {
  const int view = addView(values.data(), values.size_bytes(), kArrayBuffer);
  name(attribute, addAccessor(view, kFloat1, values.size(), ""));
}

std::string GlbContainer::finish(int indices, std::string_view texturePng) {
  std::string texture, color;
  if (!texturePng.empty()) {
    const int view = addView(texturePng.data(), texturePng.size(), 0);
    texture = R"(,"images":[{"mimeType":"image/png","bufferView":)" + std::to_string(view) +
              R"(}],"textures":[{"source":0}])";
    color = R"("baseColorTexture":{"index":0},)";
  }
  std::string json =
      R"({"asset":{"version":"2.0","generator":"chartflood"},"scene":0,"scenes":[{"nodes":[0]}],)"
      R"("nodes":[{"mesh":0,"name":"charts"}],"meshes":[{"name":"charts","primitives":[)"
      R"({"attributes":{)" +
      attributes_ + R"(},"indices":)" + std::to_string(indices) +
      R"(,"material":0}]}],"materials":[{"name":"charts","doubleSided":true,)"
      R"("pbrMetallicRoughness":{)" +
      color + R"("metallicFactor":0,"roughnessFactor":0.8}}])" + texture + R"(,"accessors":[)" +
      accessors_ + R"(],"bufferViews":[)" + views_ + R"(],"buffers":[{"byteLength":)" +
      std::to_string(bufferSize_) + "}]}";
  pad(json, ' ');
  const std::size_t size = 12 + 8 + json.size() + 8 + bufferSize_;
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw Error("Could not write GLB: the file would be larger than 4 GB, which it cannot be; "
                "write OBJ or PLY instead.");
  }
  std::string bytes;
  bytes.reserve(size);
  bytes += "glTF";
  for (const std::size_t word : {std::size_t{2}, size, json.size()}) appendWord(bytes, word);
  bytes += "JSON" + json;
  appendWord(bytes, bufferSize_);
  bytes += std::string_view("BIN\0", 4);
  for (const std::string_view view : content_) {
    bytes += view;
    // The head is a multiple of 4 long.
    pad(bytes, '\0');
  }
  return bytes;
}

}  // namespace chartflood
