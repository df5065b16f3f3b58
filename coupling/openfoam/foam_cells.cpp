#include "coupling/openfoam/foam_cells.hpp"

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;

constexpr const char* run_again = "delete the file `solved` of the case and run its Allrun again";

// A file of OpenFOAM's as text, read from a place on.
class FoamText {
public:
  explicit FoamText(const fs::path& file) : file_(file), text_(read_text_file(file)) {}

  // Behind the next such word.
  FoamText& find(std::string_view word) {
    const std::size_t found = text_.find(word, at_);
    require(found != std::string::npos, "{}: \"{}\" is missing (cut short, or not as text?); {}", file_.string(), word,
            run_again);
    at_ = found + word.size();
    return *this;
  }

  template <class Number>
  Number number() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n()", at_), text_.size());
    Number value{};
    const auto [next, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    require(error == std::errc{}, "{}: no number behind {} bytes (cut short or diverged?); {}", file_.string(), at_,
            run_again);
    at_ = static_cast<std::size_t>(next - text_.data());
    return value;
  }

  int size() {
    const int count = number<int>();
    require(count > 0 && static_cast<std::size_t>(count) < text_.size(), "{}: a list of {} (cut short?); {}",
            file_.string(), count, run_again);
    return count;
  }

  std::vector<int> numbers() {
    std::vector<int> list(size());
    for (int& each : list) each = number<int>();
    end_list();
    return list;
  }

  std::vector<Vec3> vectors() {
    find("nonuniform List<vector>");
    std::vector<Vec3> list(size());
    for (Vec3& each : list) {
      each.x = number<double>(), each.y = number<double>(), each.z = number<double>();
      require(std::isfinite(each.x + each.y + each.z), "{}: a vector that is not finite (diverged?); {}",
              file_.string(), run_again);
    }
    end_list();
    return list;
  }

private:
  // Behind the last number, whose own digits may have been cut.
  void end_list() {
    const std::size_t end = text_.find_first_not_of(" \t\r\n)", at_);
    const bool closed = text_.find(')', at_) < end;
    const bool more =
        end != std::string::npos && std::string_view("(-.0123456789").find(text_[end]) != std::string::npos;
    require(closed && !more, "{}: a list does not end where it should; {}", file_.string(), run_again);
  }

  fs::path file_;
  std::string text_;
  std::size_t at_ = 0;
};

// Of the time that was written last.
fs::path newest_time(const fs::path& folder) {
  fs::path newest;
  int last = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    int time = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), time);
    if (error != std::errc{} || end != name.data() + name.size() || time <= last) continue;
    last = time, newest = entry.path();
  }
  require(last > 0, "{} holds no solved time; {}", folder.string(), run_again);
  return newest;
}

}  // namespace

FoamCells read_foam_cells(const fs::path& folder) {
  const fs::path time = newest_time(folder), mesh = folder / "constant" / "polyMesh";
  FoamCells cells;
  cells.velocity = FoamText(time / "U").find("internalField").vectors();
  FoamText centres(time / "C");
  cells.centre = centres.find("internalField").vectors();
  cells.wall = centres.find("boundaryField").find("walls").vectors();
  // The header of the two lists ends with a line of stars.
  cells.owner = FoamText(mesh / "owner").find("* //").numbers();
  cells.neighbour = FoamText(mesh / "neighbour").find("* //").numbers();
  FoamText boundary(mesh / "boundary");
  boundary.find("walls");
  const int faces = boundary.find("nFaces").number<int>(), first = boundary.find("startFace").number<int>();

  const int count = static_cast<int>(cells.centre.size());
  const auto of_mesh = [&](const std::vector<int>& list) {
    for (const int cell : list)
      if (cell < 0 || cell >= count) return false;
    return true;
  };
  require(cells.velocity.size() == cells.centre.size() && static_cast<int>(cells.wall.size()) == faces && first >= 0 &&
              static_cast<int>(cells.owner.size()) - first >= faces && cells.neighbour.size() <= cells.owner.size() &&
              of_mesh(cells.owner) && of_mesh(cells.neighbour),
          "{} and {} do not belong to the same mesh; {}", time.string(), mesh.string(), run_again);
  cells.wall_cell.assign(cells.owner.begin() + first, cells.owner.begin() + first + faces);
  cells.owner.resize(cells.neighbour.size());
  return cells;
}

}  // namespace clogflow
