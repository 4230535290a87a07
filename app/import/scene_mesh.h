#pragma once
/// From a scene of the import library to a mesh.

#include "core/io/read/import_reply.h"

struct aiScene;

namespace chartflood {

/// Every mesh of the nodes, with their transforms applied; polygons are kept, points and lines
/// counted. Corners with exactly the same coordinates become one vertex. A scene whose numbers do
/// not fit each other is refused.
ImportReply meshOfScene(const aiScene& scene);

}  // namespace chartflood
