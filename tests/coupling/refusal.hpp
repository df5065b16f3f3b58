// The text of a refusal, so that a test can read it.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "coupling/base/require.hpp"

namespace clogflow {

/// Message of the Error that `action` throws; a failed test if it throws none.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

}  // namespace clogflow
