// Asserts what the report prints: one test per group.
#include <gtest/gtest.h>

#include "tests/verification/check.hpp"

namespace clogflow::verification {
namespace {

class Verification : public testing::TestWithParam<Entry> {};

TEST_P(Verification, IsWithinItsLimits) {
  const Group group = GetParam().run();
  ASSERT_FALSE(group.checks.empty());
  for (const Check& c : group.checks)
    EXPECT_TRUE(c.passed()) << group.title << ", " << c.name << ": reference " << c.reference << ", ours " << c.ours
                            << ", error " << c.error() << ", limit " << c.limit;
}

INSTANTIATE_TEST_SUITE_P(Of, Verification, testing::ValuesIn(all_groups()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace clogflow::verification
