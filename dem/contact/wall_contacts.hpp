// Contacts of particles with the walls, and their springs.
#pragma once

#include <vector>

#include "dem/contact/contact_set.hpp"
#include "dem/contact/laws.hpp"
#include "dem/contact/neighbours.hpp"
#include "dem/contact/wall_bins.hpp"
#include "dem/contact/wall_surface.hpp"
#include "dem/kernels/kernels.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

/// A contact's place moves by less than this share of the radius in one step, where it goes over from one
/// facet of a curved wall to the next too; two contacts of one sphere are farther apart, see one_touch.
inline constexpr double same_place = 0.44;

/// Two lists, made anew together with the pair list: particles that can meet only the inside of a
/// flat patch (a plane: the SIMD kernel), and particles near an edge or corner, or where a wall curves
/// (triangle by triangle, facets of a curved wall joined). A contact is the same as in the last step if its place on
/// the wall is, whatever triangle it is on: so springs survive a sphere's way across an edge, and from one list into
/// the other.
class WallContacts {
public:
  WallContacts() = default;

  /// \param radius  of the largest particle [m]
  /// \param weld    corners of the walls that are nearer than this are one [m]
  WallContacts(const Walls& walls, double radius, const Reach& reach, double weld);
  WallContacts(const Walls& walls, double radius, const Reach& reach);

  /// Puts other walls in place; contacts go on where both have the same surface. Call rebuild()
  /// next.
  void change(const Walls& walls, double radius, const Particles& particles);

  /// \param renumbered  new index of each old particle, -1 if it left
  /// \param room        how far each particle may go until the next call [m]
  void rebuild(const Particles& particles, const std::vector<int>& renumbered, const std::vector<double>& room);

  /// Sorts the particles over planes by their gaps; holds until a gap may have changed by `margin`.
  void sort(const Particles& particles, double margin, const LubricationLaw& law);

  /// Adds the loads of the contacts with planes to the packed loads.
  ContactTally collide_planes(Particles& particles, const Kernels& kernels, const WallLaws& laws);

  /// Adds the loads of the contacts near edges and corners to fx ... tz.
  ContactTally collide_corners(Particles& particles, const WallLaws& laws);

  /// Energy stored in all wall contacts [J].
  double stored_energy(const Particles& particles, const ContactLaw& law) const;

  bool empty() const { return surface_.size() == 0; }

  /// One contact as it stood in the last step.
  struct Touch {
    int particle;
    Vec3 point;  ///< [m]
    Vec3 normal;
    double overlap;  ///< [m]
    Springs<double> springs;
    double share = 1;  ///< of the loads, see join_touches [-]

    template <class Archive>
    void exchange(Archive& archive) {
      archive(particle, point, normal, overlap, springs, share);
    }
  };
  std::vector<Touch> touches(const Particles& particles) const;

  /// A particle that does not touch but is near a wall.
  struct Gap {
    int particle;
    Vec3 normal;
    double width;  ///< >= 0 [m]
    double share;  ///< of the film's force, see join_touches [-]
  };
  std::vector<Gap> gaps(const Particles& particles, double widest) const;

  /// Whether lists read from a file fit these many particles, and these walls.
  bool valid(std::size_t particles) const;

  /// Everything but the surface, which the scene gives.
  template <class Archive>
  void exchange(Archive& archive) {
    archive(particle_, slot_, nx_, ny_, nz_, offset_, contacts_, corners_, corner_touches_);
  }

private:
  struct Corner {
    int particle;
    std::vector<int> triangles;

    template <class Archive>
    void exchange(Archive& archive) {
      archive(particle, triangles);
    }
  };

  /// What may be met near one particle.
  struct Nearby {
    std::vector<int> triangles;
    std::vector<int> patches;
    std::vector<int> planes;  ///< patches that are met in their inside only
  };
  void find_nearby(const Vec3& centre, double radius, double room, Nearby& found) const;

  /// Where a particle is near edges, corners and curved walls; into `found`.
  void points_near(const Corner& corner, const Particles& particles, double widest,
                   std::vector<WallPoint>& found) const;

  WallSurface surface_;
  WallBins bins_;
  Reach reach_;
  double weld_ = 0;
  std::vector<int> particle_, slot_;  // of each plane slot; slot_[k] = k
  std::vector<double> nx_, ny_, nz_, offset_;
  ContactSet contacts_;
  std::vector<Corner> corners_;
  std::vector<Touch> corner_touches_;  // sorted by particle, of the last step
};

}  // namespace clogflow
