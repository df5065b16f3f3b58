// The vector of three lengths, velocities or forces.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace clogflow {

using Vec3 = Eigen::Vector3d;

}  // namespace clogflow
