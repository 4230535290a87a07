#include "app/host/files/checker_picture.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>

#include "render/scene/read_picture.h"

namespace chartflood {

bool isPictureFile(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array kEndings = {".png", ".jpg", ".jpeg"};
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

void setCheckerPicture(const std::filesystem::path& file, ViewSettings& view) {
  auto picture = std::make_shared<const Image>(readPicture(file));
  view.render.checkerPicture = std::move(picture);
  view.render.checkerKind = CheckerKind::Picture;
  view.checkerFile = std::filesystem::absolute(file).lexically_normal().string();
}

void dropCheckerPicture(ViewSettings& view) {
  view.render.checkerPicture.reset();
  if (view.render.checkerKind == CheckerKind::Picture) {
    view.render.checkerKind = CheckerKind::Squares;
  }
  view.checkerFile.clear();
}

}  // namespace chartflood
