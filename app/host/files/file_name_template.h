#pragma once
/// Names of pictures: "{model}_{mode}_{n:3}.png", never one that exists.

#include <filesystem>
#include <string>
#include <string_view>

namespace chartflood {

/// Fills in {model}, {mode} and the running number {n} or {n:WIDTH} (at least WIDTH digits) with
/// the smallest number from 1 on that gives a name not yet in `folder`. A template without {n}
/// whose name is taken gets "_2", "_3", .. before its extension. Characters that do not belong into
/// a file name become "_".
/// \throws UsageError for an unknown word in braces.
std::filesystem::path freeFileName(const std::filesystem::path& folder, std::string_view pattern,
                                   std::string_view model, std::string_view mode);

}  // namespace chartflood
