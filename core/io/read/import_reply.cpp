#include "core/io/read/import_reply.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

namespace chartflood {

namespace {

constexpr std::array<char, 8> kMark = {'C', 'F', 'I', 'M', 'P', 'O', 'R', '2'};
constexpr std::size_t kLongestReason = 4096;

struct Head {
  std::array<char, 8> mark = kMark;
  ImportOutcome outcome = ImportOutcome::Refused;
  std::uint32_t reasonLength = 0;
  std::uint64_t positions = 0, corners = 0, faceStarts = 0, pointsAndLines = 0, repairs = 0;
};
static_assert(std::is_trivially_copyable_v<Head> && sizeof(Head) == 56);

/// What comes before the words of a repair.
struct RepairHead {
  std::uint64_t count = 0;
  std::uint32_t whatLength = 0, textLength = 0;
};
static_assert(std::is_trivially_copyable_v<RepairHead> && sizeof(RepairHead) == 16);

using Put = std::function<bool(std::span<const std::byte>)>;
using Get = std::function<bool(std::span<std::byte>)>;

bool putRepair(const Repair& repair, const Put& put) {
  const RepairHead head{repair.count, static_cast<std::uint32_t>(repair.what.size()),
                        static_cast<std::uint32_t>(repair.text.size())};
  return put(std::as_bytes(std::span(&head, 1))) && put(std::as_bytes(std::span(repair.what))) &&
         put(std::as_bytes(std::span(repair.text)));
}

bool getRepair(Repair& repair, const Get& get) {
  RepairHead head;
  if (!get(std::as_writable_bytes(std::span(&head, 1)))) return false;
  if (head.whatLength > kLongestReason || head.textLength > kLongestReason) return false;
  repair.count = static_cast<std::size_t>(head.count);
  repair.what.resize(head.whatLength);
  repair.text.resize(head.textLength);
  return get(std::as_writable_bytes(std::span(repair.what))) &&
         get(std::as_writable_bytes(std::span(repair.text)));
}

bool getRepairs(std::vector<Repair>& repairs, std::uint64_t count, const Get& get) {
  constexpr std::uint64_t kMostRepairs = 100;
  if (count > kMostRepairs) return false;
  repairs.resize(static_cast<std::size_t>(count));
  return std::all_of(repairs.begin(), repairs.end(),
                     [&](Repair& repair) { return getRepair(repair, get); });
}

template <class T>
bool take(std::vector<T>& values, std::uint64_t count, std::size_t& room, const Get& get) {
  if (count > room / sizeof(T)) return false;
  room -= static_cast<std::size_t>(count) * sizeof(T);
  values.resize(static_cast<std::size_t>(count));
  return get(std::as_writable_bytes(std::span(values)));
}

/// Whether faces and corners name what is there.
bool isConsistent(const InputMesh& mesh) {
  const std::vector<std::size_t>& starts = mesh.faceStart;
  if (starts.empty()) {
    if (mesh.corners.size() % 3 != 0) return false;
  } else if (starts.front() != 0 || starts.back() != mesh.corners.size() ||
             !std::is_sorted(starts.begin(), starts.end())) {
    return false;
  }
  return std::all_of(mesh.corners.begin(), mesh.corners.end(),
                     [&](Index corner) { return corner < mesh.positions.size(); });
}

}  // namespace

bool writeImportReply(const ImportReply& reply,
                      const std::function<bool(std::span<const std::byte>)>& put) {
  Head head;
  head.outcome = reply.outcome;
  const std::string_view reason = std::string_view(reply.reason).substr(0, kLongestReason);
  head.reasonLength = static_cast<std::uint32_t>(reason.size());
  head.positions = reply.mesh.positions.size();
  head.corners = reply.mesh.corners.size();
  head.faceStarts = reply.mesh.faceStart.size();
  head.pointsAndLines = reply.pointsAndLines;
  head.repairs = reply.mesh.repairs.size();
  return put(std::as_bytes(std::span(&head, 1))) && put(std::as_bytes(std::span(reason))) &&
         put(std::as_bytes(std::span(reply.mesh.positions))) &&
         put(std::as_bytes(std::span(reply.mesh.corners))) &&
         put(std::as_bytes(std::span(reply.mesh.faceStart))) &&
         std::all_of(reply.mesh.repairs.begin(), reply.mesh.repairs.end(),
                     [&](const Repair& repair) { return putRepair(repair, put); });
}

bool readImportReply(ImportReply& reply, std::size_t longest,
                     const std::function<bool(std::span<std::byte>)>& get) {
  Head head;
  if (!get(std::as_writable_bytes(std::span(&head, 1)))) return false;
  if (head.mark != kMark || head.reasonLength > kLongestReason) return false;
  reply.outcome = head.outcome;
  reply.pointsAndLines = head.pointsAndLines;
  reply.reason.resize(head.reasonLength);
  if (!get(std::as_writable_bytes(std::span(reply.reason)))) return false;
  std::size_t room = longest;
  return take(reply.mesh.positions, head.positions, room, get) &&
         take(reply.mesh.corners, head.corners, room, get) &&
         take(reply.mesh.faceStart, head.faceStarts, room, get) &&
         getRepairs(reply.mesh.repairs, head.repairs, get) && isConsistent(reply.mesh);
}

}  // namespace chartflood
