// Scenes that the tests start from.
#pragma once

#include <string>

namespace clogflow {

/// The shortest scene there is.
inline const std::string laboratory = R"(
[particles]
diameter = "33 um"
density = "1062 kg/m3"
[contact]
youngs_modulus = "3 MPa"
poisson_ratio = 0.35
[time]
end = "1 s"
)";

/// A channel with a flow and everything switched on; line 1 is the first comment.
inline const std::string channel = R"(# a channel
[geometry]
neck_width = "100 um"
half_angle = "60 deg"
[fluid]
viscosity = "1.8 mPa s"
density = "1062 kg/m3"
[flow]
mean_velocity = "5 mm/s"
[particles]
diameter = "33 um"
[contact]
youngs_modulus = "3 MPa"
poisson_ratio = 0.35
restitution = 0.7
[contact.friction]
sliding = 0.6
[lubrication]
[drag]
[porosity]
[inlet]
[time]
end = "1 s"
)";

}  // namespace clogflow
