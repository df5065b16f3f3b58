#include "tests/verification/check.hpp"

namespace clogflow::verification {

std::vector<Entry> all_groups() {
  return {{"chung_ooi_1", two_spheres_head_on},
          {"chung_ooi_2", sphere_on_rigid_wall},
          {"chung_ooi_3", restitution_sweep},
          {"chung_ooi_4", oblique_constant_speed},
          {"chung_ooi_5", oblique_constant_normal},
          {"chung_ooi_6", spinning_on_wall},
          {"chung_ooi_7", counter_spinning_pair},
          {"chung_ooi_8", spinning_on_heavy_sphere},
          {"sliding_and_rolling", sliding_and_rolling},
          {"fluid_closed_forms", fluid_closed_forms},
          {"gravity", gravity},
          {"pulsating_flow", pulsating_flow},
          {"pressure_drive", pressure_drive},
          {"unequal_sizes", unequal_sizes},
          {"species_friction", species_friction},
          {"cohesion", cohesion},
          {"sizes", sizes},
          {"energy_closed_forms", energy_closed_forms},
          {"energy_of_elastic_springs", energy_of_elastic_springs},
          {"energy_of_a_cluster", energy_of_a_cluster},
          {"momentum", momentum},
          {"frames", frames},
          {"orders", orders},
          {"no_energy_from_impacts", no_energy_from_impacts},
          {"no_spin_without_torque", no_spin_without_torque},
          {"held_beside_large", held_beside_large},
          {"rolling_between_large", rolling_between_large}};
}

}  // namespace clogflow::verification
