#pragma once
/// Errors that reach the user: each is one sentence that says what, where and what next.

#include <stdexcept>
#include <string>
#include <string_view>

namespace chartflood {

/// Anything that stops a request of the user. `what()` is one complete sentence for a person.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be used as a mesh (or session): `what()` reads
/// "Could not read FILE: WHERE WHAT." The file was not changed and nothing was loaded.
class ReadError : public Error {
 public:
  ReadError(std::string_view file, std::string_view cause);
  /// The part after the file name, without the final full stop.
  const std::string& cause() const noexcept { return cause_; }

 private:
  std::string cause_;
};

/// A file that cannot be written. The old file, if any, is as it was.
class WriteError : public Error {
 public:
  WriteError(std::string_view file, std::string_view cause);
};

/// Wrong usage of an option or action: names it and says what would be right (exit code 2).
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace chartflood
