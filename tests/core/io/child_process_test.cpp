// Programs beside this one: how they answer, how they end, and that nothing of them stays.

#include <chrono>
#include <csignal>
#include <filesystem>
#include <span>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "core/io/read/child_process.h"

namespace chartflood {
namespace {

using Read = ChildProcess::Read;

ChildProcess shell(const std::string& line, std::string_view input = "") {
  return ChildProcess("/bin/sh", {"-c", line}, input);
}

Read take(
    ChildProcess& child, std::string& text, std::chrono::milliseconds time,
    const std::function<bool()>& cancelled = [] { return false; }) {
  return child.read(std::as_writable_bytes(std::span(text)),
                    std::chrono::steady_clock::now() + time, cancelled);
}

std::size_t openDescriptors() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

TEST(ChildProcess, GivesBackWhatItIsGiven) {
  std::string input(3 << 20, '\0');
  for (std::size_t i = 0; i < input.size(); ++i) input[i] = static_cast<char>(i * i >> 5);
  ChildProcess child = shell("cat", input);
  std::string answer(input.size(), 'x');
  EXPECT_EQ(take(child, answer, std::chrono::seconds(60)), Read::Done);
  EXPECT_EQ(answer, input);
  std::string more(1, ' ');
  EXPECT_EQ(take(child, more, std::chrono::seconds(60)), Read::Ended);
  EXPECT_EQ(child.waitForEnd(), 0);
}

TEST(ChildProcess, TellsTheSignalThatEndedIt) {
  ChildProcess child = shell("kill -SEGV $$");
  std::string answer(1, ' ');
  EXPECT_EQ(take(child, answer, std::chrono::seconds(60)), Read::Ended);
  EXPECT_EQ(child.waitForEnd(), SIGSEGV);
}

TEST(ChildProcess, IsLeftWhenItTakesTooLongOrIsCancelled) {
  std::string answer(1, ' ');
  ChildProcess slow = shell("exec sleep 1000");
  EXPECT_EQ(take(slow, answer, std::chrono::milliseconds(50)), Read::TooLate);
  ChildProcess unwanted = shell("exec sleep 1000");
  EXPECT_EQ(take(unwanted, answer, std::chrono::seconds(60), [] { return true; }), Read::Cancelled);
}

TEST(ChildProcess, OneThatClosesItsAnswerAndGoesOnIsEnded) {
  ChildProcess child = shell("exec sleep 1000 > /dev/null");
  std::string answer(1, ' ');
  EXPECT_EQ(take(child, answer, std::chrono::seconds(60)), Read::Ended);
  EXPECT_EQ(child.waitForEnd(), SIGKILL);
}

TEST(ChildProcess, MissingProgramsAreAnError) {
  EXPECT_THROW(ChildProcess("/nonexistent/program", {}, ""), std::system_error);
}

/// Nothing of this program is open in it: of numbers above the standard streams only the one with
/// which the shell lists them.
TEST(ChildProcess, GetsItsStandardStreamsOnly) {
  const int leak = dup(STDERR_FILENO);
  ASSERT_GT(leak, STDERR_FILENO);
  ChildProcess child =
      shell("for n in 3 4 5 6 7 8 9; do [ -e /proc/$$/fd/$n ] && echo $n; done; echo .");
  std::string answer(1, ' ');
  EXPECT_EQ(take(child, answer, std::chrono::seconds(60)), Read::Done);
  EXPECT_EQ(answer, ".");
  close(leak);
}

TEST(ChildProcess, LeavesNothingBehind) {
  const std::size_t before = openDescriptors();
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([t] {
      for (int i = 0; i < 8; ++i) {
        const std::string word = std::to_string(10 + t);
        ChildProcess child = shell(i % 2 == 0 ? "cat; exec sleep 1000" : "cat", word);
        std::string answer(2, ' ');
        EXPECT_EQ(take(child, answer, std::chrono::seconds(60)), Read::Done);
        EXPECT_EQ(answer, word);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(openDescriptors(), before);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "no child is left to wait for";
  EXPECT_EQ(errno, ECHILD);
}

}  // namespace
}  // namespace chartflood
