// One verified number, and the groups of them that the tests assert and the report prints.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace clogflow::verification {

struct Check {
  std::string name;  ///< what was run
  double reference;  ///< the law, or the published value; 0 where nothing should be left
  double ours;
  double limit;          ///< on error()
  bool relative = true;  ///< error over the reference; else in the quantity's own unit

  double error() const {
    const double difference = std::abs(ours - reference);
    return relative ? difference / std::abs(reference) : difference;
  }
  bool passed() const { return error() <= limit; }  // false for NaN
};

struct Group {
  std::string title;
  std::string remark;  ///< where the reference is from and why the limit is what it is
  std::vector<Check> checks;
};

// Chung & Ooi (2011), tests 1 to 8.
Group two_spheres_head_on();       // 1
Group sphere_on_rigid_wall();      // 2
Group restitution_sweep();         // 3
Group oblique_constant_speed();    // 4
Group oblique_constant_normal();   // 5
Group spinning_on_wall();          // 6
Group counter_spinning_pair();     // 7
Group spinning_on_heavy_sphere();  // 8

// Closed forms.
Group sliding_and_rolling();
Group fluid_closed_forms();
Group gravity();
Group pulsating_flow();
Group pressure_drive();
Group unequal_sizes();
Group species_friction();
Group cohesion();
Group sizes();

// Invariants.
Group energy_closed_forms();
Group energy_of_elastic_springs();
Group energy_of_a_cluster();
Group momentum();
Group frames();
Group orders();

// Guards.
Group no_energy_from_impacts();
Group no_spin_without_torque();
Group held_beside_large();
Group rolling_between_large();

struct Entry {
  std::string name;
  std::function<Group()> run;
};

/// Everything, in the order of the report.
std::vector<Entry> all_groups();

}  // namespace clogflow::verification
