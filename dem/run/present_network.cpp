#include "dem/run/present_network.hpp"

#include <algorithm>

#include "dem/physics/lubrication.hpp"

namespace clogflow {

namespace {

/// Without the springs that the two surfaces of this contact do not have. \param second  0 for a wall
ContactTerms terms_between(const ContactLaw& law, const ContactTerms& terms, int first, int second) {
  if (!law.friction.of_species) return terms;
  const auto between = law.friction.between(first, second);
  return {terms.sliding && between.sliding > 0, terms.rolling && between.rolling > 0,
          terms.torsion && between.torsion > 0};
}

void add_pairs(NetworkLimit& network, const RunState& state) {
  const auto& p = state.particles;
  const Laws& laws = state.model.laws;
  state.lists.pairs.for_each_contact([&](int i, int j, const auto&) {
    const PairPlace<double> place = pair_place(p, i, j);
    const double distance = place.distance();
    const double overlap = std::max(place.overlap(distance), -laws.pair.reach(place.effective_radius()));
    network.add_contact(
        i, j,
        laws.pair.modes(terms_between(laws.pair, laws.pair_terms, p.species[i], p.species[j]),
                        place.contact(1 / distance * place.apart, overlap, reduced(p[i].mass, p[j].mass))));
  });
}

void add_walls(NetworkLimit& network, const RunState& state) {
  const auto& p = state.particles;
  const WallLaws& laws = state.model.laws.wall;
  for (const auto& touch : state.lists.walls.touches(p)) {
    const int i = touch.particle;
    const double overlap = std::max(touch.overlap, -laws.contact.reach(p[i].radius));
    network.add_contact(i, -1,
                        laws.contact.modes(terms_between(laws.contact, laws.terms, p.species[i], 0),
                                           wall_contact(touch.normal, overlap, p[i].radius, p[i].mass)));
  }
}

}  // namespace

NetworkLimit present_network(const RunState& state) {
  NetworkLimit network(state.particles);
  add_pairs(network, state);
  const Integrator integrator = state.model.scene.time.integrator;
  if (integrator != Integrator::implicit_fluid)
    for (const Film& film : present_films(state))
      network.add_film(film.first, film.second, film.normal, film.coefficient);
  if (!state.lists.walls.empty()) add_walls(network, state);
  AdvanceTask fluid{};
  state.fluid.attach(fluid);
  for (std::size_t i = 0; fluid.drag && i < state.count(); ++i)
    network.add_drag(static_cast<int>(i),
                     {fluid.drag[i], fluid.turn ? fluid.turn[i] : 0, integrator != Integrator::verlet});
  return network;
}

std::vector<Film> present_films(const RunState& state) {
  const auto& p = state.particles;
  const Laws& laws = state.model.laws;
  std::vector<Film> films;
  if (laws.film.viscosity > 0) {
    state.lists.pairs.for_each_pair([&](int i, int j) {
      const PairPlace<double> place = pair_place(p, i, j);
      const double distance = place.distance(), gap = distance - p[i].radius - p[j].radius;
      const double coefficient = film_coefficient(laws.film, place.effective_radius(), gap, 1.0);
      if (coefficient > 0) films.push_back({i, j, (1 / distance) * place.apart, coefficient});
    });
  }
  const LubricationLaw& law = laws.wall.lubrication;
  if (law.viscosity > 0 && !state.lists.walls.empty())
    for (const auto& gap : state.lists.walls.gaps(p, law.farthest)) {
      const double coefficient = film_coefficient(law, p[gap.particle].radius, gap.width, 1.0);
      if (coefficient > 0) films.push_back({gap.particle, -1, gap.normal, gap.share * coefficient});
    }
  return films;
}

}  // namespace clogflow
