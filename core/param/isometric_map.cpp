#include "core/param/isometric_map.h"

#include <algorithm>
#include <cmath>

#include "core/param/border_crossings.h"
#include "core/param/isometric_energy.h"

namespace chartflood {

namespace {

constexpr double kProximal = 1e-6;  // of a second derivative of about 4 a vertex
constexpr double kSafeShare = 0.8;  // of the step at which a triangle would vanish
constexpr int kHoldBacks = 6;       // solves of one step with more weight on crossing vertices
constexpr double kHoldFactor = 30, kLeastHold = 1e-2, kHoldDecay = 0.3;
constexpr double kLeastDamping = 1e-12;
constexpr int kHalvings = 30;
constexpr double kFar = 1.3;  // energy from which reweighted steps are better

class Descent {
 public:
  Descent(const ChartShape& shape, const IsometricOptions& options, const Progress& progress,
          std::vector<glm::dvec2>& uv)
      : shape_(shape), progress_(progress), guard_(options.guardBoundary),
        fix_(options.fixBoundary), uv_(uv), system_(shape.pattern), hold_(uv.size(), kProximal),
        gradient_(uv.size()), direction_(uv.size()), trial_(uv.size()),
        energy_(isometricEnergy(shape.rest, uv)) {}

  double energy() const { return energy_; }

  /// False when no step lowers the energy, or when it was stopped on the way.
  bool step(StepModel model) {
    for (int attempt = 0;; ++attempt) {
      if (!solve(model) || progress_.cancelled()) return false;
      double length = std::min(1.0, kSafeShare * largestStep(shape_.rest, uv_, direction_));
      if (guard_ && attempt < kHoldBacks) {
        move(length);
        if (findCrossings(shape_.boundary, trial_, Contact::Any, crossing_)) {
          holdBack();
          continue;
        }
      }
      return search(length);
    }
  }

 private:
  bool solve(StepModel model) {
    system_.clear();
    std::fill(gradient_.begin(), gradient_.end(), glm::dvec2(0));
    addIsometricModel(shape_.rest, uv_, model, system_, gradient_);
    if (progress_.cancelled()) return false;
    for (Index v = 0; v < uv_.size(); ++v) system_.addDiagonal(v, glm::dmat2(hold_[v]));
    if (fix_) {
      system_.fix(shape_.onBoundary);
      for (const Index v : shape_.boundary) gradient_[v] = glm::dvec2(0);
    }
    // Where triangles have almost collapsed, rounding can take definiteness away.
    double damping = kLeastDamping;
    while (!system_.factor()) {
      if (damping > 1) return false;
      system_.damp(damping);
      damping *= 100;
    }
    // Each of these takes tens of milliseconds on the largest charts.
    if (progress_.cancelled()) return false;
    for (std::size_t v = 0; v < uv_.size(); ++v) direction_[v] = -gradient_[v];
    system_.solve(direction_);
    return true;
  }

  void move(double length) {
    for (std::size_t v = 0; v < uv_.size(); ++v) trial_[v] = uv_[v] + length * direction_[v];
  }

  void holdBack() {
    for (std::size_t i = 0; i < shape_.boundary.size(); ++i) {
      if (!crossing_[i]) continue;
      for (const std::size_t j : {i, (i + 1) % shape_.boundary.size()}) {
        double& hold = hold_[shape_.boundary[j]];
        hold = std::max(kLeastHold, hold * kHoldFactor);
      }
    }
  }

  bool search(double length) {
    double slope = 0;
    for (std::size_t v = 0; v < uv_.size(); ++v) {
      slope += gradient_[v].x * direction_[v].x + gradient_[v].y * direction_[v].y;
    }
    if (!(slope < 0)) return false;
    for (int halving = 0; halving < kHalvings && !progress_.cancelled(); ++halving, length *= 0.5) {
      move(length);
      const double energy = isometricEnergy(shape_.rest, trial_);
      if (!(energy < energy_ + 1e-4 * length * slope)) continue;
      if (guard_ && findCrossings(shape_.boundary, trial_, Contact::Any, crossing_)) continue;
      uv_.swap(trial_);
      energy_ = energy;
      for (double& hold : hold_) hold = std::max(kProximal, hold * kHoldDecay);
      return true;
    }
    return false;
  }

  const ChartShape& shape_;
  const Progress& progress_;
  bool guard_, fix_;
  std::vector<glm::dvec2>& uv_;
  SparseLdl<glm::dmat2> system_;
  std::vector<double> hold_;  // proximal weight of each vertex
  std::vector<glm::dvec2> gradient_, direction_, trial_;
  std::vector<bool> crossing_;
  double energy_;
};

}  // namespace

double minimiseIsometric(const ChartShape& shape, const IsometricOptions& options,
                         const Progress& progress, std::vector<glm::dvec2>& uv) {
  Descent descent(shape, options, progress, uv);
  // Reweighted steps as long as each takes half of the way to an isometry.
  StepModel model = descent.energy() > kFar ? StepModel::Reweighted : StepModel::Newton;
  for (int step = 0; step < options.steps && !progress.cancelled(); ++step) {
    const double before = descent.energy();
    const bool moved = descent.step(model);
    const double fall = before - descent.energy();
    if (model == StepModel::Reweighted) {
      if (!moved || fall < 0.5 * (before - 1)) model = StepModel::Newton;
    } else if (!moved || fall < options.tolerance * descent.energy()) {
      break;
    }
  }
  return descent.energy();
}

}  // namespace chartflood
