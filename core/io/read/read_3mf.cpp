#include "core/io/read/read_3mf.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <glm/matrix.hpp>

#include "core/base/counted.h"
#include "core/io/read/model_3mf.h"
#include "core/io/read/xml_reader.h"
#include "core/io/read/zip_package.h"

namespace chartflood {

namespace {

constexpr std::string_view kModelRelation = "/3dmodel";
constexpr std::size_t kDeepest3mf = 100;
/// Components may be used again and again; a short file could ask for more than memory holds.
constexpr std::size_t kMostRepeated = std::size_t{1} << 26;
constexpr std::size_t kMostUses = std::size_t{1} << 22;

std::size_t saturatedSum(std::size_t a, std::size_t b) {
  return a > std::numeric_limits<std::size_t>::max() - b ? std::numeric_limits<std::size_t>::max()
                                                         : a + b;
}

/// Finds the main part in the relationships of the package.
class RelationReader : public XmlReader::Handler {
 public:
  void begin(const XmlName& name, const XmlAttributes& attributes) override {
    if (name.local != "Relationship" || !target.empty()) return;
    const char* const type = attributes.find("Type");
    const char* const place = attributes.find("Target");
    if (type == nullptr || place == nullptr) return;
    if (std::string_view(type).ends_with(kModelRelation)) target = place;
  }
  void end(const XmlName&) override {}

  std::string target;
};

class PackageReader {
 public:
  explicit PackageReader(const Source& source)
      : source_(source), package_(source), expected_(package_.sizeOfAll(".model")) {}

  InputMesh read();

 private:
  struct Amount {
    std::size_t triangles = 0, uses = 0;
  };
  std::string mainPart();
  bool keepOn(std::size_t bytes);
  const Model3mf* part(const std::string& key);
  std::vector<Use3mf> looseObjects(const Model3mf& main, const std::string& key) const;
  Object3mf* find(const Use3mf& use);
  Amount measure(const Use3mf& use, std::size_t depth);
  void checkAmount(const std::vector<Use3mf>& items);
  bool add(const Use3mf& use, const glm::dmat4& parent);
  void report(const std::vector<Use3mf>& items);

