#include "core/segment/borders/border_refiner.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace chartflood {

namespace {

/// What seams may grow by, as a share, when single faces even out what the cuts left.
constexpr double kMostLonger = 0.03;

/// Coefficient of variation from which single faces are worth trying after the cuts. No charts are
/// more even than the size of a face, nor than their weight asks: at a deviation of sqrt(K) / (2 w)
/// a chart pulls at its border no harder than the border's own tension does.
double unevenFrom(std::size_t faces, std::size_t charts, double weight) {
  const double count = static_cast<double>(charts);
  return std::max({0.02, count / static_cast<double>(faces), std::sqrt(count) / weight});
}

/// Adds the differences between two sets of labels, pair by pair of charts.
void addDifference(SeamRecord& record, std::span<const Index> before,
                   std::span<const Index> after) {
  std::map<std::pair<Index, Index>, std::pair<std::vector<Index>, std::vector<Index>>> moved;
  for (Index f = 0; f < before.size(); ++f) {
    const Index from = before[f], to = after[f];
    if (from < to) moved[{from, to}].first.push_back(f);
    if (to < from) moved[{to, from}].second.push_back(f);
  }
  for (const auto& [pair, faces] : moved) {
    SeamStep step{pair.first, pair.second, record.faces.size(), 0, 0};
    record.faces.insert(record.faces.end(), faces.first.begin(), faces.first.end());
    step.toA = record.faces.size();
    record.faces.insert(record.faces.end(), faces.second.begin(), faces.second.end());
    step.end = record.faces.size();
    record.steps.push_back(step);
  }
}

}  // namespace

BorderRefiner::BorderRefiner(const SegmentInputs& inputs, std::span<const double> faceGauss,
                             std::vector<Index> label, std::size_t charts, std::vector<Index> seeds,
                             const RefineOptions& options)
    : in_(inputs), faceGauss_(faceGauss), options_(options), label_(std::move(label)),
      charts_(charts), seeds_(std::move(seeds)) {
  if (options_.kind == RefineKind::Cuts) {
    SeamCuts::Options cuts;
    cuts.weight = options_.balanceWeight;
    cuts.creaseWeight = options_.creaseWeight;
    cuts.eta = in_.floodGraph->eta;
    cuts.oneSided = options_.oneSided;
    cuts.sketch = options_.sketch;
    // A method's own cost has no way to full weight: charts would leave what it found.
    cuts.price = options_.price.get();
    cuts.anneal = options_.price == nullptr;
    if (options_.sideFactor) cuts.sideFactor = *options_.sideFactor;
    cuts_ = std::make_unique<SeamCuts>(*in_.mesh, *in_.gaussArea, faceGauss_, std::move(label_),
                                       charts_, seeds_, cuts);
  } else if (options_.kind == RefineKind::Moves) {
    start_ = label_;
    if (options_.price) options_.price->fit(label_);
    beginMoves();
  }
}

void BorderRefiner::beginMoves() {
  BorderMoves::Options moves{.weight = options_.cleanUp, .eta = in_.floodGraph->eta};
  if (cuts_) {
    moves.weight = options_.balanceWeight;
    moves.likeCuts = true;
    moves.creaseFactor = options_.creaseWeight;
    moves.mostLonger = kMostLonger;
  }
  if (options_.price) {
    moves.likeCuts = true;
    moves.price = options_.price.get();
  }
  if (options_.sideFactor) moves.sideFactor = *options_.sideFactor;
  moves_ = std::make_unique<BorderMoves>(*in_.mesh, *in_.gaussArea, faceGauss_, label_, charts_,
                                         seeds_, moves);
}

/// Single faces even out what the cuts left, by the energy of the cuts, where there is much. The
/// cuts' seams stay but for a few per cent of length.
void BorderRefiner::evenOutAfterCuts() {
  // One-sided balance lets charts be as small as their creases make them.
  if (options_.oneSided || options_.sketch || !(options_.balanceWeight > 0)) return;
  beginMoves();
  const double uneven = unevenFrom(in_.mesh->faceCount(), charts_, options_.balanceWeight);
  if (moves_->deviation() <= uneven) moves_.reset();
}

bool BorderRefiner::run(Progress& progress) {
  if (done_) return true;
  if (cuts_ && !moves_) {
    progress.beginPhase("Shortening seams");
    if (!cuts_->run(progress)) return false;
    label_.assign(cuts_->labels().begin(), cuts_->labels().end());
    evenOutAfterCuts();
  }
  if (moves_) {
    progress.beginPhase("Tidying borders");
    if (!moves_->run(progress)) return false;
    label_.assign(moves_->labels().begin(), moves_->labels().end());
  }
  if (cuts_ || moves_) finishRecord();
  cuts_.reset();
  moves_.reset();
  done_ = true;
  return true;
}

void BorderRefiner::finishRecord() {
  // Moves are sweeps over all borders at once: their steps are the differences they made, pair by
  // pair of charts.
  auto record = cuts_ ? std::make_shared<SeamRecord>(cuts_->record())
                      : std::make_shared<SeamRecord>(SeamRecord{std::move(start_), {}, {}});
  addDifference(*record, cuts_ ? cuts_->labels() : std::span<const Index>(record->start), label_);
  record_ = std::move(record);
}

}  // namespace chartflood
