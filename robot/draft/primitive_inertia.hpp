// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace torquewright::hopper {

enum class Primitive { kSphere, kCapsule, kCylinder, kBox, kEllipsoid };

/// Radius; radius and half length along z (of a capsule: of its straight part); half lengths along
/// x, y, z; half axes. Unused ones do not count.
using PrimitiveSize = Eigen::Vector3d;

double volume_m3(Primitive primitive, const PrimitiveSize& size_m);

/// Moments about the centre over the mass, about x, y, z (m^2), of a solid of one density.
Eigen::Vector3d moments_per_mass_m2(Primitive primitive, const PrimitiveSize& size_m);

}  // namespace torquewright::hopper
