// What is checked in a development build and not even evaluated in a release.
#include <gtest/gtest.h>

#include "coupling/base/expect.hpp"

namespace {

#undef NDEBUG
#include <cassert>
void checked(int value) { expect(value == 1); }

#define NDEBUG
#include <cassert>
void unchecked([[maybe_unused]] int& value) { expect(++value == 1); }

TEST(Expect, SaysWhereAMistakeIs) {
  checked(1);
  EXPECT_DEATH(checked(2), "test_expect.cpp.*value == 1");
}

TEST(Expect, IsNothingInARelease) {
  int value = 7;
  unchecked(value);
  EXPECT_EQ(value, 7);
}

}  // namespace
