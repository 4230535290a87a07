#include "core/samples/samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/samples/sample_shapes.h"

namespace chartflood {

namespace {

/// Makes a shape with edges of about a length.
using Maker = InputMesh (*)(double edge);
/// Says how many triangles that would be.
using Counter = std::size_t (*)(double edge);

template <Maker maker>
std::size_t countByMaking(double edge) {
  return maker(edge).faceCount();
}

struct Shape {
  Maker make;
  Counter count;
};

template <Maker maker>
constexpr Shape kShape = {maker, countByMaking<maker>};

constexpr std::array<SampleInfo, 13> kSamples = {{
    {"rocket", "Rocket", "Toy rocket with soft body, sharp fins, nozzle and portholes.", 40000},
    {"gear", "Gear wheel", "Machined part with a bore, fillets and sharp teeth.", 30000},
    {"knot", "Twisted knot", "Hollowed square band along a trefoil knot, four sharp edges.", 36000},
    {"double-torus", "Double torus", "Smooth surface with two holes.", 20000},
    {"torus", "Torus", "Ring, bent both ways; genus 1.", 16000},
    {"sphere", "Sphere", "The same bend everywhere; Gauss area 4 pi.", 20480},
    {"cube", "Cube", "Six flat sides; all Gauss area lies in the corners and edges.", 10800},
    {"l-block", "L block", "Three cubes with an inward edge.", 15000},
    {"cylinder", "Cylinder", "Closed; all Gauss area lies on its two rims.", 12000},
    {"tube", "Tube", "Cylinder without ends; unrolls without stretch.", 8000},
    {"cone", "Cone", "Without base; all Gauss area lies at its tip.", 8000},
    {"bumps", "Bumps", "Square with hills and hollows.", 16000},
    {"plane", "Plane", "Flat square; no Gauss area at all.", 4000},
}};

/// In the order of kSamples.
constexpr std::array<Shape, kSamples.size()> kShapes = {
    kShape<makeRocket>,   kShape<makeGear>,   kShape<makeKnot>, {makeDoubleTorus, countDoubleTorus},
    kShape<makeTorus>,    kShape<makeSphere>, kShape<makeCube>, kShape<makeLBlock>,
    kShape<makeCylinder>, kShape<makeTube>,   kShape<makeCone>, kShape<makeBumps>,
    kShape<makePlane>};

/// The edge length that gives the number of triangles nearest to the wanted one. The number falls
/// with the square of the length, but rows and columns are whole, so that few triangles come in
/// jumps; then lengths around the best one are tried as well.
class EdgeSearch {
 public:
  EdgeSearch(const Shape& shape, double wanted) : shape_(shape), wanted_(wanted) {}

  double find() {
    double edge = 0.2, count = attempt(edge);
    for (int i = 0; i < 4 && miss_ > 0.03; ++i) {
      edge *= std::sqrt(count / wanted_);
      count = attempt(edge);
    }
    const double middle = best_;
    for (int i = -8; i <= 8 && miss_ > 0.03; ++i) attempt(middle * (1 + 0.02 * i));
    return best_;
  }

 private:
  double attempt(double edge) {
    const double count = static_cast<double>(shape_.count(edge));
    const double miss = std::abs(std::log(count / wanted_));
    if (miss < miss_) {
      miss_ = miss;
      best_ = edge;
    }
    return count;
  }

  const Shape& shape_;
  double wanted_;
  double best_ = 0, miss_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::span<const SampleInfo> sampleTable() { return kSamples; }

std::shared_ptr<const InputMesh> makeSample(std::string_view id, std::size_t triangles) {
  if (triangles > kMostSampleTriangles) {
    throw UsageError("A sample of " + std::to_string(triangles) + " triangles cannot be made: " +
                     std::to_string(kMostSampleTriangles) + " are the most.");
  }
  for (std::size_t i = 0; i < kSamples.size(); ++i) {
    if (id != kSamples[i].id) continue;
    const std::size_t wanted = triangles == 0 ? kSamples[i].defaultTriangles : triangles;
    InputMesh mesh = kShapes[i].make(EdgeSearch(kShapes[i], static_cast<double>(wanted)).find());
    mesh.file = std::string(id);
    // The shapes are built around a z axis that points up; viewers take y for that.
    for (glm::dvec3& p : mesh.positions) p = {p.x, p.z, -p.y};
    mesh.shrink();
    return std::make_shared<const InputMesh>(std::move(mesh));
  }
  std::string known;
  for (const SampleInfo& sample : kSamples)
    known.append(known.empty() ? "" : ", ").append(sample.id);
  throw UsageError("There is no sample named \"" + std::string(id) + "\"; there are " + known +
                   ".");
}

}  // namespace chartflood
