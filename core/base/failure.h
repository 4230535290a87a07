#pragma once
/// What to tell the user of anything that was thrown.

#include <exception>
#include <string>

namespace chartflood {

/// The sentence of an Error, or one that says that memory has run out or the program has a fault.
std::string failureSentence(const std::exception& failure);

}  // namespace chartflood
