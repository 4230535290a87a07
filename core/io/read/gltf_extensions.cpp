#include "core/io/read/gltf_extensions.h"

#include <algorithm>
#include <array>

namespace chartflood {

namespace {

constexpr std::array<std::string_view, 6> kRead = {
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression",
    "KHR_mesh_quantization",      "EXT_mesh_gpu_instancing", "KHR_accessor_float64"};

/// Beginnings of the names of extensions that stand on nodes, meshes or primitives and yet leave
/// the triangles where they are.
constexpr std::array<std::string_view, 33> kHarmless = {"KHR_materials_",
                                                        "KHR_texture_",
                                                        "KHR_techniques_",
                                                        "KHR_lights_",
                                                        "KHR_xmp",
                                                        "KHR_node_",
                                                        "KHR_animation_",
                                                        "KHR_interactivity",
                                                        "KHR_physics_",
                                                        "KHR_audio",
                                                        "KHR_blend",
                                                        "EXT_texture_",
                                                        "EXT_lights_",
                                                        "EXT_materials_",
                                                        "EXT_mesh_features",
                                                        "EXT_instance_features",
                                                        "EXT_structural_",
                                                        "EXT_feature_",
                                                        "EXT_mesh_manifold",
                                                        "EXT_mesh_primitive_edge_visibility",
                                                        "EXT_property_",
                                                        "MSFT_texture_",
                                                        "MSFT_packing_",
                                                        "MSFT_lod",
                                                        "MSFT_audio_",
                                                        "VRM",
                                                        "MOZ_",
                                                        "OMI_",
                                                        "AGI_",
                                                        "CESIUM_",
                                                        "ADOBE_materials_",
                                                        "NV_materials_",
                                                        "FB_geometry_metadata"};

}  // namespace

bool leavesGeometryReadable(std::string_view extension, const GltfJson& file) {
  if (std::find(kRead.begin(), kRead.end(), extension) != kRead.end()) return true;
  const bool harmless =
      std::any_of(kHarmless.begin(), kHarmless.end(),
                  [&](std::string_view beginning) { return extension.starts_with(beginning); });
  if (harmless) return true;
  constexpr std::array kGeometry = {"buffers", "bufferViews", "accessors", "meshes", "nodes"};
  return std::none_of(kGeometry.begin(), kGeometry.end(),
                      [&](const char* list) { return file.standsOnAny(list, extension); });
}

}  // namespace chartflood
