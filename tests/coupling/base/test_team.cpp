// Threads that share tasks: each task once, and what one throws comes out.
#include <gtest/gtest.h>

#include <stdexcept>

#include "coupling/base/team.hpp"

namespace clogflow::test {
namespace {

TEST(Team, DoesEachTaskOnce) {
  for (const int threads : {1, 2, 5}) {
    Team team(threads);
    EXPECT_EQ(team.size(), threads);
    for (int round = 0; round < 200; ++round) {
      std::vector<std::atomic<int>> done(17);
      team.each(17, [&](int k) { ++done[static_cast<std::size_t>(k)]; });
      for (const auto& times : done) ASSERT_EQ(times, 1);
    }
    team.each(0, [](int) { FAIL(); });
  }
}

TEST(Team, WorksAtOnce) {
  // Two tasks that wait for each other end only if two threads do them.
  Team team(2);
  std::atomic<int> there = 0;
  team.each(2, [&](int) {
    ++there;
    while (there < 2) std::this_thread::yield();
  });
  EXPECT_EQ(there, 2);
}

TEST(Team, LetsOutWhatATaskThrows) {
  for (const int threads : {1, 3}) {
    Team team(threads);
    EXPECT_THROW(team.each(9,
                           [](int k) {
                             if (k == 5) throw std::runtime_error("five");
                           }),
                 std::runtime_error);
    int sum = 0;
    team.each(1, [&](int k) { sum += k + 1; });
    EXPECT_EQ(sum, 1);
  }
}

}  // namespace
}  // namespace clogflow::test
