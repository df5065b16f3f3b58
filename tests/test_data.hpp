// The tables that tests compare with.
#pragma once

#include <string>

#include "coupling/source_folder.hpp"

namespace clog {

inline std::string test_data(const std::string& name) {
  return (source_folder() / "tests" / "reference" / name).string();
}

}  // namespace clog
