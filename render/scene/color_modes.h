#pragma once
/// What the colours of the model can say: one row a mode, from which menus, keys, help, pictures,
/// legend, plots and shaders come.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chartflood {

struct ModeSource;
struct ModeValues;

/// In the order of menus.
enum class ColorMode {
  Shaded,
  Charts,
  Gauss,
  GaussVertex,
  GaussEdge,
  GaussFace,
  Balance,
  FloodTime,
  FloodOrder,
  Stretch,
  AreaDistortion,
  AngleDistortion,
  Checkerboard,
};

/// How values run along the colours.
enum class ScalarScale {
  Linear,
  Root,  ///< square root of the distance from the lower end: small values get more room
  Log,
};

/// Modes of one family share a number key, and the sub-choice key goes round them.
enum class ColorFamily { Shape, Charts, Gauss, Balance, Flood, Stretch, Area, Angle, Checker };

/// What has a value.
enum class ValueDomain {
  None,      ///< no values at all
  Vertex,    ///< corners of the surface, drawn as discs
  Edge,      ///< creases, drawn as lines
  Triangle,  ///< triangles, each in the colour of its value
  Chart,     ///< charts, each in the colour of its value
  Flood,     ///< what a flood has taken so far
  Corner,    ///< corners of triangles have places in the texture
  All,       ///< vertices, edges and triangles, each kind on its own range
};

/// What must be there before a mode can show anything, beside the mesh.
enum class ModeNeed {
  Nothing,
  Charts,     ///< labels, or a flood under way
  GaussArea,  ///< of vertices, edges and triangles
  Flood,      ///< a record
  Unwrap,     ///< charts laid flat
  Texture,    ///< their places in the texture
};

/// What fills the faces of the model. The shader's FILL_.. macros are made of these by
/// fillMacros().
enum class SurfaceFill {
  Plain,
  Charts,
  TriangleValue,
  ChartValue,
  FloodTime,
  FloodOrder,
  Checker,
};
/// What shaders know of fills ("FILL_PLAIN 0", ..), and which one it is to be ("FILL FILL_PLAIN").
std::vector<std::string> fillMacros(SurfaceFill fill);

/// Which ends a colour bar has, from the values.
enum class RangeRule {
  Shares,      ///< from 0 to 1
  FromZero,    ///< values with a long tail, cut at 98 % of their weight
  FromOne,     ///< 1 is perfect: the tail cut, never less than to 1.1
  AroundZero,  ///< both ends alike, the tail cut
  AroundMean,  ///< per cent of a mean, both ends alike: nothing is cut, up to 100
  PlainEnds,   ///< each kind of element has its own: the ends are called "low" and "high"
};

/// What is known of a colour mode.
struct ColorModeInfo {
  ColorMode mode;
  const char* id;        ///< option value
  const char* label;     ///< menu text
  const char* title;     ///< above the scalar bar, "" for modes without one
  const char* unit;      ///< of the values, "" for plain numbers
  ScalarScale scale;     ///< unless chosen otherwise
  const char* colorMap;  ///< unless chosen otherwise, "" for modes without one
  const char* help;      ///< one sentence
  const char* key;       ///< of the keyboard, "" for none
  ColorFamily family;
  ValueDomain domain;
  ModeNeed needs;
  SurfaceFill fill;
  RangeRule range;
  /// Its values and their ends; null for modes without. \pre what it needs is in the source
  ModeValues (*values)(const ColorModeInfo&, const ModeSource&);
};
/// One row a mode, in the order of the enumeration.
std::span<const ColorModeInfo> colorModeTable();
const ColorModeInfo& colorModeInfo(ColorMode mode);
/// The mode with this id, or nullptr.
const ColorModeInfo* findColorMode(std::string_view id);
/// The modes of a mode's family, itself included.
std::vector<ColorMode> colorModeFamily(ColorMode mode);
/// The mode has nothing to show before the charts are laid flat.
bool needsUnwrap(ColorMode mode);

}  // namespace chartflood
