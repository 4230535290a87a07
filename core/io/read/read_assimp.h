#pragma once
/// Formats that the import library opens: FBX, Collada, 3DS and more.

#include <string_view>

#include "core/io/text/source.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Reads every mesh of the scene with the nodes' transforms applied; polygons are kept. Corners
/// with exactly the same coordinates become one vertex, because the library gives each face corners
/// of its own. Materials, pictures and poses are left aside.
///
/// The library is known to crash, to hang and to fill memory over broken files, so it runs in a
/// program of its own (chartflood-import, beside this one or in libexec/chartflood of an
/// installation) with limits of memory and time. Other files are opened only in the folder of the
/// source or below it. Cancelling ends that program.
/// \param extension lower case, without the dot: how the library knows the format
/// \throws ReadError when the library refuses it, breaks down over it or exceeds a limit
InputMesh readAssimp(const Source& source, std::string_view extension);

/// Reads glTF whose geometry Draco compressed, as readGltf() reads others: Draco fills memory over
/// data made for that, so it runs in the same program with the same limits.
/// \throws ReadError
InputMesh readDracoGltf(const Source& source);

}  // namespace chartflood
