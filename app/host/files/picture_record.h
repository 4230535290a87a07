#pragma once
/// How a picture was made, kept in its file: from it the program takes the same picture again.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "core/session/files/session_io.h"
#include "render/scene/image.h"

namespace chartflood {

/// What a picture depends on beside the session.
struct PictureRecord {
  std::string model;                    ///< name of the mesh's file without folders, "": a sample
  std::string view = "3d";              ///< 3d, uv or both
  int width = 1280, height = 960;       ///< pixels
  int smooth = 2;                       ///< samples a pixel in each direction: 1, 2 or 4
  double lineScale = 1;                 ///< how much larger lines and letters are than at 100 %
  std::optional<std::size_t> playhead;  ///< so many faces of the flood were taken; nothing: all

  bool operator==(const PictureRecord&) const = default;
};

/// Lines of "key=value".
std::string recordText(const PictureRecord& record);
/// \throws ReadError naming `file` when a line cannot be used; unknown keys are passed over
PictureRecord readRecord(const std::string& text, const std::string& file);

/// What a picture says of itself. `session` is the text of a session without a target.
ImageTexts pictureTexts(const std::string& session, const PictureRecord& record,
                        const std::string& commandLine);

/// True for a name that ends in ".png", whatever the case: such files may say how they were made.
bool isPngFile(const std::filesystem::path& file);
/// True for a PNG file that says how it was made; false for all others, readable or not.
bool holdsSession(const std::filesystem::path& file);

struct PictureSource {
  SessionFile session;
  PictureRecord record;
};
/// What pictureTexts() wrote into a file. The model is `model`, or where that is "" the file of the
/// noted name beside the picture.
/// \throws ReadError when the file is no picture, says nothing of the kind, or its model is not
///   there
PictureSource readPictureSource(const std::filesystem::path& file,
                                const std::filesystem::path& model);

/// The name of the model that a picture shows; "" for a sample. \throws ReadError
std::string modelOfPicture(const std::filesystem::path& file);

}  // namespace chartflood
