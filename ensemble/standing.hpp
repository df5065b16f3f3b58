// How the seeds of a call stand: one sum over its ranks.
#pragma once

#include <array>
#include <bit>
#include <cstddef>

namespace clogflow {

/// All doubles, so that ranks can add them up. Of this call: what was done before is not in it.
struct Standing {
  double jobs = 0;            ///< seeds that were not done before; 0: as many as --until needs
  double done = 0;            ///< of them, those that are over: done, failed, not wanted or left to others
  double failed = 0;          ///< of those, and of what was done before
  double left_to_others = 0;  ///< of those: another call is at work on them
  double filling = 0, flowing = 0, clogged = 0;  ///< at work now
  double share = 0;                              ///< of its time that each of them has behind it, summed
  double passages = 0;                           ///< of all of this call
  double particle_steps = 0;                     ///< per second of late [1/s]
  double busy = 0;                               ///< at work on seeds [s]
  double stopped = 0;                            ///< seeds whose state was saved for the next call
  double finished = 0;                           ///< ranks that have nothing left to do

  static constexpr std::size_t size = 13;
  std::array<double, size> numbers() const { return std::bit_cast<std::array<double, size>>(*this); }
  static Standing of(const std::array<double, size>& numbers) { return std::bit_cast<Standing>(numbers); }
};
static_assert(sizeof(Standing) == Standing::size * sizeof(double));

}  // namespace clogflow
