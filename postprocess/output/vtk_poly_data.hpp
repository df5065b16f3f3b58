// Points, triangles, lines and what belongs to them as a VTK XML file (.vtp), which ParaView and VTK of any version
// open.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace clogflow::postprocess {

/// One column of numbers, `components` a point; the name ends with the unit: "velocity [m/s]".
struct VtkArray {
  std::string name;
  int components = 1;
  std::variant<std::span<const double>, std::span<const std::int64_t>> values;
};

/// Points alone are drawn as vertices, otherwise their triangles or lines. Nothing is copied.
struct VtkPolyData {
  std::span<const double> points;     ///< [n][3] [m]
  std::vector<std::int64_t> corners;  ///< three point numbers a triangle; empty: points alone, or lines
  bool lines = false;                 ///< the points are ends of lines, two and two
  std::vector<VtkArray> arrays;       ///< one row a point
  std::optional<double> time;         ///< as the field `TimeValue` [s]
};

/// The whole file: VTK XML PolyData, version 1.0, arrays appended raw, so numbers are kept bit for bit.
std::string vtk_poly_data(const VtkPolyData& data);

}  // namespace clogflow::postprocess
