#include "core/io/text/source.h"

#include <algorithm>

#include "core/base/error.h"

namespace chartflood {

namespace {

std::size_t lineOf(std::string_view text, const char* position) {
  std::size_t line = 1;
  for (const char* p = text.data(); p < position; ++p) {
    const bool pair = *p == '\r' && p + 1 < text.data() + text.size() && p[1] == '\n';
    if (*p == '\n' || (*p == '\r' && !pair)) ++line;
  }
  return line;
}

}  // namespace

bool Source::report(const char* position) const {
  if (progress == nullptr) return false;
  if (!bytes.empty()) {
    progress->setFraction(static_cast<float>(position - begin()) /
                          static_cast<float>(bytes.size()));
  }
  return progress->cancelled();
}

void Source::fail(std::string_view cause) const { throw ReadError(name, cause); }

void Source::failAtLine(const char* position, std::string_view cause) const {
  std::string text = "line " + std::to_string(lineOf(bytes, position)) + " ";
  fail(text.append(cause));
}

void Source::failAtByte(const char* position, std::string_view cause) const {
  std::string text = "byte " + std::to_string(position - begin()) + ": ";
  fail(text.append(cause));
}

void Source::requireText(const char* format) const {
  if (bytes.empty()) fail("the file is empty");
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) {
    fail("its text is UTF-16; save it as plain text (UTF-8)");
  }
  if (bytes.substr(0, 4096).find('\0') != std::string_view::npos) {
    fail(std::string("it holds binary data where ") + format + " is text");
  }
}

std::string quotedWord(const char* begin, const char* end) {
  constexpr std::ptrdiff_t kLongest = 40;
  std::string text = "\"";
  for (const char* p = begin; p < end && p - begin < kLongest; ++p) {
    const unsigned char c = static_cast<unsigned char>(*p);
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') break;
    text.push_back(c > 0x20 && c < 0x7f ? *p : '?');
  }
  text.push_back('"');
  return text;
}

}  // namespace chartflood
