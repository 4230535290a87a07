#include "app/host/files/file_name_template.h"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "core/base/error.h"

namespace chartflood {

namespace {

std::string padded(std::size_t number, std::size_t width) {
  std::string digits = std::to_string(number);
  return digits.size() < width ? std::string(width - digits.size(), '0') + digits : digits;
}

std::string safeName(std::string_view text) {
  std::string name(text);
  for (char& c : name) {
    if (c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20) c = '_';
  }
  return name;
}

std::string expand(std::string_view word, std::string_view model, std::string_view mode,
                   std::size_t number) {
  if (word == "model") return safeName(model);
  if (word == "mode") return safeName(mode);
  if (word == "n") return std::to_string(number);
  std::size_t width = 0;
  if (word.starts_with("n:") && word.size() > 2) {
    const auto [end, error] = std::from_chars(word.data() + 2, word.data() + word.size(), width);
    if (error == std::errc() && end == word.data() + word.size() && width <= 9) {
      return padded(number, width);
    }
  }
  throw UsageError("The file name template knows no '{" + std::string(word) +
                   "}'; use {model}, {mode}, {n} or {n:3}.");
}

std::string fillIn(std::string_view pattern, std::string_view model, std::string_view mode,
                   std::size_t number) {
  std::string name;
  while (!pattern.empty()) {
    const std::size_t open = pattern.find('{');
    const std::size_t close = open == std::string_view::npos ? open : pattern.find('}', open);
    if (close == std::string_view::npos) {
      name += pattern;
      break;
    }
    name += pattern.substr(0, open);
    name += expand(pattern.substr(open + 1, close - open - 1), model, mode, number);
    pattern.remove_prefix(close + 1);
  }
  return name;
}

bool taken(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::symlink_status(file, error).type() !=
         std::filesystem::file_type::not_found;
}

}  // namespace

std::filesystem::path freeFileName(const std::filesystem::path& folder, std::string_view pattern,
                                   std::string_view model, std::string_view mode) {
  const bool numbered = fillIn(pattern, model, mode, 1) != fillIn(pattern, model, mode, 2);
  for (std::size_t number = 1;; ++number) {
    std::filesystem::path file = folder / fillIn(pattern, model, mode, number);
    if (!numbered && number > 1) {
      file.replace_filename(file.stem().string() + '_' + std::to_string(number) +
                            file.extension().string());
    }
    if (!taken(file)) return file;
  }
}

}  // namespace chartflood
