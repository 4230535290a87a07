#pragma once
/// Data that stands as text in a file (RFC 2397), and the escapes of names.

#include <optional>
#include <string>
#include <string_view>

namespace chartflood {

bool isDataUri(std::string_view uri);

/// The bytes of a data URI, base64 or escaped text; nothing when it is broken or cut off.
std::optional<std::string> decodeDataUri(std::string_view uri);

/// "ten%2010%.bin" is "ten 10%.bin": escapes that are none stay as they stand.
std::string withoutEscapes(std::string_view uri);

/// A name for a sentence: at most 60 bytes of it, nothing unprintable.
std::string shownName(std::string_view name);

}  // namespace chartflood
