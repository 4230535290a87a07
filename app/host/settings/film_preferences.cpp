#include "app/host/settings/film_preferences.h"

#include <algorithm>

namespace chartflood {

const char* manyFacesId(ManyFaces many) {
  switch (many) {
  case ManyFaces::Ten:
    return "10";
  case ManyFaces::Hundred:
    return "100";
  case ManyFaces::Hundredth:
    break;
  case ManyFaces::OneAChart:
    return "charts";
  }
  return "hundredth";
}

ManyFaces manyFacesFromId(const std::string& id) {
  for (const ManyFaces many : kManyFaces) {
    if (id == manyFacesId(many)) return many;
  }
  return ManyFaces::Hundredth;
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
