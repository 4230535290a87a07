#include "app/host/settings/film_preferences.h"

#include <algorithm>

namespace chartflood {

namespace {

constexpr NamedValue<ManyFaces> kManyFaces[] = {
    {ManyFaces::Ten, "10", "10 triangles"},
    {ManyFaces::Hundred, "100", "100 triangles"},
    {ManyFaces::Hundredth, "hundredth", "1 % of all"},
    {ManyFaces::OneAChart, "charts", "One for each chart"}};

}  // namespace

const SettingTable<FilmPreferences>& filmSettingTable() {
  static const SettingTable<FilmPreferences> rows = {
      {.id = "many",
       .title = "Triangles of a large step",
       .help = "Chooses how many triangles Step many and Back many take.",
       .value = oneOf(&FilmPreferences::many, std::span<const NamedValue<ManyFaces>>(kManyFaces)),
       .argument = "faces"},
      {"reduced-motion", "Reduced motion",
       "Nothing flashes: triangles that a step takes appear without a sign.",
       onOff(&FilmPreferences::reducedMotion)}};
  return rows;
}

std::size_t manyFacesCount(ManyFaces many, std::size_t faces, std::size_t charts) {
  switch (many) {
  case ManyFaces::Ten:
    return 10;
  case ManyFaces::Hundred:
    return 100;
  case ManyFaces::Hundredth:
    break;
  case ManyFaces::OneAChart:
    return std::max<std::size_t>(1, charts);
  }
  return std::max<std::size_t>(1, faces / 100);
}

}  // namespace chartflood
