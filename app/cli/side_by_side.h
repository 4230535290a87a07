#pragma once
/// Several results in one picture.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/cli/options.h"
#include "core/session/session.h"
#include "render/scene/image.h"

namespace chartflood {

/// Lines below a column.
inline constexpr std::size_t kCaptionLines = 4;

/// Finds out before a long computation whether the columns and rows of the call have room in the
/// picture. \throws UsageError
void checkGrid(const Invocation& call);

/// One column for each result, all seen by one camera, one picture below the other for each of the
/// call's rows, with its lines of text (kCaptionLines at most) below. The picture has the size that
/// the call asks for.
/// \pre one result and one caption a method of the call \throws Error when nothing can draw,
/// UsageError as checkGrid
Image drawSideBySide(std::span<const std::shared_ptr<const Results>> results,
                     std::span<const std::vector<std::string>> captions, const Invocation& call);

}  // namespace chartflood
