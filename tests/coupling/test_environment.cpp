// Variables of the environment, and numbers among them.
#include <cstdlib>

#include <gmock/gmock.h>

#include "coupling/base/environment.hpp"
#include "coupling/base/require.hpp"

namespace clogflow::test {
namespace {

constexpr const char* name = "CLOG_TEST_OF_ENVIRONMENT";

std::optional<int> asked_with(const char* value) {
  ::setenv(name, value, 1);
  return environment_number(name, "(must be a count): unset it");
}

TEST(Environment, TellsEmptyFromUnset) {
  ::unsetenv(name);
  EXPECT_EQ(environment(name), std::nullopt);
  EXPECT_EQ(environment_number(name, ""), std::nullopt);
  ::setenv(name, "", 1);
  EXPECT_EQ(environment(name), "");
}

TEST(Environment, ReadsWholeNumbersAlone) {
  EXPECT_EQ(asked_with("0"), 0);
  EXPECT_EQ(asked_with("12"), 12);
  for (const char* wrong : {"", "-1", "1.5", "3 ", "x", "99999999999"}) {
    try {
      asked_with(wrong);
      ADD_FAILURE() << "accepted: " << wrong;
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), std::string(name) + " = " + wrong + " (must be a count): unset it");
    }
  }
}

}  // namespace
}  // namespace clogflow::test
