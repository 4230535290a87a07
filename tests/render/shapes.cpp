#include "tests/render/shapes.h"

#include <array>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "core/model/build_mesh.h"

namespace chartflood::test {

namespace {

std::shared_ptr<InputMesh> cubeInput(int n, bool quads) {
  auto input = std::make_shared<InputMesh>();
  input->file = "cube";
  std::map<std::array<int, 3>, Index> numbers;
  const auto vertex = [&](int axis, int side, int a, int b) {
    std::array<int, 3> place{};
    place[static_cast<std::size_t>(axis)] = side * n;
    place[static_cast<std::size_t>((axis + 1) % 3)] = a;
    place[static_cast<std::size_t>((axis + 2) % 3)] = b;
    const auto [at, isNew] =
        numbers.try_emplace(place, static_cast<Index>(input->positions.size()));
    if (isNew) input->positions.emplace_back(place[0], place[1], place[2]);
    return at->second;
  };
  if (quads) input->faceStart.push_back(0);
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          std::array<Index, 4> square{vertex(axis, side, i, j), vertex(axis, side, i + 1, j),
                                      vertex(axis, side, i + 1, j + 1),
                                      vertex(axis, side, i, j + 1)};
          if (side == 0) std::swap(square[1], square[3]);
          if (quads) {
            input->corners.insert(input->corners.end(), square.begin(), square.end());
            input->faceStart.push_back(input->corners.size());
          } else {
            for (const int c : {0, 1, 2, 0, 2, 3}) {
              input->corners.push_back(square[static_cast<std::size_t>(c)]);
            }
          }
        }
      }
    }
  }
  return input;
}

}  // namespace

std::shared_ptr<const Mesh> cube(int n) { return buildMesh(cubeInput(n, false)); }

std::shared_ptr<const Mesh> quadCube(int n) { return buildMesh(cubeInput(n, true)); }

namespace {

std::shared_ptr<InputMesh> ballInput(int n) {
  const auto input = cubeInput(n, false);
  for (glm::dvec3& p : input->positions) p = glm::normalize(2.0 * p / double(n) - 1.0);
  return input;
}

}  // namespace

std::shared_ptr<const Mesh> ball(int n) { return buildMesh(ballInput(n)); }

std::shared_ptr<const Mesh> ballInsideOut(int n) {
  const auto input = ballInput(n);
  for (std::size_t c = 0; c < input->corners.size(); c += 3) {
    std::swap(input->corners[c + 1], input->corners[c + 2]);
  }
  return buildMesh(input);
}

std::shared_ptr<const Mesh> plate(int columns, int rows) {
  auto input = std::make_shared<InputMesh>();
  input->file = "plate";
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) input->positions.emplace_back(x, y, 0);
  }
  const auto vertex = [&](int x, int y) { return static_cast<Index>(y * (columns + 1) + x); };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      for (const Index corner : {vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y),
                                 vertex(x + 1, y + 1), vertex(x, y + 1)}) {
        input->corners.push_back(corner);
      }
    }
  }
  return buildMesh(input);
}

}  // namespace chartflood::test
