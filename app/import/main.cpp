/// chartflood-import EXTENSION FOLDER: reads a mesh file from standard input with the import
/// library (or Draco, for glTF) and writes it as bytes to standard output. Called by chartflood;
/// whatever happens in the libraries, by accident or by a file made for it, happens here, within
/// limits of memory and time.

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/import/draco_mesh.h"
#include "app/import/folder_files.h"
#include "app/import/scene_mesh.h"
#include "core/base/error.h"
#include "core/io/read/import_limits.h"
#include "core/io/read/import_reply.h"
#include "core/io/read/read_gltf.h"

namespace {

using namespace chartflood;

bool put(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
  return true;
}

/// Leaves without taking anything down: the library's own cleaning up is one of its dangers.
[[noreturn]] void answer(const ImportReply& reply) { _exit(writeImportReply(reply, put) ? 0 : 1); }

[[noreturn]] void answerOutOfMemory() {
  ImportReply reply;
  reply.outcome = ImportOutcome::OutOfMemory;
  answer(reply);
}

void limit(int resource, rlim_t value) {
  rlimit now{};
  if (getrlimit(resource, &now) != 0) return;
  const rlim_t most = now.rlim_max == RLIM_INFINITY ? value : std::min(value, now.rlim_max);
  now.rlim_cur = most;
  setrlimit(resource, &now);
}

void setLimits(const ImportLimits& limits) {
  // Sanitizers reserve far more addresses than they use.
#if !defined(CHARTFLOOD_SHADOW_MEMORY)
  limit(RLIMIT_AS, limits.memory);
#endif
  limit(RLIMIT_CPU, static_cast<rlim_t>(limits.work.count()));
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::set_new_handler(answerOutOfMemory);
}

std::vector<char> readInput(std::size_t size) {
  std::vector<char> bytes(size);
  for (std::size_t done = 0; done < size;) {
    const ssize_t got =
        pread(STDIN_FILENO, bytes.data() + done, size - done, static_cast<off_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) _exit(1);
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

std::string replaced(std::string words, const std::string& old, std::string_view by) {
  for (std::size_t at = 0; (at = words.find(old, at)) != std::string::npos; at += by.size()) {
    words.replace(at, old.size(), by);
  }
  return words;
}

ImportReply runImport(std::string_view bytes, const std::string& extension,
                      const std::string& folder) {
  // A name of our own, so that nothing depends on how the file is called; absolute, because the
  // library puts its folder before what is named in the file.
  const std::filesystem::path place = std::filesystem::absolute(folder);
  const std::string name = (place / ("mesh." + extension)).string();
  ImportReply reply;
  Assimp::Importer& importer = *new Assimp::Importer;  // never taken down, see answer()
  importer.SetIOHandler(newFolderFiles(place, name, bytes));
  try {
    const aiScene* const scene = importer.ReadFile(name, 0);
    if (scene != nullptr) return meshOfScene(*scene);
    reply.reason = importer.GetErrorString();
  } catch (const std::exception& error) {
    reply.reason = error.what();
  }
  // What the library says, without the name that it was given and the folder of what it missed.
  reply.reason = replaced(replaced(std::move(reply.reason), name, "it"), (place / "").string(), "");
  return reply;
}

/// The own reader with Draco to unpack; its words need no cleaning.
ImportReply readDraco(std::string_view bytes, const std::string& folder) {
  ImportReply reply;
  try {
    reply.mesh = readGltf({bytes, "it", folder}, decodeDraco);
    reply.outcome = ImportOutcome::Mesh;
  } catch (const ReadError& error) {
    reply.reason = error.cause();
  } catch (const std::exception& error) {
    reply.reason = error.what();
  }
  return reply;
}

}  // namespace

int main(int argc, char** argv) {
  struct stat status = {};
  if (argc != 3 || fstat(STDIN_FILENO, &status) != 0 || !S_ISREG(status.st_mode)) {
    constexpr std::string_view kUsage = "chartflood-import is called by chartflood.\n";
    return write(STDERR_FILENO, kUsage.data(), kUsage.size()) < 0 ? 1 : 2;
  }
  const auto size = static_cast<std::size_t>(status.st_size);
  setLimits(ImportLimits(size, argv[1]));
  const std::vector<char> bytes = readInput(size);
  const std::string_view content(bytes.data(), bytes.size());
  answer(argv[1] == kDracoGltf ? readDraco(content, argv[2])
                               : runImport(content, argv[1], argv[2]));
}
