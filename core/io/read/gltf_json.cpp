#include "core/io/read/gltf_json.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/io/read/json_depth.h"

namespace chartflood {

namespace {

using nlohmann::json;

constexpr int kDeepest = 200;  // of nested values: glTF has 8, its "extras" may have more

bool standsOn(const json& part, std::string_view extension) {
  const auto extensions = part.find("extensions");
  return extensions != part.end() && extensions->is_object() && extensions->contains(extension);
}

bool standsOnAnyOf(const json& owner, const char* list, std::string_view extension) {
  const auto parts = owner.find(list);
  if (parts == owner.end() || !parts->is_array()) return false;
  return std::any_of(parts->begin(), parts->end(), [&](const json& part) {
    return part.is_object() &&
           (standsOn(part, extension) || standsOnAnyOf(part, "primitives", extension));
  });
}

json parse(const Source& source, std::string_view text) {
  if (const char* place = tooDeepInJson(text, kDeepest)) {
    source.failAtByte(place, "the JSON is nested too deeply");
  }
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    const std::size_t at = std::clamp<std::size_t>(error.byte, 1, text.size() + 1) - 1;
    source.failAtByte(text.data() + at, "it is not valid glTF: its JSON is broken there");
  } catch (const json::exception&) {
    source.fail("it is not valid glTF: its JSON has a number that is too large");
  }
}

}  // namespace

GltfJson::GltfJson(const Source& source, const json& value, std::string where)
    : source_(source), json_(value), where_(std::move(where)) {
  if (!json_.is_object()) fail("is no JSON object");
}

void GltfJson::fail(const std::string& cause) const {
  source_.fail("it is not valid glTF: " + (where_.empty() ? "the file" : where_) + " " + cause);
}

bool GltfJson::has(const char* key) const { return json_.contains(key); }

bool GltfJson::holdsObject(const char* key) const { return has(key) && at(key).is_object(); }

const json& GltfJson::at(const char* key) const { return *json_.find(key); }

std::size_t GltfJson::wholeNumber(const json& value, const char* key) const {
  // Some exporters write every number with a point.
  constexpr double kExact = 9007199254740992;  // 2^53
  if (value.is_number_unsigned()) return value.get<std::size_t>();
  if (value.is_number_float()) {
    const double number = value.get<double>();
    if (number >= 0 && number <= kExact && number == std::floor(number)) {
      return static_cast<std::size_t>(number);
    }
  }
  fail(std::string("has a ") + key + " that is no whole number from 0 on");
}

std::size_t GltfJson::count(const char* key, std::size_t otherwise) const {
  return has(key) ? wholeNumber(at(key), key) : otherwise;
}

bool GltfJson::flag(const char* key) const {
  return has(key) && at(key).is_boolean() && at(key).get<bool>();
}

std::string GltfJson::text(const char* key) const {
  if (!has(key)) return "";
  if (!at(key).is_string()) fail(std::string("has a ") + key + " that is no text");
  return at(key).get<std::string>();
}

std::string GltfJson::textOrNumber(const char* key) const {
  if (!has(key)) return "";
  if (at(key).is_number()) return at(key).dump();
  return at(key).is_string() ? at(key).get<std::string>() : "";
}

std::vector<std::string> GltfJson::texts(const char* key) const {
  std::vector<std::string> values;
  if (!has(key) || !at(key).is_array()) return values;
  for (const json& value : at(key)) {
    if (value.is_string()) values.push_back(value.get<std::string>());
  }
  return values;
}

std::vector<double> GltfJson::numbers(const char* key) const {
  std::vector<double> values;
  if (!has(key)) return values;
  if (!at(key).is_array()) fail(std::string("has a ") + key + " that is no list of numbers");
  values.reserve(at(key).size());
  for (const json& value : at(key)) {
    const bool finite = value.is_number() && std::isfinite(value.get<double>());
    if (!finite) fail(std::string("has a ") + key + " with a value that is no finite number");
    values.push_back(value.get<double>());
  }
  return values;
}

std::vector<std::size_t> GltfJson::counts(const char* key) const {
  std::vector<std::size_t> values;
  if (!has(key)) return values;
  if (!at(key).is_array()) fail(std::string("has ") + key + " that are no list");
  values.reserve(at(key).size());
  for (const json& value : at(key)) values.push_back(wholeNumber(value, key));
  return values;
}

GltfJson GltfJson::part(const char* key) const {
  static const json kNothing = json::object();
  const std::string where = where_.empty() ? key : std::string(key) + " of " + where_;
  return {source_, has(key) ? at(key) : kNothing, where};
}

std::vector<GltfJson> GltfJson::list(const char* key, const char* each) const {
  std::vector<GltfJson> parts;
  if (!has(key)) return parts;
  if (!at(key).is_array()) fail(std::string("has ") + key + " that are no list");
  parts.reserve(at(key).size());
  for (const json& value : at(key)) {
    std::string where = each + (" " + std::to_string(parts.size()));
    if (!where_.empty()) where += " of " + where_;
    parts.emplace_back(source_, value, std::move(where));
  }
  return parts;
}

bool GltfJson::standsOnAny(const char* list, std::string_view extension) const {
  return standsOnAnyOf(json_, list, extension);
}

GltfJsonFile::GltfJsonFile(const Source& source, std::string_view text)
    : source_(source), json_(std::make_unique<const json>(parse(source, text))) {}

GltfJsonFile::~GltfJsonFile() = default;

GltfJson GltfJsonFile::all() const { return {source_, *json_, ""}; }

}  // namespace chartflood
