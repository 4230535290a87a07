#include "core/io/read/model_3mf.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "core/io/read/xml_reader.h"
#include "core/io/text/parse_number.h"

namespace chartflood {

namespace {

constexpr const char* kProduction = "/3dmanufacturing/production/";

/// Extensions whose geometry is read or that have none: their names are addresses.
constexpr std::array kKnownExtensions = {kProduction, "/3dmanufacturing/material/",
                                         "/3dmanufacturing/slice/",
                                         "/3dmanufacturing/trianglesets/"};
constexpr std::array kOtherShapes = {"beam", "booleanshape", "levelset", "displacementmesh"};
constexpr std::array<std::pair<const char*, double>, 6> kUnits = {{{"micron", 0.001},
                                                                   {"millimeter", 1},
                                                                   {"centimeter", 10},
                                                                   {"inch", 25.4},
                                                                   {"foot", 304.8},
                                                                   {"meter", 1000}}};

/// Calls `take` for each word of a text.
template <class Take>
void forEachWord(std::string_view text, Take take) {
  constexpr std::string_view kBlanks = " \t\r\n";
  std::size_t at = text.find_first_not_of(kBlanks);
  while (at != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    take(text.substr(at, end - at));
    at = text.find_first_not_of(kBlanks, end);
  }
}

class ModelReader : public XmlReader::Handler {
 public:
  ModelReader(const Source& source, std::string part, Model3mf& model)
      : source_(source), part_(std::move(part)), model_(model), xml_(*this) {}

  void feed(std::string_view piece, bool last) {
    const std::string problem = xml_.feed(piece, last);
    if (!problem.empty()) fail(problem);
  }
  void begin(const XmlName& name, const XmlAttributes& attributes) override;
  void end(const XmlName& name) override;

 private:
  void beginModel(const XmlAttributes& attributes);
  void beginInObject(std::string_view name, const XmlAttributes& attributes);
  Use3mf use(const XmlAttributes& attributes);
  double real(const XmlAttributes& attributes, const char* name);
  std::int64_t integer(const XmlAttributes& attributes, const char* name);
  std::string_view required(const XmlAttributes& attributes, const char* name);
  [[noreturn]] void fail(std::string_view cause) const;

