#include "dem/contact/wall_contacts.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "dem/physics/lubrication.hpp"
#include "dem/state/valid.hpp"

namespace clogflow {

namespace {

using Touch = WallContacts::Touch;

Vec3 centre_of(const Particles& p, int i) { return {p[i].x, p[i].y, p[i].z}; }

/// Takes the springs of the remembered contact nearest to the place, if it is the same contact.
bool recall(std::vector<Touch>& memory, int particle, const Vec3& place, double radius, Springs<double>& springs) {
  const auto [begin, end] = std::equal_range(memory.begin(), memory.end(), particle, [](const auto& a, const auto& b) {
    const auto number = [](const auto& v) {
      if constexpr (std::is_same_v<std::decay_t<decltype(v)>, int>)
        return v;
      else
        return v.particle;
    };
    return number(a) < number(b);
  });
  auto nearest = end;
  double least = same_place * radius;
  for (auto touch = begin; touch != end; ++touch) {
    const double distance = (touch->point - place).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = touch;
  }
  if (nearest == end) return false;
  springs = nearest->springs;
  // Each memory serves one contact.
  nearest->point = Vec3::Constant(std::numeric_limits<double>::infinity());
  return true;
}

ContactGeometry<double> geometry(const Particles& p, int i, const Vec3& normal, double overlap) {
  return wall_contact(normal, overlap, p[i].radius, p[i].mass);
}

}  // namespace

WallContacts::WallContacts(const Walls& walls, double radius, const Reach& reach, double weld)
    : surface_(walls, weld),
      bins_(surface_.triangles(), radius + reach.lubrication + reach.skin / 2),
      reach_(reach),
      weld_(weld) {}

WallContacts::WallContacts(const Walls& walls, double radius, const Reach& reach)
    : WallContacts(walls, radius, reach, weld_length(walls)) {}

void WallContacts::change(const Walls& walls, double radius, const Particles& particles) {
  corner_touches_ = touches(particles);
  surface_ = WallSurface(walls, weld_);
  bins_ = WallBins(surface_.triangles(), radius + reach_.lubrication + reach_.skin / 2);
  particle_.clear(), slot_.clear();
  contacts_.reset();
  corners_.clear();
}

void WallContacts::find_nearby(const Vec3& centre, double radius, double room, Nearby& found) const {
  const double reach = radius + reach_.lubrication + room;
  for (auto* list : {&found.triangles, &found.planes, &found.patches}) list->clear();
  for (int t : bins_.near(centre)) {
    if (!surface_.is_nearer(t, centre, reach)) continue;
    found.triangles.push_back(t);
    const int patch = surface_.patch_of(t);
    if (std::find(found.patches.begin(), found.patches.end(), patch) != found.patches.end()) continue;
    found.patches.push_back(patch);
    if (surface_.well_inside(surface_.patches()[patch], centre, room)) found.planes.push_back(patch);
  }
  std::erase_if(found.planes, [&](int patch) {
    return std::any_of(found.triangles.begin(), found.triangles.end(),
                       [&](int t) { return surface_.may_share_a_touch(surface_.patches()[patch], t, reach); });
  });
}

void WallContacts::rebuild(const Particles& p, const std::vector<int>& renumbered, const std::vector<double>& room) {
  // The old slots still name the old indices; their planes do not change.
  std::vector<Touch> memory;
  for (std::size_t contact = 0; contact < contacts_.size(); ++contact) {
    const int k = contacts_.candidate(contact);
    const int i = renumbered[particle_[k]];
    if (i < 0) continue;
    const Vec3 normal(nx_[k], ny_[k], nz_[k]), centre = centre_of(p, i);
    memory.push_back(
        {i, centre - (dot(normal, centre) - offset_[k]) * normal, normal, 0, contacts_.springs(contact), 1});
  }
  for (Touch& touch : corner_touches_) {
    touch.particle = renumbered[touch.particle];
    if (touch.particle >= 0) memory.push_back(touch);
  }
  std::stable_sort(memory.begin(), memory.end(),
                   [](const Touch& a, const Touch& b) { return a.particle < b.particle; });

  particle_.clear(), nx_.clear(), ny_.clear(), nz_.clear(), offset_.clear();
  corners_.clear();
  std::vector<Springs<double>> recalled;
  std::vector<std::uint8_t> known;
  Nearby near;
  for (int i = 0; i < static_cast<int>(p.size()); ++i) {
    const Vec3 centre = centre_of(p, i);
    find_nearby(centre, p[i].radius, room[i], near);
    for (const int patch : near.planes) {
      const WallPatch& plane = surface_.patches()[patch];
      particle_.push_back(i);
      nx_.push_back(plane.normal.x), ny_.push_back(plane.normal.y);
      nz_.push_back(plane.normal.z), offset_.push_back(plane.offset);
      const Vec3 foot = centre - (dot(plane.normal, centre) - plane.offset) * plane.normal;
      recalled.push_back({});
      known.push_back(recall(memory, i, foot, p[i].radius, recalled.back()));
    }
    Corner corner{i, {}};
    for (const int t : near.triangles)
      if (std::find(near.planes.begin(), near.planes.end(), surface_.patch_of(t)) == near.planes.end())
        corner.triangles.push_back(t);
    if (!corner.triangles.empty()) corners_.push_back(std::move(corner));
  }
  slot_.resize(particle_.size());
  std::iota(slot_.begin(), slot_.end(), 0);
  // Spare rows of the hot loop name slot 0.
  for (auto* values : {&nx_, &ny_, &nz_, &offset_})
    if (values->empty()) values->push_back(0);
  contacts_.reset();
  for (std::size_t k = 0; k < known.size(); ++k)
    if (known[k]) contacts_.add({particle_.data(), slot_.data(), slot_.size()}, static_cast<int>(k), recalled[k]);
  corner_touches_ = std::move(memory);
}

void WallContacts::sort(const Particles& p, double margin, const LubricationLaw& law) {
  contacts_.sort({particle_.data(), slot_.data(), slot_.size()}, margin, law, [&](std::size_t k) {
    const Vec3 normal(nx_[k], ny_[k], nz_[k]);
    return dot(normal, centre_of(p, particle_[k])) - offset_[k] - p[particle_[k]].radius;
  });
}

ContactTally WallContacts::collide_planes(Particles& p, const Kernels& kernels, const WallLaws& laws) {
  return kernels.collide_planes({pointers(p), nx_.data(), ny_.data(), nz_.data(), offset_.data(), contacts_.pointers(),
                                 laws.contact, laws.lubrication, laws.dt},
                                laws.terms);
}

void WallContacts::points_near(const Corner& corner, const Particles& p, double widest,
                               std::vector<WallPoint>& found) const {
  const double radius = p[corner.particle].radius;
  found.clear();
  surface_.closest_points(corner.triangles, centre_of(p, corner.particle), radius + widest, found);
  join_touches(found, radius);
}

ContactTally WallContacts::collide_corners(Particles& p, const WallLaws& laws) {
  ContactTally tally;
  std::vector<Touch> touches;
  std::vector<WallPoint> found;
  for (const Corner& corner : corners_) {
    const int i = corner.particle;
    points_near(corner, p, laws.lubrication.farthest, found);
    for (const WallPoint& wall : found) {
      const double overlap = p[i].radius - wall.distance;
      const Vec3 velocity = p[i].velocity();
      Vec3 force{0, 0, 0}, torque{0, 0, 0};
      Touch touch{i, wall.point, wall.normal, overlap, {}, wall.share};
      // A contact that sticks lasts beyond touch, once it has begun.
      const bool known = overlap > -laws.contact.reach(p[i].radius) &&
                         recall(corner_touches_, i, wall.point, p[i].radius, touch.springs);
      if (overlap > 0 || known) {
        const ContactMotion<double> motion{velocity, p[i].spin(), {0, 0, 0}};
        const auto loads = laws.contact.at(p[i].x, p.species[i], 0)
                               .loads(geometry(p, i, wall.normal, overlap), motion, laws.dt, touch.springs);
        force = wall.share * loads.force;
        torque = wall.share * loads.torque_i;
        touches.push_back(touch);
        ++tally.contacts;
        tally.largest_overlap = std::max(tally.largest_overlap, overlap);
      } else if (laws.lubrication.viscosity > 0) {
        const Vec3& normal = wall.normal;
        const double c = film_coefficient(laws.lubrication, p[i].radius, -overlap, 1.0);
        force = (-c * wall.share * dot(velocity, normal)) * normal;
      }
      p[i].fx += force.x, p[i].fy += force.y, p[i].fz += force.z;
      p[i].tx += torque.x, p[i].ty += torque.y, p[i].tz += torque.z;
    }
  }
  corner_touches_ = std::move(touches);
  return tally;
}

std::vector<Touch> WallContacts::touches(const Particles& p) const {
  std::vector<Touch> all = corner_touches_;
  for (std::size_t contact = 0; contact < contacts_.size(); ++contact) {
    const int k = contacts_.candidate(contact), i = particle_[k];
    const Vec3 normal(nx_[k], ny_[k], nz_[k]), centre = centre_of(p, i);
    const double height = dot(normal, centre) - offset_[k];
    all.push_back({i, centre - height * normal, normal, p[i].radius - height, contacts_.springs(contact), 1});
  }
  return all;
}

std::vector<WallContacts::Gap> WallContacts::gaps(const Particles& p, double widest) const {
  std::vector<Gap> all;
  const auto add = [&](int i, const Vec3& normal, double distance, double share) {
    const double width = distance - p[i].radius;
    if (width >= 0 && width <= widest) all.push_back({i, normal, width, share});
  };
  for (std::size_t k = 0; k < slot_.size(); ++k) {
    const Vec3 normal(nx_[k], ny_[k], nz_[k]);
    add(particle_[k], normal, dot(normal, centre_of(p, particle_[k])) - offset_[k], 1);
  }
  std::vector<WallPoint> found;
  for (const Corner& corner : corners_) {
    points_near(corner, p, widest, found);
    for (const WallPoint& wall : found) add(corner.particle, wall.normal, wall.distance, wall.share);
  }
  return all;
}

bool WallContacts::valid(std::size_t particles) const {
  const auto is_particle = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < particles; };
  const std::size_t slots = slot_.size();
  if (slots > 0) {
    for (const auto* values : {&nx_, &ny_, &nz_, &offset_})
      if (values->size() != slots) return false;
    if (particle_.size() != slots || !point_below(particle_, particles) || !point_below(slot_, slots)) return false;
  }
  return contacts_.valid(slots, particles, slots) &&
         std::all_of(corners_.begin(), corners_.end(),
                     [&](const Corner& c) {
                       return is_particle(c.particle) &&
                              (c.triangles.empty() || point_below(c.triangles, surface_.size()));
                     }) &&
         std::all_of(corner_touches_.begin(), corner_touches_.end(),
                     [&](const Touch& t) { return is_particle(t.particle); });
}

double WallContacts::stored_energy(const Particles& p, const ContactLaw& law) const {
  double energy = 0;
  for (const Touch& touch : touches(p))
    energy += touch.share * law.stored_energy(geometry(p, touch.particle, touch.normal, touch.overlap), touch.springs);
  return energy;
}

}  // namespace clogflow
