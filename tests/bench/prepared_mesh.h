#pragma once
/// Meshes that benchmarks run on, each made ready once.

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "core/io/read_mesh.h"
#include "core/samples/samples.h"

namespace chartflood {

/// "bumps/20000" is a sample of so many triangles, anything else a file of the folder of meshes.
inline std::shared_ptr<const InputMesh> meshNamed(const std::string& name) {
  const std::size_t slash = name.find('/');
  return slash == std::string::npos
             ? readMesh(std::filesystem::path(CHARTFLOOD_MESHES) / name)
             : makeSample(name.substr(0, slash), std::stoul(name.substr(slash + 1)));
}

/// The mesh of that name with all that Prepared makes of it, kept for the next benchmark.
template <class Prepared>
const Prepared& preparedMesh(const std::string& name) {
  static std::map<std::string, std::unique_ptr<Prepared>> made;
  std::unique_ptr<Prepared>& entry = made[name];
  if (!entry) entry = std::make_unique<Prepared>(meshNamed(name));
  return *entry;
}

}  // namespace chartflood
