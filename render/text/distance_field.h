#pragma once
/// Distances to the outline of a shape given as a picture.

#include <vector>

namespace chartflood {

/// Signed distance of each pixel's centre to the border between set and unset pixels: positive
/// inside, pixels, exact between pixel centres minus the half pixel to the border. `inside` holds
/// `width` x `height` flags, row by row; what lies beyond the picture is outside.
/// (P. Felzenszwalb and D. Huttenlocher, "Distance transforms of sampled functions", 2012.)
std::vector<float> signedDistances(const std::vector<bool>& inside, int width, int height);

}  // namespace chartflood
