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

nlohmann::json fluxes(const fs::path& file, double copies) {
  std::istringstream in(read_text_file(file));
  nlohmann::json planes = nlohmann::json::array();
  std::string name;
  double flux = 0, inlet = 0;
  while (in >> name >> flux) {
    if (planes.empty()) inlet = flux;
    planes.push_back({{"surface", name}, {"flux", copies * flux}, {"error", flux / inlet - 1}});
  }
  require(in.eof() && planes.size() >= 2 && inlet > 0,
          "{} does not hold one positive flux a surface; run the case's Allrun again", file.string());
  return planes;
}

}  // namespace

nlohmann::json read_foam_logs(const fs::path& folder, double copies) {
  nlohmann::json found;
  const fs::path solver = folder / "log.simpleFoam";
  const std::string log = read_text_file(solver);
  found["openfoam_version"] = version(log.substr(0, 4000));
  found["iterations"] = number_after(log, "SIMPLE solution converged in", solver);
  for (const char* field : {"Ux", "Uy", "Uz", "p"}) {
    found["residuals"][field] = number_after(log, fmt::format("Solving for {}, Initial residual =", field), solver);
  }
  const fs::path mesh = folder / "log.checkMesh";
  const std::string check = read_text_file(mesh);
  found["cells"] = static_cast<long>(number_after(check, "\n    cells:", mesh));
  found["non_orthogonality"] = number_after(check, "Mesh non-orthogonality Max:", mesh);
  found["mass_flux"] = fluxes(folder / "fluxes", copies);
  return found;
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
