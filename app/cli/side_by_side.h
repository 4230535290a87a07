#pragma once
/// Several results in one picture.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/cli/options.h"
#include "core/session/session.h"
#include "render/image.h"

namespace chartflood {

/// Lines below a column.
inline constexpr std::size_t kCaptionLines = 4;

/// Finds out before a long computation whether so many columns have room in the picture.
/// \throws UsageError
void checkColumns(const PictureOptions& options, std::size_t columns);

/// One column for each result, all seen by one camera, with its lines of text (kCaptionLines at
/// most) below. The picture has the size that the options ask for.
/// \pre one caption a result, at least one \throws Error when nothing can draw, UsageError as
/// checkColumns
Image drawSideBySide(std::span<const std::shared_ptr<const Results>> results,
                     std::span<const std::vector<std::string>> captions,
                     const PictureOptions& options, const std::string& backend);

}  // namespace chartflood
