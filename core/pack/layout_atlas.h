#pragma once
/// Places all charts in one square texture.

#include <memory>

#include "core/base/progress.h"
#include "core/model/atlas.h"
#include "core/model/chart_set.h"
#include "core/model/unwrap.h"

namespace chartflood {

struct LayoutOptions {
  enum class Kind {
    Square,  ///< each chart in a square cell of its own and as large as fits, as in the paper
    Packed,  ///< all charts at one scale, turned and packed by their shapes
  };
  Kind kind = Kind::Packed;
  int textureSize = 1024;  ///< pixels a side
  int margin = 8;          ///< least empty pixels between charts, where these have room

  bool operator==(const LayoutOptions&) const = default;
};

/// The least power of two that is a texture's size in which so many charts keep the margin.
int textureSizeFor(std::size_t charts, int margin);

/// Charts without uv are left out. Where so many charts would have no room beside the margin, the
/// atlas has a smaller one. Charts are never mirrored. Same input, same bytes, for any
/// number of threads. \return null when cancelled
std::shared_ptr<const Atlas> layoutAtlas(const ChartSet& charts, const Unwrap& unwrap,
                                         const LayoutOptions& options, Progress& progress);

}  // namespace chartflood
