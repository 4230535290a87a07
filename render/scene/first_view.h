#pragma once
/// How a model that nobody has looked at yet is shown: which way up, and from where.

#include "core/model/mesh.h"
#include "render/scene/camera.h"

namespace chartflood {

/// The axis that most likely stands upright. What the format says wins (glTF: Y, 3MF: Z); else a
/// flat support below, else the height of what stands; Y where nothing tells. Cost: linear.
UpAxis likelyUpAxis(const Mesh& mesh);

/// Turns to a three-quarter view of the model from above: along the shorter of its horizontal
/// principal axes, turned by 35 degrees; the oblique standard view where these are about equal;
/// turned on where most of what is seen would be one flat side. Target, distance and the upright
/// axis stay. Cost: linear.
void lookAtFirst(Camera& camera, const Mesh& mesh);

}  // namespace chartflood
