#include "app/host/actions/picture_on_charts.h"

#include "app/host/files/checker_picture.h"
#include "app/host/state/app_state.h"

namespace chartflood {

void putPictureOnCharts(AppState& state, const std::filesystem::path& file) {
  setCheckerPicture(file, state.view);
  showColorMode(state.view, ColorMode::Checkerboard);
  state.notices.add(Notice::Kind::Info, file.filename().string() +
                                            " lies on the charts. View, Checkerboard of, Use the "
                                            "checkerboard takes it off.");
}

}  // namespace chartflood
