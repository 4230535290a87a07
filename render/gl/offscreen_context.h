#pragma once
/// GL 3.3 contexts that need no window and no display: OSMesa (loaded when asked for) and EGL
/// surfaceless. They have no framebuffer 0; everything is drawn into framebuffer objects.

#include <memory>
#include <string_view>

#include "render/gl/context.h"

namespace chartflood::gl {

enum class OffscreenBackend { Auto, OSMesa, Egl };

/// Reads "auto", "osmesa" or "egl". \throws UsageError for any other word.
OffscreenBackend offscreenBackendFromId(std::string_view id);

/// Makes a context, not current yet. Auto takes OSMesa and, where that is missing, EGL.
/// One process may hold several, but while an OSMesa context is current no other thread may use
/// GL: the function table is shared by the process.
/// \throws Error naming what was missing.
std::unique_ptr<Context> createOffscreenContext(OffscreenBackend backend = OffscreenBackend::Auto);

/// The two kinds, for the function above.
std::unique_ptr<Context> createOsmesaContext();
std::unique_ptr<Context> createEglContext();

}  // namespace chartflood::gl
