#pragma once
/// Files appear complete or not at all: written aside, then renamed.

#include <filesystem>
#include <span>
#include <string_view>

namespace chartflood {

/// Content that waits beside its target. Writers of several files stage all of them first and
/// commit them afterwards, so that a failure leaves every target as it was.
class StagedFile {
 public:
  /// Writes `bytes` to a new file in the folder of `target`. A target that is a symbolic link
  /// stays one: the file that it leads to is replaced.
  /// \throws WriteError when the folder does not exist or may not be written to, the disk is full,
  ///   or the target is a folder, a device or write-protected.
  StagedFile(const std::filesystem::path& target, std::string_view bytes);
  /// Removes the file aside unless it was committed.
  ~StagedFile();
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;

  /// Puts the content in the target's place, in one step. \throws WriteError
  void commit();

 private:
  void discard();

  std::filesystem::path asked_;   ///< as the user wrote it, for messages
  std::filesystem::path target_;  ///< behind symbolic links
  std::filesystem::path aside_;   ///< empty once nothing is left to remove
};

/// Puts all of them in their places, which no interruption divides. \throws WriteError
void commitAll(std::span<StagedFile> files);

/// Removes what waits beside its target: for ends that run no destructors. Waits for nobody.
void removeStagedFiles() noexcept;

/// Replaces or creates one file. When it fails, or is interrupted, the old file is as it was.
/// \throws WriteError with the cause
void writeFileAtomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace chartflood