  const Source& source_;
  ZipPackage package_;
  std::size_t expected_, done_ = 0;
  bool cancelled_ = false;
  double unit_ = 1;  ///< of the main part
  std::map<std::string, Model3mf> parts_;
  std::map<const Object3mf*, std::optional<Amount>> amounts_;  ///< none while being measured
  InputMesh mesh_;
};

std::string PackageReader::mainPart() {
  constexpr const char* kRelations = "_rels/.rels";
  if (package_.has(kRelations)) {
    RelationReader relations;
    XmlReader xml(relations);
    package_.unpack(kRelations, [&](std::string_view piece, bool last) {
      return xml.feed(piece, last).empty();
    });
    if (package_.has(relations.target)) return ZipPackage::keyOf(relations.target);
  }
  if (package_.has("3D/3dmodel.model")) return ZipPackage::keyOf("3D/3dmodel.model");
  std::string only = package_.firstEndingIn(".model");
  if (only.empty()) source_.fail("it is a ZIP archive without a 3D model in it");
  return only;
}

bool PackageReader::keepOn(std::size_t bytes) {
  done_ += bytes;
  if (source_.progress == nullptr) return true;
  const std::size_t all = std::max({expected_, done_, std::size_t{1}});
  source_.progress->setFraction(static_cast<float>(done_) / static_cast<float>(all));
  cancelled_ = source_.progress->cancelled();
  return !cancelled_;
}

/// The part with this key, read when first asked for; null when cancelled.
const Model3mf* PackageReader::part(const std::string& key) {
  const auto [place, isNew] = parts_.try_emplace(key);
  if (isNew && !readModel3mf(
                   source_, package_, key, [this](std::size_t bytes) { return keepOn(bytes); },
                   place->second)) {
    return nullptr;
  }
  return &place->second;
}

Object3mf* PackageReader::find(const Use3mf& use) {
  if (part(use.part) == nullptr) return nullptr;
  std::map<std::int64_t, Object3mf>& objects = parts_.at(use.part).objects;
  const auto found = objects.find(use.object);
  if (found == objects.end()) {
    source_.fail(quotedWord(use.part.data(), use.part.data() + use.part.size()) +
                 " has no object " + std::to_string(use.object) +
                 ", although it is used; save the file anew");
  }
  return &found->second;
}

/// How much a use adds, components of components included.
PackageReader::Amount PackageReader::measure(const Use3mf& use, std::size_t depth) {
  if (depth > kDeepest3mf) {
    source_.fail("its components lie more than " + std::to_string(kDeepest3mf) +
                 " deep in each other; export it flat");
  }
  const Object3mf* const object = find(use);
  if (object == nullptr) return {};
  const auto [place, isNew] = amounts_.try_emplace(object);
  if (!isNew) {
    if (!place->second) {
      source_.fail("its object " + std::to_string(use.object) + " is a component of itself");
    }
    return *place->second;
  }
  Amount sum{object->triangles.size(), 1};
  for (const Use3mf& component : object->components) {
    const Amount more = measure(component, depth + 1);
    sum.triangles = saturatedSum(sum.triangles, more.triangles);
    sum.uses = saturatedSum(sum.uses, more.uses);
  }
  place->second = sum;
  return sum;
}

void PackageReader::checkAmount(const std::vector<Use3mf>& items) {
  Amount sum;
  for (const Use3mf& item : items) {
    const Amount more = measure(item, 0);
    sum.triangles = saturatedSum(sum.triangles, more.triangles);
    sum.uses = saturatedSum(sum.uses, more.uses);
  }
  std::size_t stored = 0;
  for (const auto& [key, model] : parts_) {
    for (const auto& [number, object] : model.objects) stored += object.triangles.size();
  }
  if (sum.triangles > std::max(stored, kMostRepeated) || sum.uses > kMostUses) {
    source_.fail("it repeats its parts until there are many millions of " +
                 std::string(sum.uses > kMostUses ? "them" : "triangles") +
                 "; export fewer copies");
  }
}

/// Adds the object and its components. \returns false when cancelled.
bool PackageReader::add(const Use3mf& use, const glm::dmat4& parent) {
  if (!keepOn(0)) return false;
  const Object3mf& object = *find(use);
  const glm::dmat4 transform = parent * use.transform;
  // Parts of another unit are brought to that of the main one.
  const double scale = parts_.at(use.part).unit / unit_;
  if (mesh_.positions.size() + object.vertices.size() >= kNone) {
    source_.fail("it has more than 4 billion vertices");
  }
  const auto first = static_cast<Index>(mesh_.positions.size());
  for (const glm::dvec3& vertex : object.vertices) {
    mesh_.positions.emplace_back(transform * glm::dvec4(scale * vertex, 1));
  }
  const bool mirrored = glm::determinant(glm::dmat3(transform)) < 0;
  for (const auto& [a, b, c] : object.triangles) {
    mesh_.corners.push_back(first + a);
    mesh_.corners.push_back(first + (mirrored ? c : b));
    mesh_.corners.push_back(first + (mirrored ? b : c));
  }
  return std::all_of(object.components.begin(), object.components.end(),
                     [&](const Use3mf& component) { return add(component, transform); });
}

/// Objects of the main part that are no component of another.
std::vector<Use3mf> PackageReader::looseObjects(const Model3mf& main,
                                                const std::string& key) const {
  std::set<std::int64_t> used;
  for (const auto& [number, object] : main.objects) {
    for (const Use3mf& component : object.components) {
      if (component.part == key) used.insert(component.object);
    }
  }
  std::vector<Use3mf> loose;
  for (const auto& [number, object] : main.objects) {
    if (!used.contains(number)) loose.push_back({key, number});
  }
  return loose;
}

void PackageReader::report(const std::vector<Use3mf>& items) {
  std::size_t others = 0;
  std::string unknown;
  for (const auto& [key, model] : parts_) {
    others += model.otherShapes;
    if (!model.unknownExtensions.empty()) unknown = model.unknownExtensions.front();
  }
  if (mesh_.corners.empty()) {
    if (unknown.empty()) source_.fail("it has no faces");
    source_.fail("it has no faces that this program knows: it needs the 3MF extension " +
                 quotedWord(unknown.data(), unknown.data() + unknown.size()) +
                 "; export it without, or as OBJ");
  }
  if (others > 0) {
    mesh_.repairs.push_back({"other-shapes-left-out", others,
                             counted(others, "beam, boolean or implicit shape was",
                                     "beams, boolean or implicit shapes were") +
                                 " left out."});
  }
  if (items.empty()) {
    mesh_.repairs.push_back(
        {"nothing-built", 1, "The file builds nothing; all its objects were read."});
  }
}

InputMesh PackageReader::read() {
  const std::string key = mainPart();
  const Model3mf* const main = part(key);
  if (main == nullptr) return {};
  unit_ = main->unit;
  const std::vector<Use3mf> items = main->items.empty() ? looseObjects(*main, key) : main->items;
  checkAmount(items);
  if (cancelled_) return {};
  for (const Use3mf& item : items) {
    if (!add(item, glm::dmat4(1))) return {};
  }
  report(main->items);
  return std::move(mesh_);
}

}  // namespace

InputMesh read3mf(const Source& source) { return PackageReader(source).read(); }

}  // namespace chartflood
