#pragma once
/// Values worked out beside the window's thread, again only when what they depend on has changed.

#include <memory>
#include <optional>
#include <utility>

#include "app/host/insight/errand.h"

namespace chartflood {

/// Keeps the newest finished value. Not for several threads: all calls come from one.
template <typename Key, typename Value>
class LazyValue {
 public:
  /// The value for `key`, or the last one finished before while it is worked out; null at first.
  /// `make()` runs on another thread and must own all that it reads. While one value is under way
  /// no other is begun, so that changes in quick succession cost little.
  template <typename Make>
  std::shared_ptr<const Value> get(const Key& key, const WorkPlace& place, Make make) {
    if (auto made = errand_.take()) value_ = std::move(*made);
    if ((asked_ && *asked_ == key) || errand_.running()) return value_;
    asked_ = key;
    if (place.immediate) {
      value_ = std::make_shared<const Value>(make());
    } else {
      errand_.begin(place.wake, [make = std::move(make)]() mutable {
        return std::make_shared<const Value>(make());
      });
    }
    return value_;
  }

 private:
  std::optional<Key> asked_;
  std::shared_ptr<const Value> value_;
  Errand<std::shared_ptr<const Value>> errand_;
};

}  // namespace chartflood