  const Source& source_;
  std::string part_;
  Model3mf& model_;
  XmlReader xml_;
  std::string coreSpace_;        ///< the namespace of the outermost element
  std::size_t depth_ = 0;        ///< of the element that is open
  Object3mf* object_ = nullptr;  ///< the one that is open
};

void ModelReader::fail(std::string_view cause) const {
  source_.fail(quotedWord(part_.data(), part_.data() + part_.size()) + " line " +
               std::to_string(xml_.line()) + " " + std::string(cause));
}

std::string_view ModelReader::required(const XmlAttributes& attributes, const char* name) {
  const char* const text = attributes.find(name);
  if (text == nullptr) fail(std::string("lacks the attribute ") + name);
  return text;
}

double ModelReader::real(const XmlAttributes& attributes, const char* name) {
  double value = 0;
  std::size_t words = 0;
  forEachWord(required(attributes, name), [&](std::string_view word) {
    const char* const end = word.data() + word.size();
    const RealResult number = parseReal(word.data(), end);
    if (number.status != NumberStatus::Ok || number.end != end || ++words > 1) {
      fail("has " + quotedWord(word.data(), end) + " where a coordinate is due");
    }
    value = number.value;
  });
  if (words == 0) fail(std::string("has no number in the attribute ") + name);
  return value;
}

std::int64_t ModelReader::integer(const XmlAttributes& attributes, const char* name) {
  const std::string_view text = required(attributes, name);
  const char* const end = text.data() + text.size();
  const IntegerResult number = parseInteger(text.data(), end);
  if (number.status != NumberStatus::Ok || number.end != end) {
    fail("has " + quotedWord(text.data(), end) + " where a whole number is due");
  }
  return number.value;
}

Use3mf ModelReader::use(const XmlAttributes& attributes) {
  Use3mf use{part_, integer(attributes, "objectid")};
  if (const char* const path = attributes.find("path", kProduction); path != nullptr) {
    const std::string folder = *path == '/' ? "" : part_.substr(0, part_.rfind('/') + 1);
    use.part = ZipPackage::keyOf(folder + path);
  }
  const char* const text = attributes.find("transform");
  if (text == nullptr) return use;
  // Rows of the specification are columns here: it multiplies from the left.
  glm::length_t read = 0;
  forEachWord(text, [&](std::string_view word) {
    const char* const end = word.data() + word.size();
    const RealResult number = parseReal(word.data(), end);
    if (number.status != NumberStatus::Ok || number.end != end || read >= 12) {
      fail("has a transform that is not 12 numbers");
    }
    use.transform[read / 3][read % 3] = number.value;
    ++read;
  });
  if (read != 12) fail("has a transform that is not 12 numbers");
  return use;
}

void ModelReader::beginModel(const XmlAttributes& attributes) {
  if (const char* const unit = attributes.find("unit"); unit != nullptr) {
    for (const auto& [name, size] : kUnits) {
      if (std::string_view(unit) == name) model_.unit = size;
    }
  }
  const char* const needed = attributes.find("requiredextensions");
  if (needed == nullptr) return;
  forEachWord(needed, [&](std::string_view prefix) {
    const std::string space = xml_.namespaceOf(prefix);
    const bool known =
        std::any_of(kKnownExtensions.begin(), kKnownExtensions.end(),
                    [&](auto* name) { return space.find(name) != std::string::npos; });
    if (!known) model_.unknownExtensions.push_back(space.empty() ? std::string(prefix) : space);
  });
}

void ModelReader::begin(const XmlName& name, const XmlAttributes& attributes) {
  if (depth_++ == 0) {
    if (name.local != "model") {
      fail("begins with " + quotedWord(name.local.data(), name.local.data() + name.local.size()) +
           " where model is due");
    }
    coreSpace_ = name.space;
    return beginModel(attributes);
  }
  if (name.space != coreSpace_) {
    if (std::find(kOtherShapes.begin(), kOtherShapes.end(), name.local) != kOtherShapes.end()) {
      ++model_.otherShapes;
    }
  } else if (name.local == "object") {
    const auto [place, isNew] = model_.objects.try_emplace(integer(attributes, "id"));
    if (!isNew) fail("gives the number of an object a second time");
    object_ = &place->second;
  } else if (name.local == "item") {
    model_.items.push_back(use(attributes));
  } else if (object_ != nullptr) {
    beginInObject(name.local, attributes);
  }
}

void ModelReader::beginInObject(std::string_view name, const XmlAttributes& attributes) {
  if (name == "vertex") {
    object_->vertices.emplace_back(real(attributes, "x"), real(attributes, "y"),
                                   real(attributes, "z"));
  } else if (name == "triangle") {
    std::array<Index, 3> triangle{};
    constexpr std::array kCorners = {"v1", "v2", "v3"};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t vertex = integer(attributes, kCorners[i]);
      if (vertex < 0 || static_cast<std::size_t>(vertex) >= object_->vertices.size()) {
        fail("names vertex " + std::to_string(vertex) + " but there are " +
             std::to_string(object_->vertices.size()) + " (counted from 0)");
      }
      triangle[i] = static_cast<Index>(vertex);
    }
    object_->triangles.push_back(triangle);
  } else if (name == "component") {
    object_->components.push_back(use(attributes));
  }
}

void ModelReader::end(const XmlName& name) {
  --depth_;
  if (name.local == "object" && name.space == coreSpace_) object_ = nullptr;
}

}  // namespace

bool readModel3mf(const Source& source, ZipPackage& package, const std::string& part,
                  const std::function<bool(std::size_t bytes)>& keepOn, Model3mf& model) {
  ModelReader reader(source, part, model);
  bool cancelled = false;
  package.unpack(part, [&](std::string_view piece, bool last) {
    reader.feed(piece, last);
    cancelled = !keepOn(piece.size());
    return !cancelled;
  });
  return !cancelled;
}

}  // namespace chartflood
