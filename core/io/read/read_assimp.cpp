#include "core/io/read/read_assimp.h"

#include <array>
#include <cctype>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/counted.h"
#include "core/io/read/child_process.h"
#include "core/io/read/import_limits.h"
#include "core/io/read/import_reply.h"

namespace chartflood {

namespace {

constexpr const char* kImportProgram = "chartflood-import";
constexpr const char* kInstead = "; save it as glTF or OBJ in the program that made it";

/// Beside this program, or where installations keep programs that only programs call; none when it
/// is in neither place.
std::optional<std::filesystem::path> importProgram() {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  const std::filesystem::path folder = self.parent_path();
  const std::array places = {folder / kImportProgram,
                             folder.parent_path() / "libexec" / "chartflood" / kImportProgram};
  for (const std::filesystem::path& place : places) {
    if (std::filesystem::is_regular_file(place, error)) return place;
  }
  return std::nullopt;
}

/// Words of the library as part of a sentence: one line of plain letters, not too long.
std::string cleaned(std::string_view words) {
  constexpr std::size_t kLongest = 100;
  std::string text;
  for (const char c : words.substr(0, words.find_first_of("\r\n"))) {
    const bool plain = c > ' ' && c < 0x7f;
    if (plain) text.push_back(c);
    if (!plain && !text.empty() && text.back() != ' ') text.push_back(' ');
  }
  if (text.size() > kLongest) {
    text.resize(kLongest);
    if (const std::size_t at = text.rfind(' '); at != std::string::npos) text.resize(at);
    text += " ..";
    return text;
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

/// How files begin that are packed as Blender does since 3.0.
constexpr std::string_view kBlenderPacking = "\x28\xb5\x2f\xfd";

/// The version in the head of a Blender file, 402 for 4.2; 300 for one in the packing that came
/// with it; 0 when it is none or packed as before.
int blenderVersion(std::string_view bytes) {
  if (bytes.starts_with(kBlenderPacking)) return 300;
  if (!bytes.starts_with("BLENDER")) return 0;
  const std::size_t v = bytes.substr(0, 16).find_first_of("vV");
  if (v == std::string_view::npos) return 0;
  int version = 0;
  for (const char c : bytes.substr(v + 1, 4)) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) break;
    version = 10 * version + (c - '0');
  }
  return version;
}

/// Refuses the source; `cause` unless its format is younger than the library.
[[noreturn]] void refuse(const Source& source, std::string_view extension,
                         const std::string& cause) {
  constexpr int kKnown = 279;
  const int version = extension == "blend" ? blenderVersion(source.bytes) : 0;
  if (version <= kKnown) source.fail(cause);
  source.fail("it is of Blender " + std::to_string(version / 100) + "." +
              std::to_string(version % 100) +
              (source.bytes.starts_with(kBlenderPacking) ? " or later" : "") +
              ", whose files the import library knows in part; export glTF or OBJ from Blender");
}

/// Who works in the other program.
std::string worker(std::string_view extension) {
  return extension == kDracoGltf ? "Draco, which unpacks its geometry," : "the import library";
}

/// What to do about it, as the end of a sentence.
std::string instead(std::string_view extension) {
  return extension == kDracoGltf ? "; save it without Draco" : kInstead;
}

/// Why a program that gave no whole answer ended.
std::string causeOfEnd(int signal, std::string_view extension, const ImportLimits& limits) {
  const std::string who = worker(extension);
  if (signal == SIGXCPU) {
    return who + " was stopped after " +
           counted(static_cast<std::size_t>(limits.work.count()), "second", "seconds") + " of work";
  }
  if (signal == 0) return who + " gave no mesh";
  return who + " broke down over it (signal " + std::to_string(signal) + ")";
}

std::string causeOf(const ImportReply& reply, std::string_view extension,
                    const ImportLimits& limits) {
  if (reply.outcome == ImportOutcome::OutOfMemory) {
    return worker(extension) + " needs more than " +
           counted(limits.memory >> 20, "megabyte", "megabytes") + " of memory for it";
  }
  const std::string reason = cleaned(reply.reason);
  return reason.empty() ? "the import library does not know its content"
                        : "the import library refuses it (" + reason + ")";
}

ImportReply runImport(const Source& source, std::string_view extension,
                      const std::filesystem::path& program, bool& cancelled) {
  const ImportLimits limits(source.bytes.size(), extension);
  const auto deadline = std::chrono::steady_clock::now() + limits.wait;
  const std::string folder = source.folder.empty() ? "." : source.folder.string();
  ChildProcess child(program, {std::string(extension), folder}, source.bytes);
  ChildProcess::Read last = ChildProcess::Read::Done;
  ImportReply reply;
  const bool whole = readImportReply(reply, limits.memory, [&](std::span<std::byte> to) {
    last = child.read(to, deadline, [&] { return source.report(source.begin()); });
    return last == ChildProcess::Read::Done;
  });
  cancelled = last == ChildProcess::Read::Cancelled;
  if (whole || cancelled) return reply;
  if (last == ChildProcess::Read::TooLate) {
    refuse(source, extension,
           worker(extension) + " did not end in " +
               counted(static_cast<std::size_t>(limits.wait.count()), "second", "seconds") +
               instead(extension));
  }
  // An answer that contradicts itself is no answer; the program may still be writing it.
  const int signal = last == ChildProcess::Read::Ended ? child.waitForEnd() : 0;
  refuse(source, extension, causeOfEnd(signal, extension, limits) + instead(extension));
}

/// The program's answer; nothing when it was cancelled.
std::optional<ImportReply> replyOf(const Source& source, std::string_view extension) {
  const std::string words = std::string("the program ") + kImportProgram + ", which reads " +
                            (extension == kDracoGltf ? std::string("glTF that Draco compressed")
                                                     : "." + std::string(extension));
  const std::optional<std::filesystem::path> program = importProgram();
  if (!program) source.fail(words + ", is not beside this one; install chartflood anew");
  bool cancelled = false;
  try {
    ImportReply reply = runImport(source, extension, *program, cancelled);
    if (cancelled) return std::nullopt;
    return reply;
  } catch (const std::system_error& error) {
    source.fail(words + ", could not be started (" + std::strerror(error.code().value()) +
                "); try again");
  }
}

}  // namespace

InputMesh readDracoGltf(const Source& source) {
  std::optional<ImportReply> reply = replyOf(source, kDracoGltf);
  if (!reply) return {};
  if (reply->outcome == ImportOutcome::Mesh) return std::move(reply->mesh);
  if (reply->outcome == ImportOutcome::Refused) source.fail(reply->reason);
  source.fail(causeOf(*reply, kDracoGltf, ImportLimits(source.bytes.size(), kDracoGltf)) +
              instead(kDracoGltf));
}

InputMesh readAssimp(const Source& source, std::string_view extension) {
  std::optional<ImportReply> answer = replyOf(source, extension);
  if (!answer) return {};
  ImportReply& reply = *answer;
  if (reply.outcome != ImportOutcome::Mesh) {
    const ImportLimits limits(source.bytes.size(), extension);
    refuse(source, extension, causeOf(reply, extension, limits) + kInstead);
  }
  if (reply.mesh.faceCount() == 0) refuse(source, extension, "it has no faces");
  if (reply.pointsAndLines > 0) {
    const auto count = static_cast<std::size_t>(reply.pointsAndLines);
    reply.mesh.repairs.push_back(
        {"points-and-lines-ignored", count,
         counted(count, "point or line was", "points or lines were") + " left out."});
  }
  return std::move(reply.mesh);
}

}  // namespace chartflood
