#pragma once
/// Where the number of each island has most room in the texture. No GL.

#include <vector>

#include "render/scene/label_places.h"
#include "render/scene/uv_layout.h"

namespace chartflood {

/// One entry an island that is large enough, in their order: `chart` holds the island, `place` and
/// `room` are in texture units. Looks at a picture of 768 pixels a side: numbers need no more.
std::vector<ChartLabel> islandPlaces(const UvLayout& layout);

}  // namespace chartflood
