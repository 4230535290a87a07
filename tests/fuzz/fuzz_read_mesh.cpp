/// Fuzzer of the own readers and of glTF: the first byte chooses the format, the rest is the file.
/// What is read must be built, or refused with a ReadError.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/io/read/read_3mf.h"
#include "core/io/read/read_gltf.h"
#include "core/io/read/read_obj.h"
#include "core/io/read/read_off.h"
#include "core/io/read/read_ply.h"
#include "core/io/read/read_stl.h"
#include "core/model/build_mesh.h"

namespace {

using Reader = chartflood::InputMesh (*)(const chartflood::Source&);
constexpr Reader kReaders[] = {chartflood::readObj, chartflood::readPly,  chartflood::readOff,
                               chartflood::readStl, chartflood::readGltf, chartflood::read3mf};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return -1;
  const Reader reader = kReaders[data[0] % 6];
  // A copy of just this size, so that reading past the end is seen.
  const std::unique_ptr<char[]> bytes(new char[size - 1]);
  std::copy(data + 1, data + size, bytes.get());
  const chartflood::Source source{{bytes.get(), size - 1}, "fuzzed", "/nonexistent"};
  try {
    auto mesh = std::make_shared<chartflood::InputMesh>(reader(source));
    for (const chartflood::Index corner : mesh->corners) {
      if (corner >= mesh->positions.size()) std::abort();
    }
    chartflood::buildMesh(std::move(mesh));
  } catch (const chartflood::ReadError&) {
    return 0;
  }
  return 0;
}
