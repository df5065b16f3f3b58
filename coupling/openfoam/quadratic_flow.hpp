// The flow between the centres of a mesh's cells, by polynomials of second degree.
#pragma once

#include <array>
#include <vector>

#include "coupling/openfoam/foam_cells.hpp"

namespace clogflow {

/// Each cell has the quadratic polynomial that lies nearest to the velocities in its centre, in those of its
/// neighbours and their neighbours across faces, and to zero in the faces on walls among them (weighted least
/// squares); a place between centres has the mean of the polynomials of its cell and that cell's neighbours, weighted
/// by (1 - distance^2 / h^2)^2, h being the mean distance of the neighbours. Exact for a flow of second degree, such
/// as Poiseuille's, for cells of any shape; linear interpolation errs by u'' h^2 / 8, as much as the solver does.
/// Neighbours across faces never lie behind a wall, however thin.
/// \source P. Lancaster and K. Salkauskas, Math. Comput. 37 (1981) 141, for the moving least squares
class QuadraticFlow {
public:
  explicit QuadraticFlow(const FoamCells& cells);

  Vec3 at(int cell, const Vec3& place) const;  ///< [m/s] \param cell   the one that holds the place

private:
  static constexpr int terms = 10;
  using Terms = std::array<double, terms>;
  struct Piece {
    Vec3 centre;
    double size;  ///< mean distance of the neighbours
    std::array<std::array<float, terms>, 3> factor;
  };

  static Terms powers(const Vec3& d);
  void link(const FoamCells& cells);
  void fit(int cell, const FoamCells& cells);

  std::vector<int> first_, next_;            // neighbours of cell c: next_[first_[c]] to next_[first_[c + 1]]
  std::vector<int> first_wall_, next_wall_;  // the faces of cell c on walls, likewise
  std::vector<Piece> piece_;
  std::vector<int> seen_, ring_;  // of the fit at work
};

}  // namespace clogflow
