#include "core/session/pipeline/flood_history.h"

#include <utility>

namespace chartflood {

namespace {
std::size_t bytesOf(const std::shared_ptr<const FloodRecord>& record) {
  return record ? record->capacity() * sizeof(Incorporation) : 0;
}
}  // namespace

void FloodHistory::clear() {
  records_.clear();
  bytes_ = best_ = recalled_ = 0;
}

void FloodHistory::put(std::size_t round, std::shared_ptr<const FloodRecord> record) {
  if (round >= records_.size()) records_.resize(round + 1);
  bytes_ += bytesOf(record) - bytesOf(records_[round]);
  records_[round] = std::move(record);
}

void FloodHistory::keep(std::size_t round, std::shared_ptr<const FloodRecord> record,
                        std::size_t best) {
  put(round, std::move(record));
  best_ = best;
  shrink();
}

void FloodHistory::recall(std::size_t round, std::shared_ptr<const FloodRecord> record) {
  put(round, std::move(record));
  recalled_ = round;
  shrink();
}

void FloodHistory::shrink() {
  for (std::size_t round = 1; round + 1 < records_.size() && bytes_ > mostBytes_; ++round) {
    if (round == best_ || round == recalled_) continue;
    bytes_ -= bytesOf(records_[round]);
    records_[round].reset();
  }
}

}  // namespace chartflood
