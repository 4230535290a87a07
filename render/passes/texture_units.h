#pragma once
/// Which texture unit holds what. A unit is never shared by two kinds of sampler.

#include <epoxy/gl.h>

namespace chartflood::units {

inline constexpr GLuint kGlyphs = 0;
inline constexpr GLuint kColorMap = 1;
inline constexpr GLuint kLabels = 2;
inline constexpr GLuint kFlood = 3;
inline constexpr GLuint kFloodTime = 4;
inline constexpr GLuint kValues = 5;  ///< of triangles; also segments and points
inline constexpr GLuint kChartColors = 6;
inline constexpr GLuint kChartValues = 7;
inline constexpr GLuint kVertices = 8;
inline constexpr GLuint kIndices = 9;
inline constexpr GLuint kInnerSides = 10;
inline constexpr GLuint kCheckerGlyphs = 11;
inline constexpr GLuint kMarks = 12;
inline constexpr GLuint kCheckerPicture = 13;
inline constexpr GLuint kSimple = 14;

}  // namespace chartflood::units
