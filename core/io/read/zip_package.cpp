#include "core/io/read/zip_package.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <vector>

#include <zip.h>

#include "core/base/counted.h"
#include "core/base/text.h"

namespace chartflood {

namespace {

constexpr std::size_t kPiece = 1 << 16;
/// Text of meshes shrinks to a tenth, and to a fiftieth at most; archives made to fill memory, to a
/// thousandth.
constexpr std::size_t kMostGrowth = 100;
constexpr std::size_t kAlwaysAllowed = std::size_t{64} << 20;

struct EntryCloser {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};

const char* entryCause(int code) {
  switch (code) {
  case ZIP_ER_NOPASSWD:
  case ZIP_ER_WRONGPASSWD:
  case ZIP_ER_ENCRNOTSUPP:
    return "is encrypted; save the file without a password";
  case ZIP_ER_COMPNOTSUPP:
    return "is packed in a way that is not known; save the file anew";
  case ZIP_ER_MEMORY:
    return "does not fit into memory";
  default:
    return "is damaged; save or download the file anew";
  }
}

}  // namespace

std::string ZipPackage::keyOf(std::string_view name) {
  std::string key;
  for (std::size_t i = 0; i < name.size(); ++i) {
    char c = name[i] == '\\' ? '/' : name[i];
    unsigned code = 0;
    if (c == '%' && i + 2 < name.size()) {
      const char* const end = name.data() + i + 3;
      if (std::from_chars(name.data() + i + 1, end, code, 16).ptr == end) {
        c = static_cast<char>(code);
        i += 2;
      }
    }
    if (c == '/' && key.empty()) continue;
    key.push_back(lowerCase(c));
  }
  return key;
}

ZipPackage::ZipPackage(const Source& source)
    : source_(source), limit_(std::max(kAlwaysAllowed, kMostGrowth * source.bytes.size())) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* bytes = zip_source_buffer_create(source.begin(), source.bytes.size(), 0, &error);
  if (bytes != nullptr) archive_ = zip_open_from_source(bytes, ZIP_RDONLY, &error);
  if (archive_ == nullptr) {
    if (bytes != nullptr) zip_source_free(bytes);
    const bool memory = zip_error_code_zip(&error) == ZIP_ER_MEMORY;
    zip_error_fini(&error);
    source.fail(memory ? "it does not fit into memory"
                       : "it is no complete ZIP archive; save or download it anew");
  }
  zip_error_fini(&error);
  const zip_int64_t count = zip_get_num_entries(archive_, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* const name = zip_get_name(archive_, static_cast<zip_uint64_t>(i), 0);
    if (name != nullptr) entries_.emplace(keyOf(name), static_cast<std::uint64_t>(i));
  }
}

ZipPackage::~ZipPackage() {
  if (archive_ != nullptr) zip_discard(archive_);
}

std::string ZipPackage::firstEndingIn(std::string_view ending) const {
  for (const auto& [name, number] : entries_) {
    if (name.ends_with(ending)) return name;
  }
  return "";
}

std::size_t ZipPackage::sizeOfAll(std::string_view ending) const {
  std::size_t sum = 0;
  for (const auto& [name, number] : entries_) {
    zip_stat_t status;
    zip_stat_init(&status);
    if (!name.ends_with(ending) || zip_stat_index(archive_, number, 0, &status) != 0) continue;
    if ((status.valid & ZIP_STAT_SIZE) != 0) sum += std::min<std::size_t>(status.size, limit_);
  }
  return sum;
}

void ZipPackage::fail(std::string_view name, const char* cause) const {
  source_.fail("its part " + quotedWord(name.data(), name.data() + name.size()) + " " + cause);
}

void ZipPackage::unpack(std::string_view name, const Sink& sink) {
  const auto found = entries_.find(keyOf(name));
  if (found == entries_.end()) fail(name, "is missing; save the file anew");
  const std::unique_ptr<zip_file_t, EntryCloser> entry(zip_fopen_index(archive_, found->second, 0));
  if (!entry) fail(name, entryCause(zip_error_code_zip(zip_get_error(archive_))));
  std::vector<char> piece(kPiece);
  for (;;) {
    const zip_int64_t got = zip_fread(entry.get(), piece.data(), piece.size());
    if (got < 0) fail(name, entryCause(zip_error_code_zip(zip_file_get_error(entry.get()))));
    unpacked_ += static_cast<std::size_t>(got);
    if (unpacked_ > limit_) {
      source_.fail("it unpacks to more than " + counted(limit_ >> 20, "megabyte", "megabytes") +
                   ", which no mesh of its size does");
    }
    if (!sink({piece.data(), static_cast<std::size_t>(got)}, got == 0)) return;
    if (got == 0) return;
  }
}

}  // namespace chartflood
