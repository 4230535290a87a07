#pragma once
/// How the user likes to watch floods.

#include <array>
#include <cstddef>
#include <string>

namespace chartflood {

/// How many triangles a large step takes.
enum class ManyFaces { Ten, Hundred, Hundredth, OneAChart };
inline constexpr std::array kManyFaces = {ManyFaces::Ten, ManyFaces::Hundred, ManyFaces::Hundredth,
                                          ManyFaces::OneAChart};

const char* manyFacesId(ManyFaces many);
/// Hundredth for an unknown name.
ManyFaces manyFacesFromId(const std::string& id);
/// At least 1. `faces` and `charts` of the model.
std::size_t manyFacesCount(ManyFaces many, std::size_t faces, std::size_t charts);

struct FilmPreferences {
  ManyFaces many = ManyFaces::Hundredth;
  bool reducedMotion = false;  ///< nothing flashes

  bool operator==(const FilmPreferences&) const = default;
};

}  // namespace chartflood
