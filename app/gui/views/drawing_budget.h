#pragma once
/// How much time the views may take before the window is looked after again.

namespace chartflood {

inline constexpr int kSmoothSamples = 4;
inline constexpr double kSmoothWhileMoving =
    0.012;                                       ///< seconds a smooth picture may take in motion
inline constexpr double kSecondsAtOnce = 0.018;  ///< of drawing at one go

}  // namespace chartflood
