#pragma once
/// A copy of the running session on disk, so that a crash loses nothing. Every process has a copy
/// of its own; those of processes that are gone are found by the next start.

#include <filesystem>
#include <future>
#include <string>
#include <vector>

namespace chartflood {

/// Off until begin(). What cannot be written is told by the log, never by an error: the copy is a
/// net below the work, not a part of it.
class Recovery {
 public:
  Recovery() = default;
  /// Leaves the own copy where it is; see end().
  ~Recovery();
  Recovery(const Recovery&) = delete;
  Recovery& operator=(const Recovery&) = delete;

  /// Takes a name of its own in `folder`, which is made when it is missing, and looks for copies
  /// that nobody holds any more.
  void begin(const std::filesystem::path& folder);
  bool on() const { return lock_ >= 0; }

  /// Writes the copy by a thread of its own. False while the last one is still being written: ask
  /// again later.
  bool write(std::string text);
  /// Removes the copy.
  void drop();
  /// Removes the copy and is off from now on: a clean end has nothing to recover. The only way in
  /// which the end of the program removes it.
  void end();
  /// Where the copy stands.
  const std::filesystem::path& file() const { return file_; }

  /// Copies that other processes left behind, newest first.
  const std::vector<std::filesystem::path>& left() const { return left_; }
  /// Model of the first of them and when it was written, "bunny.obj, 1 Dec 14:05"; "" without any.
  const std::string& leftTitle() const { return leftTitle_; }
  /// Removes the first of them.
  void forget();
  /// Makes one of them the own copy, so that there is one at any moment.
  void adopt(const std::filesystem::path& copy);

 private:
  void finishWriting();
  void nameLeft();

  std::filesystem::path file_;
  int lock_ = -1;  ///< descriptor; the system lets go of it however the process ends
  std::vector<std::filesystem::path> left_;
  std::string leftTitle_;
  std::future<void> writing_;
};

}  // namespace chartflood
