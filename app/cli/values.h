#pragma once
/// Reads the values of options that are no parameters. Each refusal names the option, the value and
/// what would be right.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"

namespace chartflood {

/// \throws UsageError unless the text is a whole number in [least, most].
std::size_t readCount(std::string_view option, std::string_view text, std::size_t least,
                      std::size_t most);
/// \throws UsageError unless the text is a finite number.
double readNumber(std::string_view option, std::string_view text);
/// \throws UsageError unless the text is on or off.
bool readSwitch(std::string_view option, std::string_view text);
/// \throws UsageError unless the text is one of the choices.
std::string readChoice(std::string_view option, std::string_view text,
                       std::span<const std::string> choices);
/// "W,H", each from 1 to `most`. \throws UsageError
std::pair<int, int> readSize(std::string_view option, std::string_view text, int most);
/// "3,1,20". \throws UsageError unless all are whole numbers, each once.
std::vector<Index> readFaces(std::string_view option, std::string_view text);
/// `count` finite numbers with commas between.
std::vector<double> readNumbers(std::string_view option, std::string_view text, std::size_t count,
                                std::string_view form);
/// "X,Y,Z". \throws UsageError, also for 0,0,0 when `direction`
glm::dvec3 readVector(std::string_view option, std::string_view text, bool direction);

/// The ending of a file's name in lower case: ".png".
std::string fileEnding(const std::filesystem::path& file);

}  // namespace chartflood
