// The contacts among a list of candidates and their springs, kept compact: what touches stands side by
// side in memory, so that the hot loop reads and writes whole vectors.
#pragma once

#include <array>
#include <vector>

#include "dem/kernels.hpp"

namespace clog {

/// Candidates are the entries of a pair list (or of a list of particles and planes). A candidate that
/// begins to touch is appended, one that ceases to touch is replaced by the last: so the order of the
/// contacts depends on the run's history alone, and is the same on every machine.
class ContactSet {
public:
  /// Forgets everything; `candidates` entries, none of them touching.
  void reset(std::size_t candidates);

  /// Scratch of the hot loop: the particles of candidates with a fluid film.
  std::vector<int> film_first, film_second;

  std::size_t size() const { return count_; }
  std::size_t candidates() const { return position_.size(); }

  /// Candidate that the contact at a position belongs to.
  int candidate(std::size_t position) const { return candidate_[position]; }
  Springs<double> springs(std::size_t position) const;

  /// Makes a candidate touch, with springs that another list remembers.
  /// \param first, second  its particles, or particle and plane
  void add(int candidate, int first, int second, const Springs<double>& springs);

  ContactPointers pointers();

  /// Whether a set read from a file fits `candidates` and points at nothing beyond these many particles,
  /// or particles and planes.
  bool sound(std::size_t candidates, std::size_t firsts, std::size_t seconds) const;

  template <class Archive>
  void exchange(Archive& archive) {
    for (auto& values : spring_) archive(values);
    archive(first_, second_, candidate_, position_, count_, film_first, film_second);
  }

private:
  std::array<std::vector<double>, 7> spring_;  // padded to whole vectors
  std::vector<int> first_, second_, candidate_, position_;
  std::size_t count_ = 0;
};

/// The same springs seen from the other particle: the normal and the sliding velocity change sign; the
/// rolling velocity -R* n x (w_i - w_j) and n . (w_i - w_j) do not, for both factors do.
Springs<double> swapped(const Springs<double>& springs);

}  // namespace clog
