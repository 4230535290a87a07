#include "app/host/files/checker_picture.h"

#include <algorithm>
#include <array>
#include <memory>

#include "core/base/text.h"
#include "render/scene/read_picture.h"

namespace chartflood {

bool isPictureFile(const std::filesystem::path& file) {
  const std::string ending = lowerCase(file.extension().string());
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
