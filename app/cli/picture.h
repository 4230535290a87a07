#pragma once
/// The picture of a batch run.

#include <functional>
#include <string>

#include "app/cli/options.h"
#include "core/session/session.h"
#include "render/scene/image.h"

namespace chartflood {

/// Draws the results as the options ask. `backend` is "auto", "osmesa" or "egl".
/// \pre mesh, Gauss area and segmentation are there
/// \throws Error when nothing can draw
Image drawPicture(const Results& results, const PictureOptions& options,
                  const std::string& backend);

/// The pictures of a turntable or of a flood, one after the other: `take` is given each with its
/// number from 0 on. \pre one of options.turntable and options.floodFilm is not 0, see
/// drawPicture()
void drawFrames(const Results& results, const PictureOptions& options, const std::string& backend,
                const std::function<void(std::size_t, const Image&)>& take);

/// The charts in the texture and nothing else: over a texture image of the same size it shows what
/// lies where. \pre results.flat \throws Error when nothing can draw
Image drawTexture(const Results& results, const PictureOptions& options,
                  const std::string& backend);

/// What a picture file says about itself: the program, the model and every parameter that differs
/// from its default, as options.
ImageTexts pictureTexts(const Results& results);

}  // namespace chartflood
