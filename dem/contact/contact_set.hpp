// The contacts among a list of candidates and their springs, kept compact: what touches stands side
// by side in memory, so that the hot loop reads and writes whole vectors. Of the other candidates
// only those that could begin to touch soon are looked at in every step.
#pragma once

#include <cstdint>
#include <vector>

#include "dem/kernels/kernels.hpp"

namespace clogflow {

/// A list of candidates, padded to whole vectors: two particles each, or a particle and a plane.
struct Candidates {
  const int *first, *second;
  std::size_t count;
};

/// Candidates are the entries of a pair list (or of a list of particles and planes). Every
/// candidate touches, or is watched, or may have a fluid film and nothing else, or is left alone;
/// sort() decides for as long as no gap changes by more than a margin, the hot loop moves rows
/// between the touching and the watched. The order of the rows depends on the run's history alone,
/// and is the same on every machine.
class ContactSet {
public:
  /// Forgets everything.
  void reset();

  std::size_t size() const { return touching_.count; }

  /// Candidate, particle and particle or plane of the contact at a row.
  int candidate(std::size_t row) const { return touching_.candidate[row]; }
  int first(std::size_t row) const { return touching_.first[row]; }
  int second(std::size_t row) const { return touching_.second[row]; }
  Springs<double> springs(std::size_t row) const;

  /// Makes a candidate touch, with springs that another list remembers.
  void add(const Candidates& list, int candidate, const Springs<double>& springs);

  /// Sorts the candidates that do not touch. Holds until a gap may have changed by `margin`.
  /// \param gap  of a candidate [m]
  template <class Gap>
  void sort(const Candidates& list, double margin, const LubricationLaw& law, const Gap& gap);

  ContactPointers pointers();

  /// Whether a set read from a file fits `candidates` and points at nothing beyond these many particles,
  /// or particles and planes.
  bool valid(std::size_t candidates, std::size_t firsts, std::size_t seconds) const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(springs_, touching_, watched_, films_, changed_, watched_lubricate_);
  }

private:
  struct Rows {
    std::vector<int> first, second, candidate;  // padded beyond count
    std::size_t count = 0;

    void append(int one, int other, int number);
    void pad(std::size_t rows);
    RowPointers pointers() { return {first.data(), second.data(), candidate.data(), &count}; }

    template <class Archive>
    void exchange(Archive& archive) {
      archive(first, second, candidate, count);
    }
  };

  /// Room for all that touch or may begin to.
  void make_room();

  Rows touching_, watched_, films_;
  std::vector<SpringBlock> springs_;
  std::vector<int> changed_;
  bool watched_lubricate_ = false;
};

template <class Gap>
void ContactSet::sort(const Candidates& list, double margin, const LubricationLaw& law, const Gap& gap) {
  std::vector<std::uint8_t> touches(list.count, 0);
  for (std::size_t row = 0; row < touching_.count; ++row) touches[touching_.candidate[row]] = 1;
  watched_.count = films_.count = 0;
  for (std::size_t k = 0; k < list.count; ++k) {
    if (touches[k]) continue;
    const double width = gap(k);
    if (width < margin) {
      watched_.append(list.first[k], list.second[k], static_cast<int>(k));
    } else if (law.viscosity > 0 && width > law.least() - margin && width < law.farthest + margin) {
      films_.append(list.first[k], list.second[k], static_cast<int>(k));
    }
  }
  // The gap of a watched candidate may grow to twice the margin.
  watched_lubricate_ = law.viscosity > 0 && law.least() < 2 * margin;
  make_room();
}

/// The same springs seen from the other particle: the normal and the sliding velocity change sign;
/// the rolling velocity -R* n x (w_i - w_j) and n . (w_i - w_j) do not, for both factors do.
Springs<double> swapped(const Springs<double>& springs);

}  // namespace clogflow
