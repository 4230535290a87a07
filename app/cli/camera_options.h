#pragma once
/// The camera that the options ask for.

#include "app/cli/options.h"
#include "core/model/mesh.h"
#include "render/scene/camera.h"

namespace chartflood {

/// Starts from a three-quarter view of the whole model, see lookAtFirst(), in a picture of the
/// given aspect (width over height), and takes over what the options say. Points of the options are
/// in the model's units, the camera's in the mesh's normalised ones.
Camera cameraFromOptions(const Mesh& mesh, const CameraOptions& options, double aspect);

}  // namespace chartflood
