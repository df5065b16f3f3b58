#include "coupling/openfoam/foam_log.hpp"

#include <regex>
#include <sstream>
#include <string>

#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/base/text_file.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;

// The part of a text after the last occurrence of `label`, up to the end of its line.
std::string last_after(const std::string& text, const std::string& label, const fs::path& file) {
  const auto at = text.rfind(label);
  require(at != std::string::npos, "{} holds no \"{}\" (cut short?); run the case's Allrun again", file.string(),
          label);
  const auto begin = text.find_first_not_of(' ', at + label.size());
  return text.substr(begin, text.find('\n', begin) - begin);
}

double number_after(const std::string& text, const std::string& label, const fs::path& file) {
  const std::string rest = last_after(text, label, file);
  std::istringstream in(rest);
  double number = 0;
  require(static_cast<bool>(in >> number), "{}: \"{} {}\" (expected a number)", file.string(), label, shown_text(rest));
  return number;
}

std::string version(const std::string& log) {
  // The header's line is "Version:  1912" from openfoam.com and "Version:  8" from openfoam.org;
  // Debian leaves it empty and gives the number in the line "Build".
  std::smatch match;
  if (std::regex_search(log, match, std::regex(R"(Version:\s*(v?\d[\w.]*))"))) return match[1];
  if (std::regex_search(log, match, std::regex(R"(Build\s*:\s*(\S[^\n]*))"))) return match[1];
  return "unknown";
}

std::vector<SurfaceFlux> fluxes(const fs::path& file, double copies) {
  std::istringstream in(read_text_file(file));
  std::vector<SurfaceFlux> surfaces;
  std::string name;
  double flux = 0, inlet = 0;
  while (in >> name >> flux) {
    if (surfaces.empty()) inlet = flux;
    surfaces.push_back({.surface = name, .flux = copies * flux, .error = flux / inlet - 1});
  }
  require(in.eof() && surfaces.size() >= 2 && inlet > 0,
          "{} does not hold one positive flux a surface; run the case's Allrun again", file.string());
  return surfaces;
}

}  // namespace

FlowRecord read_foam_logs(const fs::path& folder, double copies, FlowRecord record) {
  const fs::path solver = folder / "log.simpleFoam";
  const std::string log = read_text_file(solver);
  record.openfoam_version = version(log.substr(0, 4000));
  record.iterations = number_after(log, "SIMPLE solution converged in", solver);
  const auto residual = [&](const char* field) {
    return number_after(log, fmt::format("Solving for {}, Initial residual =", field), solver);
  };
  record.residuals = {.ux = residual("Ux"), .uy = residual("Uy"), .uz = residual("Uz"), .p = residual("p")};
  const fs::path mesh = folder / "log.checkMesh";
  const std::string check = read_text_file(mesh);
  record.cells = static_cast<std::int64_t>(number_after(check, "\n    cells:", mesh));
  record.non_orthogonality = number_after(check, "Mesh non-orthogonality Max:", mesh);
  record.mass_flux = fluxes(folder / "fluxes", copies);
  return record;
}

double read_pressure_drop(const fs::path& folder) {
  const fs::path file = folder / "pressure";
  std::istringstream in(read_text_file(file));
  double drop = 0;
  require(static_cast<bool>(in >> drop) && drop > 0, "{} holds no positive number; run the case's Allrun again",
          file.string());
  return drop;
}

}  // namespace clogflow
