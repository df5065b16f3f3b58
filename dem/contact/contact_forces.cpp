#include "dem/contact/contact_forces.hpp"

#include <algorithm>

namespace clogflow {

namespace {

/// What the turning of the normal adds to the sliding velocity. It is across the normal, so that as a velocity of the
/// spheres it changes nothing else; no time passes in the law here, which would add it itself.
Vec3 turned_velocity(const ContactGeometry<double>& contact, const ContactMotion<double>& motion, double dt) {
  const double approach = dot(motion.velocity, contact.normal);
  return sliding_velocity<true>(contact, motion, approach, dt) - sliding_velocity<false>(contact, motion, approach, dt);
}

}  // namespace

std::vector<ContactForce> contact_forces(const Particles& p, const Neighbours& pairs, const WallContacts& walls,
                                         const ContactLaw& pair, const ContactLaw& wall, double dt) {
  std::vector<ContactForce> all;
  pairs.for_each_contact([&](int i, int j, Springs<double> springs) {
    const PairPlace<double> place = pair_place(p, i, j);
    const double distance = place.distance();
    const double overlap = std::max(place.overlap(distance), -pair.reach(place.effective_radius()));
    ContactGeometry<double> contact = place.contact(1 / distance * place.apart, overlap, reduced(p[i].mass, p[j].mass));
    if (pairs.equal_radius == 0) contact.turning = 1 / distance;  // as in the hot loop
    ContactMotion<double> motion{p[i].velocity() - p[j].velocity(), p[i].spin(), p[j].spin()};
    motion.velocity += turned_velocity(contact, motion, dt);
    const ContactLaw law = pair.at(0.5 * (p[i].x + p[j].x), p.species[i], p.species[j]);
    all.push_back({i, j, contact.normal, law.loads(contact, motion, 0, springs).force});
  });
  if (walls.empty()) return all;
  for (WallContacts::Touch& touch : walls.touches(p)) {
    const int i = touch.particle;
    const double overlap = std::max(touch.overlap, -wall.reach(p[i].radius));
    const ContactMotion<double> motion{p[i].velocity(), p[i].spin(), {0, 0, 0}};
    const ContactGeometry<double> contact = wall_contact(touch.normal, overlap, p[i].radius, p[i].mass);
    const ContactLaw law = wall.at(p[i].x, p.species[i], 0);
    all.push_back({i, -1, touch.normal, touch.share * law.loads(contact, motion, 0, touch.springs).force});
  }
  return all;
}

}  // namespace clogflow
