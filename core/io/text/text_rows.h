#pragma once
/// Reading of text formats that are rows of numbers: PLY, OFF and STL.

#include <cstdint>
#include <cstring>
#include <string_view>

#include "core/io/text/parse_number.h"
#include "core/io/text/source.h"

namespace chartflood {

/// Walks over the words of a text. A word may follow on a later line; the rest of a line can be
/// skipped. Errors name the line.
class TextRows {
 public:
  /// \param comment character that begins a comment up to the line's end, 0 for none
  TextRows(const Source& source, const char* begin, char comment)
      : source_(source), p_(begin), end_(source.end()), comment_(comment) {}

  const char* position() const { return p_; }
  /// Goes on from another place of the same text.
  void moveTo(const char* position) { p_ = position; }
  /// Goes to the next word. \returns false at the end of the text.
  bool next() {
    while (p_ < end_) {
      if (isSpace(*p_)) {
        ++p_;
      } else if (comment_ != 0 && *p_ == comment_) {
        skipLine();
      } else {
        return true;
      }
    }
    return false;
  }
  /// The next word, "" at the end of the text.
  std::string_view word() {
    next();
    const char* const begin = p_;
    while (p_ < end_ && !isSpace(*p_)) ++p_;
    return {begin, static_cast<std::size_t>(p_ - begin)};
  }
  /// Goes behind the end of the present line.
  void skipLine() {
    while (p_ < end_ && *p_ != '\n' && *p_ != '\r') ++p_;
    if (p_ < end_) p_ += *p_ == '\r' && p_ + 1 < end_ && p_[1] == '\n' ? 2 : 1;
  }
  /// True when a word follows on the present line.
  bool moreOnLine() {
    while (p_ < end_ && (*p_ == ' ' || *p_ == '\t')) ++p_;
    return p_ < end_ && *p_ != '\n' && *p_ != '\r' && (comment_ == 0 || *p_ != comment_);
  }
  /// The next word as a number. `what` names it in errors ("a coordinate"). \throws ReadError
  double real(const char* what) {
    requireWord(what);
    const RealResult number = parseReal(p_, end_);
    if (number.status == NumberStatus::TooLarge) failTooLarge();
    if (number.status != NumberStatus::Ok || !endsWord(number.end)) failWord(what);
    p_ = number.end;
    return number.value;
  }
  /// The next word as a whole number. \throws ReadError
  std::int64_t integer(const char* what) {
    requireWord(what);
    const IntegerResult number = parseInteger(p_, end_);
    if (number.status == NumberStatus::TooLarge) failTooLarge();
    if (number.status != NumberStatus::Ok || !endsWord(number.end)) failWord(what);
    p_ = number.end;
    return number.value;
  }

 private:
  static bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
  }
  bool endsWord(const char* p) const {
    return p == end_ || isSpace(*p) || (comment_ != 0 && *p == comment_);
  }
  void requireWord(const char* what) {
    if (!next()) source_.failAtLine(end_, std::string("ends the file where ") + what + " is due");
  }
  [[noreturn]] void failWord(const char* what) const {
    source_.failAtLine(p_, "has " + quotedWord(p_, end_) + " where " + what + " is due");
  }
  [[noreturn]] void failTooLarge() const {
    source_.failAtLine(p_, "has " + quotedWord(p_, end_) + ", which is too large a number");
  }

  const Source& source_;
  const char* p_;
  const char* end_;
  char comment_;
};

}  // namespace chartflood
