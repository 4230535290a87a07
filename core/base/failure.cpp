#include "core/base/failure.h"

#include <new>

#include "core/base/error.h"

namespace chartflood {

std::string failureSentence(const std::exception& failure) {
  if (dynamic_cast<const Error*>(&failure) != nullptr) return failure.what();
  // A length that no container can have is memory that nobody has.
  const bool memory = dynamic_cast<const std::bad_alloc*>(&failure) != nullptr ||
                      dynamic_cast<const std::length_error*>(&failure) != nullptr;
  if (memory) return "There is not enough memory for this; nothing was changed.";
  return std::string("Something went wrong inside the program (") + failure.what() +
         "); what was there before is still there.";
}

}  // namespace chartflood
