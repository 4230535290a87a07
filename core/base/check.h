#pragma once
/// Checks of inner invariants. Never for a user's data: that is reported as an Error.

#include <cstdio>
#include <cstdlib>

/// Stops the program with the place and text of a broken invariant.
#define CF_CHECK(condition)                                                                        \
  do {                                                                                             \
    if (!(condition)) {                                                                            \
      std::fprintf(stderr, "%s:%d: broken invariant: %s\n", __FILE__, __LINE__, #condition);       \
      std::abort();                                                                                \
    }                                                                                              \
  } while (false)
