#include "dem/particles.hpp"

#include "dem/sound.hpp"

namespace clog {

namespace {

template <class T>
void gather(std::vector<T>& values, const std::vector<int>& order) {
  std::vector<T> taken(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) taken[k] = values[order[k]];
  values.swap(taken);
}

}  // namespace

bool Particles::sound(double largest_radius) const {
  for (const auto* values : {&radius, &mass, &inertia, &x, &y, &z, &vx, &vy, &vz, &wx, &wy, &wz, &fx, &fy,
                             &fz, &tx, &ty, &tz})
    if (values->size() != size() || !all_finite(*values)) return false;
  return passed.size() == size() && all_positive(radius) && all_positive(mass) && all_positive(inertia) &&
         std::all_of(radius.begin(), radius.end(), [&](double r) { return r <= largest_radius; });
}

void Particles::add(const Particle& p) {
  id.push_back(p.id);
  radius.push_back(p.radius);
  mass.push_back(p.mass);
  inertia.push_back(p.inertia);
  x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
  vx.push_back(p.vx), vy.push_back(p.vy), vz.push_back(p.vz);
  wx.push_back(p.wx), wy.push_back(p.wy), wz.push_back(p.wz);
  for (auto* load : {&fx, &fy, &fz, &tx, &ty, &tz}) load->push_back(0);
  passed.push_back(0);
}

void Particles::reorder(const std::vector<int>& order) {
  gather(id, order);
  gather(passed, order);
  for (auto* values : {&radius, &mass, &inertia, &x, &y, &z, &vx, &vy, &vz, &wx, &wy, &wz, &fx, &fy,
                       &fz, &tx, &ty, &tz})
    gather(*values, order);
}

ParticlePointers pointers(Particles& p) {
  p.state.resize(state_stride * p.size());
  p.loads.resize(loads_stride * p.size());
  return {p.radius.data(), p.mass.data(), p.inertia.data(), p.x.data(),  p.y.data(),  p.z.data(),
          p.vx.data(),     p.vy.data(),   p.vz.data(),      p.wx.data(), p.wy.data(), p.wz.data(),
          p.fx.data(),     p.fy.data(),   p.fz.data(),      p.tx.data(), p.ty.data(), p.tz.data(),
          p.state.data(),  p.loads.data(), p.size()};
}

}  // namespace clog
