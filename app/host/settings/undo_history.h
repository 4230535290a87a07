#pragma once
/// Undo and redo of a value: keeps whole old values, which are cheap to copy.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace chartflood {

/// A drag is one entry: changes with the same key that follow each other are merged until `close`.
template <typename Value>
class UndoHistory {
 public:
  /// Remembers that `before` was left by a change called `name`. While an entry with the same
  /// `key` is open the older value stays, so that a drag undoes in one step.
  void changed(const Value& before, std::string name, const std::string& key) {
    redo_.clear();
    if (open_ && !undo_.empty() && openKey_ == key) {
      undo_.back().name = std::move(name);
      return;
    }
    undo_.push_back({before, std::move(name)});
    if (undo_.size() > kMost) undo_.erase(undo_.begin());
    open_ = true;
    openKey_ = key;
  }
  /// Ends the open entry: the next change is one of its own.
  void close() { open_ = false; }

  /// The older value of the entry that a change with this key would join; null: none.
  const Value* joined(const std::string& key) const {
    return open_ && !undo_.empty() && openKey_ == key ? &undo_.back().value : nullptr;
  }
  /// The older value of the open entry, which is forgotten as if it had never been; nothing when
  /// none is open.
  std::optional<Value> takeBack() {
    if (!open_ || undo_.empty()) return std::nullopt;
    Value value = std::move(undo_.back().value);
    undo_.pop_back();
    open_ = false;
    return value;
  }

  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }
  /// What the next undo or redo would take back or repeat; "" if there is nothing.
  std::string undoName() const { return canUndo() ? undo_.back().name : std::string(); }
  std::string redoName() const { return canRedo() ? redo_.back().name : std::string(); }
  std::size_t size() const { return undo_.size(); }

  /// The value to go back to. Needs canUndo().
  Value undo(const Value& present) { return move(undo_, redo_, present); }
  /// The value to go forward to. Needs canRedo().
  Value redo(const Value& present) { return move(redo_, undo_, present); }
  void clear() {
    undo_.clear();
    redo_.clear();
    open_ = false;
  }

 private:
  static constexpr std::size_t kMost = 200;

  struct Entry {
    Value value;
    std::string name;
  };

  Value move(std::vector<Entry>& from, std::vector<Entry>& to, const Value& present) {
    Entry entry = std::move(from.back());
    from.pop_back();
    to.push_back({present, entry.name});
    open_ = false;
    return entry.value;
  }

  std::vector<Entry> undo_, redo_;
  bool open_ = false;
  std::string openKey_;
};

}  // namespace chartflood
