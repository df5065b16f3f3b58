// A published curve: rows of one material from a CSV in tests/reference.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "coupling/base/require.hpp"
#include "tests/test_data.hpp"

namespace clogflow::verification {

struct Point {
  double x, y;
};

/// Lines "material,x,y" after a comment and a header.
inline std::vector<Point> reference_curve(const std::string& file, const std::string& material) {
  std::ifstream stream(test_data(file));
  require(stream.good(), "tests/reference/{}: cannot be read", file);
  std::vector<Point> points;
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(material + ",")) continue;
    Point point;
    char comma = 0;
    std::istringstream(line.substr(material.size() + 1)) >> point.x >> comma >> point.y;
    points.push_back(point);
  }
  require(!points.empty(), "tests/reference/{}: no material {}", file, material);
  return points;
}

}  // namespace clogflow::verification
