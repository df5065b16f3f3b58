#include "coupling/openfoam/foam_samples.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/base/text_file.hpp"

namespace clogflow {
namespace {

constexpr const char* remedy = "delete the file `solved` of the case and run its Allrun again";

// Where in which file, for messages.
struct Place {
  const std::filesystem::path& file;
  std::size_t line;
  std::string text() const { return fmt::format("{}:{}", file.string(), line); }
};

std::array<double, 6> six_numbers(std::string_view line, const Place& place) {
  std::array<double, 6> numbers{};
  const char* at = line.data();
  const char* end = at + line.size();
  const auto skip_blanks = [&] {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
  };
  for (double& number : numbers) {
    skip_blanks();
    const auto [next, error] = std::from_chars(at, end, number);
    require(error == std::errc{} && std::abs(number) <= std::numeric_limits<float>::max(),
            "{}: \"{}\" (expected six finite numbers x y z Ux Uy Uz; cut short or diverged?); {}", place.text(),
            shown_text(line), remedy);
    at = next;
  }
  skip_blanks();
  require(at == end, "{}: \"{}\" (more than six numbers); {}", place.text(), shown_text(line), remedy);
  return numbers;
}

// Index of a coordinate in the sampled range, which starts at `first`.
int lattice_index(double coordinate, int first, const FlowLattice& lattice) {
  return static_cast<int>(std::lround(coordinate / lattice.spacing - 0.5)) - first;
}

class Reader {
public:
  Reader(const std::filesystem::path& file, const FlowLattice& lattice) : file_(file), lattice_(lattice) {
    samples_.points = lattice.sampled();
    const auto [nx, ny, nz] = samples_.points;
    const std::size_t count = static_cast<std::size_t>(nx) * ny * nz;
    samples_.velocity.resize(count);
    samples_.found.resize(count);
  }

  void add(std::string_view line, std::size_t number) {
    const Place place{file_, number};
    const auto values = six_numbers(line, place);
    const std::array<int, 3> first{lattice_.x_sampled, lattice_.y_sampled, lattice_.z_begin};
    std::array<int, 3> at{};
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] = lattice_index(values[axis], first[axis], lattice_);
      const double exact = lattice_.coordinate(at[axis] + first[axis]);
      require(
          at[axis] >= 0 && at[axis] < samples_.points[axis] && std::abs(values[axis] - exact) < 1e-3 * lattice_.spacing,
          "{}: point ({}, {}, {}) m is not on the grid of the scene (samples of another case?); {}", place.text(),
          values[0], values[1], values[2], remedy);
    }
    const std::size_t index = samples_.index(at[0], at[1], at[2]);
    require(!samples_.found[index], "{}: the point is given twice; {}", place.text(), remedy);
    samples_.found[index] = 1;
    for (int c = 0; c < 3; ++c) samples_.velocity[index][c] = static_cast<float>(values[3 + c]);
  }

  FoamSamples result() { return std::move(samples_); }

private:
  const std::filesystem::path& file_;
  const FlowLattice& lattice_;
  FoamSamples samples_;
};

}  // namespace

FoamSamples read_foam_samples(const std::filesystem::path& file, const FlowLattice& lattice) {
  const std::string text = read_text_file(file);
  require(text.empty() || text.back() == '\n', "{} ends inside a line (cut short); {}", file.string(), remedy);
  Reader reader(file, lattice);
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const std::string_view line(text.data() + begin, end - begin);
    ++number;
    begin = end + 1;
    if (!line.empty() && line.front() != '#') reader.add(line, number);
  }
  return reader.result();
}

std::filesystem::path foam_samples_file(const std::filesystem::path& folder, const char* field) {
  namespace fs = std::filesystem;
  const std::string file = fmt::format("lattice_{}.xy", field);
  const fs::path samples = folder / "postProcessing" / "samples";
  fs::path newest;
  double newest_time = -1;
  if (fs::is_directory(samples)) {
    for (const auto& entry : fs::directory_iterator(samples)) {
      const std::string name = entry.path().filename().string();
      double time = -1;
      std::from_chars(name.data(), name.data() + name.size(), time);
      if (time > newest_time && fs::exists(entry.path() / file)) {
        newest_time = time;
        newest = entry.path() / file;
      }
    }
  }
  require(!newest.empty(), "{}/*/{} is missing; {}", samples.string(), file, remedy);
  return newest;
}

}  // namespace clogflow
