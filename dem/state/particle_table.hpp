// The header of a CSV of particles: which column means what, in which unit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dem/state/particles.hpp"

namespace clogflow {

/// What a column of numbers sets.
struct ParticleColumn {
  double Particle::*member = nullptr;  ///< nullptr: left out
  double factor = 1;                   ///< of a diameter to the radius
  std::string unit;                    ///< empty: SI
};

/// Fields are separated by what the header has: semicolons, commas, tabs or blanks.
struct ParticleTable {
  char separator = ',';
  std::vector<ParticleColumn> columns;
  std::vector<std::string> left_out;  ///< names of columns that say nothing to us
};

/// Whether a line, the text of a comment for instance, can be the header: it names two or more
/// columns.
bool is_particle_header(std::string_view line);

/// Names in any case: x y z, radius or diameter, vx vy vz, wx wy wz; points:0 ... velocity:2 spin:2
/// as ParaView writes them, omegax ... as LIGGGHTS does. A unit follows in brackets ("x [um]", "vx
/// (mm/s)"), or a length's after a line ("x_um"); without one it is SI. \param where  file and line
/// for messages \throws Error if x, y or z is missing or comes twice, their units differ, or a
/// column names a mass or a density
ParticleTable read_particle_header(std::string_view line, const std::string& where);

/// Blanks and quotes around each field are dropped.
std::vector<std::string> split_fields(std::string_view line, char separator);

}  // namespace clogflow
