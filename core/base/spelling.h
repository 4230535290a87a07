#pragma once
/// Guesses the word that was meant, for messages about unknown options and values.

#include <span>
#include <string>
#include <string_view>

namespace chartflood {

/// The candidate closest to `word` in edits, or "" when none is near.
std::string nearestSpelling(std::string_view word, std::span<const std::string> candidates);

}  // namespace chartflood
