#pragma once
/// The files inside a ZIP archive that lies in memory, read with a limit on what they unpack to.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/io/text/source.h"

struct zip;

namespace chartflood {

/// An archive whose entries are the parts of a package: names in any case, with or without a
/// leading slash.
class ZipPackage {
 public:
  /// What an entry unpacks to, piece by piece. \returns false to stop.
  using Sink = std::function<bool(std::string_view piece, bool last)>;

  /// The source has to outlive the archive. \throws ReadError when it is no ZIP archive
  explicit ZipPackage(const Source& source);
  ~ZipPackage();
  ZipPackage(const ZipPackage&) = delete;
  ZipPackage& operator=(const ZipPackage&) = delete;

  bool has(std::string_view name) const { return entries_.contains(keyOf(name)); }
  /// The name of the first entry that ends so, "" when there is none.
  std::string firstEndingIn(std::string_view ending) const;
  /// What all entries that end so unpack to, as the archive has it: for showing progress only.
  std::size_t sizeOfAll(std::string_view ending) const;
  /// Unpacks an entry; each of its bytes counts towards the limit of the whole archive.
  /// \throws ReadError when it is missing, damaged or encrypted, or unpacks to too much
  void unpack(std::string_view name, const Sink& sink);

  /// The name by which an entry is found: lower case, '/' between folders and none before them,
  /// %-escapes resolved where they are valid.
  static std::string keyOf(std::string_view name);

 private:
  [[noreturn]] void fail(std::string_view name, const char* cause) const;

  const Source& source_;
  zip* archive_ = nullptr;
  std::map<std::string, std::uint64_t> entries_;  ///< by keyOf() their names
  std::size_t unpacked_ = 0;
  std::size_t limit_;
};

}  // namespace chartflood
