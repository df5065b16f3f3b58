// Seeded insertion at the left end of the channel, and the random packing a filled start begins with.
#pragma once

#include <cstdint>

#include "coupling/base/random_stream.hpp"
#include "dem/fluid/fluid.hpp"
#include "dem/run/model.hpp"
#include "dem/state/particles.hpp"
#include "dem/state/valid.hpp"

namespace clogflow {

/// Inserts spheres at random places in a slab at the left end, as many as fit or as a rate allows, never overlapping
/// another sphere or a wall. Attempts are bounded per call and counted.
///
/// Where sizes differ, each next particle is drawn once and kept until it finds room: what enters has the distribution
/// asked for, whatever room there is. What it neglects: a large one that waits holds up the small ones after it.
///
/// A concentration phi is a rate, phi q / V of spheres of mean volume V in the flow rate q; what finds no room waits.
/// Each place is then taken in proportion to the flow there, so that a suspension of the same concentration everywhere
/// enters. Neglects that no centre comes nearer to a wall than a radius.
class Inlet {
public:
  explicit Inlet(const Model& model);

  bool enabled() const { return enabled_; }

  /// Time between two calls of insert(): the flow moves by a small part of a diameter [s].
  double interval() const { return interval_; }

  /// The time that inlet.rate counts from begins again at 0.
  void restart_clock() { fed_ = 0, last_fed_ = 0; }

  /// Numbers before this one are taken, by particles that are there from the start.
  void number_from(std::int64_t first) { first_id_ = first; }

  /// Tries to insert at time t, at the flow's present speed. \return number inserted
  int insert(Particles& particles, const Fluid& fluid, RandomStream& random, double time);

  /// Fills the straight channel at random, loosely: the flow then packs it against the gate. Where sizes differ, a
  /// sample of the feed is put there whole, the largest first; where it finds no room, a smaller one is tried.
  void scatter(Particles& particles, RandomStream& random);

  std::int64_t inserted() const { return next_id_; }
  /// Particles that there ever were, those from the start too.
  std::int64_t numbered() const { return first_id_ + next_id_; }
  /// When a particle came in last, by the flow's clock; 0: none since it began [s]
  double last_fed() const { return last_fed_; }
  std::int64_t refused() const { return refused_; }  ///< attempts that found no room

  /// Whether more would come in at time t if there were room: a clog is not for good while it could still be fed.
  bool waits(const Fluid& fluid, double time) const {
    return rate_ == 0 || static_cast<double>(fed_) < rate_ * rated_time(fluid, time);
  }

  /// Whether it tried and nothing came in since its clock began.
  bool shut() const { return fed_ == 0 && refused_ > 0; }

  /// Whether counts read from a file are counts.
  bool valid() const {
    constexpr std::int64_t most = std::int64_t{1} << 60;
    return next_id_ >= 0 && next_id_ < most && refused_ >= 0 && refused_ < most && fed_ >= 0 && fed_ < most &&
           finite_from_zero(last_fed_) && is_valid(next_);
  }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(next_id_, refused_, fed_, last_fed_, next_.diameter, next_.species);
  }

private:
  /// What rate_ counts by: the liquid that a concentration came in with, or the time. [s]
  double rated_time(const Fluid& fluid, double time) const {
    return model_->scene.inlet.concentration > 0 ? fluid.drive().carried(time) : time;
  }
  bool fits_round(const Vec3& place, double radius) const;
  bool carries(const Fluid& fluid, const Vec3& place, RandomStream& random);
  bool is_valid(const ParticleSizes::Drawn& drawn) const;
  ParticleSizes::Drawn draw(RandomStream& random) const;
  /// The one to come in, drawn if there is none.
  void choose_next(RandomStream& random);
  void put(Particles& particles, const ParticleSizes::Drawn& drawn, const Vec3& place);
  /// \return number placed before the attempts ended
  std::size_t scatter_some(Particles& particles, const std::vector<ParticleSizes::Drawn>& wanted, RandomStream& random);

  const Model* model_;
  bool enabled_;
  ParticleSizes::Drawn next_{0, 0};  // diameter 0: none is drawn yet

  double interval_ = 0, rate_;
  double fastest_ = 0;  // of the flow in the slab, where places are taken in proportion to it [m/s]
  double last_fed_ = 0;
  Vec3 low_, high_;  // corners of the slab for the whole sphere [m]
  std::int64_t first_id_ = 0, next_id_ = 0, refused_ = 0, fed_ = 0;
};

}  // namespace clogflow
