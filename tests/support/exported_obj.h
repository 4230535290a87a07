#pragma once
/// Looks at an exported OBJ file as another program would: nothing here uses the library.

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace chartflood::test {

/// The file as it stands; numbers from 0.
struct ExportedObj {
  struct Face {
    std::vector<long> vertex;
    std::vector<long> texture;  ///< -1 where there is none
    std::string group;
  };
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<double, 2>> textures;
  std::vector<Face> faces;
};
ExportedObj parseObj(const std::filesystem::path& file);

/// What a chart (a group) is in the texture.
struct TextureChart {
  std::string group;
  std::size_t triangles = 0;
  bool disk = false;        ///< by texture vertices: Euler number 1, one loop, no pinch
  bool weldedDisk = false;  ///< the same when equal places of one vertex are one
  std::size_t flipped = 0;  ///< triangles that do not turn counter-clockwise
};

struct TextureFigures {
  std::vector<TextureChart> charts;
  std::size_t facesWithoutTexture = 0;
  double lowest = 0, highest = 0;  ///< of all texture coordinates
  std::size_t overlapInside = 0;   ///< pixel centres under two triangles of one chart
  std::size_t overlapBetween = 0;  ///< pixel centres under two charts
  double covered = 0;              ///< share of pixel centres under a triangle
};
/// Evaluates the texture over a raster of `side` x `side` pixels.
TextureFigures measureTexture(const ExportedObj& obj, int side);

}  // namespace chartflood::test
