#pragma once
/// What a reader reads from, and how it says where it failed.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/progress.h"

namespace chartflood {

/// The bytes of one file, with its name for messages.
struct Source {
  std::string_view bytes;
  std::string name;                ///< as the user wrote it
  std::filesystem::path folder{};  ///< where files that it names are looked for
  Progress* progress = nullptr;

  /// Reports how far reading has come. \returns true when the reader should stop.
  bool report(const char* position) const;
  /// \throws ReadError "Could not read FILE: CAUSE."
  [[noreturn]] void fail(std::string_view cause) const;
  /// \throws ReadError "Could not read FILE: line N CAUSE." Lines end in LF, CR LF or CR.
  [[noreturn]] void failAtLine(const char* position, std::string_view cause) const;
  /// \throws ReadError "Could not read FILE: byte N: CAUSE.", counted from 0.
  [[noreturn]] void failAtByte(const char* position, std::string_view cause) const;
  /// Refuses binary and UTF-16 content in a text format named `format`. \throws ReadError
  void requireText(const char* format) const;

  const char* begin() const { return bytes.data(); }
  const char* end() const { return bytes.data() + bytes.size(); }
  /// Where a text begins: behind the mark that some editors write before UTF-8.
  const char* text() const { return begin() + (bytes.starts_with("\xef\xbb\xbf") ? 3 : 0); }
};

/// The word at a place of a text, in quotes, shortened and with unprintable bytes replaced.
std::string quotedWord(const char* begin, const char* end);

}  // namespace chartflood
