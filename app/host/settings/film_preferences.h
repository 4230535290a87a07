#pragma once
/// How the user likes to watch floods.

#include <cstddef>

#include "app/host/settings/setting.h"

namespace chartflood {

/// How many triangles a large step takes.
enum class ManyFaces { Ten, Hundred, Hundredth, OneAChart };
/// At least 1. `faces` and `charts` of the model.
std::size_t manyFacesCount(ManyFaces many, std::size_t faces, std::size_t charts);

struct FilmPreferences {
  ManyFaces many = ManyFaces::Hundredth;
  bool reducedMotion = false;  ///< nothing flashes

  bool operator==(const FilmPreferences&) const = default;
};
const SettingTable<FilmPreferences>& filmSettingTable();

}  // namespace chartflood
