#pragma once
/// The logs of a run's finished rounds, kept for looking back in bounded memory.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/model/flood_record.h"

namespace chartflood {

/// Which logs somebody will look at.
enum class FloodLogs {
  EveryRound,  ///< as far as a FloodHistory holds them
  LastRound,
  None,
};

/// A ring of logs: the oldest are dropped first, never the first round's, the best one's, the
/// newest's, nor the one that was asked for last.
class FloodHistory {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;

  FloodHistory() : FloodHistory(kMostBytes) {}
  explicit FloodHistory(std::size_t mostBytes) : mostBytes_(mostBytes) {}

  /// Forgets everything: another run begins.
  void clear();
  /// Keeps the whole log of a round, in place of an older one of the same round; `best` is the best
  /// round so far.
  void keep(std::size_t round, std::shared_ptr<const FloodRecord> record, std::size_t best);
  /// As keep(), of a round that somebody wants to look at: it stays until another is asked for.
  void recall(std::size_t round, std::shared_ptr<const FloodRecord> record);

  /// One entry a round, null where the log was dropped.
  std::span<const std::shared_ptr<const FloodRecord>> records() const { return records_; }
  /// What the kept logs occupy.
  std::size_t bytes() const { return bytes_; }

 private:
  void put(std::size_t round, std::shared_ptr<const FloodRecord> record);
  void shrink();

  std::size_t mostBytes_;
  std::size_t bytes_ = 0;
  std::size_t best_ = 0;
  std::size_t recalled_ = 0;
  std::vector<std::shared_ptr<const FloodRecord>> records_;
};

}  // namespace chartflood
