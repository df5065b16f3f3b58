// Work shared among processes: order, back-pressure, and processes that end early.
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <set>

#include <gmock/gmock.h>

#include "coupling/base/in_processes.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

TEST(InProcesses, GiveResultsInOrderForAnyNumberOfThem) {
  for (const std::size_t workers : {0, 1, 2, 7, 50}) {
    std::string all;
    std::set<std::string> by;
    in_processes(
        30, workers, [](std::size_t i) { return std::to_string(i) + " " + std::to_string(::getpid()); },
        [&](std::size_t i, const std::string& bytes) {
          EXPECT_THAT(bytes, testing::StartsWith(std::to_string(i) + " "));
          by.insert(bytes.substr(bytes.find(' ')));
          all += bytes.substr(0, bytes.find(' ')) + ",";
        });
    EXPECT_THAT(all, testing::AllOf(testing::StartsWith("0,1,2,3,"), testing::EndsWith("28,29,")));
    EXPECT_EQ(by.size(), std::clamp<std::size_t>(workers, 1, 30));
  }
  in_processes(
      0, 4, [](std::size_t) { return std::string(); }, [](std::size_t, const std::string&) { FAIL(); });
}

TEST(InProcesses, CarryMoreThanAPipeHolds) {
  std::size_t bytes = 0;
  in_processes(
      6, 3, [](std::size_t i) { return std::string(1'000'000, static_cast<char>('a' + i)); },
      [&](std::size_t i, const std::string& text) {
        EXPECT_EQ(text.back(), static_cast<char>('a' + i));
        bytes += text.size();
      });
  EXPECT_EQ(bytes, 6'000'000u);
}

TEST(InProcesses, SayThatOneWasKilled) {
  const auto killed = [](std::size_t i) {
    if (i == 3) std::raise(SIGKILL);
    return std::string("x");
  };
  std::size_t taken = 0;
  EXPECT_THAT(refusal([&] { in_processes(8, 2, killed, [&](std::size_t, const std::string&) { ++taken; }); }),
              testing::HasSubstr("ended by signal 9"));
  EXPECT_EQ(taken, 3u);
}

TEST(InProcesses, EndWithWhatTheTakerThrows) {
  const auto large = [](std::size_t) { return std::string(1'000'000, 'x'); };
  EXPECT_EQ(
      refusal([&] { in_processes(100, 4, large, [](std::size_t, const std::string&) { throw Error("enough"); }); }),
      "enough");
}

}  // namespace
}  // namespace clogflow
