// The tables that tests compare with.
#pragma once

#include <string>

#include "coupling/base/source_folder.hpp"

namespace clogflow {

inline std::string test_data(const std::string& name) {
  return (source_folder() / "tests" / "reference" / name).string();
}

}  // namespace clogflow
