// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace torquewright::hopper {

// The cone of vectors (t, n) with |t| <= n, t of two elements: its algebra, as interior points need
// it (Alizadeh and Goldfarb 2003). Here n stands last, as normals do in forces.

using ConeVector = Eigen::Vector3d;

/// Determinant n^2 - |t|^2: positive inside, where n > 0 too (and in the opposite cone, where n <
/// 0).
double cone_determinant(const ConeVector& x);

/// Product of the cone: x o y = (n_x t_y + n_y t_x, x . y).
ConeVector cone_product(const ConeVector& x, const ConeVector& y);

/// Returns the y with x o y = b. Requires x inside.
ConeVector cone_quotient(const ConeVector& b, const ConeVector& x);

/// Returns the symmetric W of Nesterov and Todd with W z = W^-1 x. Requires both inside.
Eigen::Matrix3d nesterov_todd(const ConeVector& x, const ConeVector& z);

/// Returns the greatest share, at most 1, of a step from the inside that does not leave the cone.
double share_to_boundary(const ConeVector& x, const ConeVector& step);

}  // namespace torquewright::hopper
