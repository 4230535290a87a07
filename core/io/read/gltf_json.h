#pragma once
/// Values out of the JSON of a glTF file; what is of another kind than it should be is refused.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/io/text/source.h"

namespace chartflood {

/// One object of a glTF file, with its place for messages. The GltfJsonFile stays meanwhile.
class GltfJson {
 public:
  /// \param where "accessor 3"; "" for the whole file
  GltfJson(const Source& source, const nlohmann::json& json, std::string where);

  [[noreturn]] void fail(const std::string& cause) const;
  bool has(const char* key) const;
  bool holdsObject(const char* key) const;

  /// A whole number from 0 on; `otherwise` when absent.
  std::size_t count(const char* key, std::size_t otherwise) const;
  /// True for true alone.
  bool flag(const char* key) const;
  std::string text(const char* key) const;
  /// A text, or a number as it is written; "" for anything else.
  std::string textOrNumber(const char* key) const;
  /// The texts of a list; what else it has is passed over.
  std::vector<std::string> texts(const char* key) const;
  /// Finite numbers; empty when absent.
  std::vector<double> numbers(const char* key) const;
  /// Whole numbers from 0 on; empty when absent.
  std::vector<std::size_t> counts(const char* key) const;
  /// The object below a key; an empty one when absent.
  GltfJson part(const char* key) const;
  /// The objects of a list: "node" becomes "node 7".
  std::vector<GltfJson> list(const char* key, const char* each) const;

  /// Whether the extension stands on an object of the list or on one of its primitives. Parts of
  /// the wrong kind are passed over.
  bool standsOnAny(const char* list, std::string_view extension) const;

 private:
  const nlohmann::json& at(const char* key) const;
  std::size_t wholeNumber(const nlohmann::json& value, const char* key) const;

  const Source& source_;
  const nlohmann::json& json_;
  std::string where_;
};

/// The parsed JSON of a glTF file.
class GltfJsonFile {
 public:
  /// \throws ReadError when the text is no JSON object, or nested so deeply that it is no glTF
  GltfJsonFile(const Source& source, std::string_view text);
  ~GltfJsonFile();
  GltfJsonFile(const GltfJsonFile&) = delete;
  GltfJsonFile& operator=(const GltfJsonFile&) = delete;

  GltfJson all() const;

 private:
  const Source& source_;
  std::unique_ptr<const nlohmann::json> json_;
};

}  // namespace chartflood
