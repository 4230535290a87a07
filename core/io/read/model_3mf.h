#pragma once
/// One model part of a 3MF package: its objects, their components and what is built of them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/io/read/zip_package.h"
#include "core/io/text/source.h"

namespace chartflood {

/// Another object, moved: a component of an object or an item of the build.
struct Use3mf {
  std::string part;  ///< key of the part that holds the object
  std::int64_t object = 0;
  glm::dmat4 transform{1};
};

struct Object3mf {
  std::vector<glm::dvec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Use3mf> components;
};

struct Model3mf {
  double unit = 1;  ///< in millimetres
  std::map<std::int64_t, Object3mf> objects;
  std::vector<Use3mf> items;
  /// Extensions without which its writer thinks the model cannot be understood, of those that this
  /// program does not know.
  std::vector<std::string> unknownExtensions;
  std::size_t otherShapes = 0;  ///< beams, boolean and implicit shapes: not read
};

/// Reads a part (core specification 1.3, production extension 1.1) of the package.
/// \param keepOn asked with the number of bytes of each piece; false cancels
/// \returns false when cancelled. \throws ReadError with part and line
bool readModel3mf(const Source& source, ZipPackage& package, const std::string& part,
                  const std::function<bool(std::size_t bytes)>& keepOn, Model3mf& model);

}  // namespace chartflood
