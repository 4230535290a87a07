// Good files with a few bytes changed: whatever the change, the program ends with a mesh or with
// one sentence. CHARTFLOOD_MUTATIONS=N tries so many, CHARTFLOOD_FIRST_MUTATION=N begins elsewhere.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/mutation_seeds.h"
#include "tests/support/run_program.h"

namespace chartflood {
namespace {

using test::SeedFile;
using testing::StartsWith;

/// A row of numbers that is the same everywhere (SplitMix64).
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(next() % n); }

 private:
  std::uint64_t state_;
};

/// Replaces a number of a text, if there is one behind the place.
void changeNumber(std::string& bytes, std::size_t at, Dice& dice) {
  constexpr std::array kNumbers = {"-1",    "0",      "4294967295", "2147483648",
                                   "1e999", "nan",    "65536",      "999999999999",
                                   "-0.0",  "1e-320", "x",          ""};
  constexpr const char* kDigits = "0123456789";
  const std::size_t begin = bytes.find_first_of(kDigits, at);
  if (begin == std::string::npos) return;
  const std::size_t end = std::min(bytes.find_first_not_of(kDigits, begin), bytes.size());
  bytes.replace(begin, end - begin, kNumbers[dice.below(kNumbers.size())]);
}

void mutate(std::string& bytes, Dice& dice) {
  if (bytes.empty()) return;
  const std::size_t at = dice.below(bytes.size());
  const std::size_t length = 1 + dice.below(dice.below(4) == 0 ? 400 : 8);
  switch (dice.below(9)) {
  case 0:
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << dice.below(8)));
    break;
  case 1:
    bytes[at] = static_cast<char>(dice.next());
    break;
  case 2:
    bytes.erase(at, length);
    break;
  case 3:
    bytes.insert(at, bytes.substr(dice.below(bytes.size()), length));
    break;
  case 4:
    bytes.insert(at, length, static_cast<char>(dice.next()));
    break;
  case 5:  // four bytes that are a large number, a negative one or none
    for (std::size_t i = at; i < std::min(at + 4, bytes.size()); ++i) {
      bytes[i] = static_cast<char>(dice.below(3) == 0 ? 0 : 0xff >> dice.below(2));
    }
    break;
  case 6:
    if (dice.below(4) == 0) bytes.resize(at);
    break;
  case 7: {  // one piece in the place of another, a changed reference in a text
    const std::string piece = bytes.substr(dice.below(bytes.size()), length);
    bytes.replace(at, std::min(piece.size(), bytes.size() - at), piece);
    break;
  }
  default:
    changeNumber(bytes, at, dice);
  }
}

/// The file with some changes: in its packed parts before they are packed, or in its bytes.
std::string mutated(const SeedFile& seed, Dice& dice) {
  SeedFile file = seed;
  const std::size_t changes = 1 + dice.below(6);
  const bool packed = !file.parts.empty();
  if (packed && dice.below(3) != 0) {
    for (std::size_t i = 0; i < changes; ++i) {
      mutate(file.parts[dice.below(file.parts.size())].second, dice);
    }
    return file.bytes();
  }
  std::string bytes = file.bytes();
  for (std::size_t i = 0; i < changes; ++i) mutate(bytes, dice);
  return bytes;
}

std::size_t fromEnvironment(const char* name, std::size_t otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

/// Whether what the program says is one sentence about the file.
void checkSentence(const std::string& errors, const std::string& file) {
  EXPECT_THAT(errors, StartsWith("chartflood: Could not read " + file + ": "));
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1);
  EXPECT_THAT(errors, testing::EndsWith(".\n"));
  EXPECT_LE(errors.size(), 300u);
  EXPECT_TRUE(
      std::all_of(errors.begin(), errors.end() - 1, [](char c) { return c >= ' ' && c <= '~'; }));
}

TEST(Mutations, EndWithAMeshOrOneSentence) {
  const std::vector<SeedFile> seeds = test::mutationSeeds();
  const std::size_t first = fromEnvironment("CHARTFLOOD_FIRST_MUTATION", 0);
  const std::size_t count = fromEnvironment("CHARTFLOOD_MUTATIONS", 12 * seeds.size());
  std::size_t read = 0, refused = 0;
  const TemporaryFolder folder;
  for (std::size_t number = first; number < first + count; ++number) {
    const SeedFile& seed = seeds[number % seeds.size()];
    Dice dice(number);
    const std::string name = "mutated." + seed.extension;
    folder.write(name, mutated(seed, dice));
    const ProgramRun run =
        runProgramIn(folder.path(),
                     {"/usr/bin/timeout", "60", CHARTFLOOD_PROGRAM, "--charts=3",
                      "--max-iterations=2", "--export-labels=labels.txt", "--verbose=error", name});
    SCOPED_TRACE("mutation " + std::to_string(number) + " of " + seed.name + ": exit " +
                 std::to_string(run.exitCode) + ", " + run.errors);
    EXPECT_TRUE(run.exitCode == 0 || run.exitCode == 1);
    run.exitCode == 0 ? ++read : ++refused;
    if (run.exitCode == 0) {
      EXPECT_EQ(run.errors, "");
    } else {
      checkSentence(run.errors, name);
    }
  }
  RecordProperty("read", static_cast<int>(read));
  RecordProperty("refused", static_cast<int>(refused));
  // Changes that are all harmless, or none, would try nothing.
  if (count >= seeds.size()) {
    EXPECT_GT(read, 0u);
    EXPECT_GT(refused, 0u);
  }
}

TEST(Mutations, SeedsAreGoodFiles) {
  const TemporaryFolder folder;
  for (const SeedFile& seed : test::mutationSeeds()) {
    folder.write("seed." + seed.extension, seed.bytes());
    const ProgramRun run =
        runProgramIn(folder.path(), {CHARTFLOOD_PROGRAM, "--info", "seed." + seed.extension});
    EXPECT_EQ(run.exitCode, 0) << seed.name << ": " << run.errors;
  }
}

}  // namespace
}  // namespace chartflood
