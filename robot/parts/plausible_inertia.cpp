// SPDX-License-Identifier: Apache-2.0
#include "robot/parts/plausible_inertia.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>

namespace torquewright::hopper {
namespace {

// CAD programs print six digits: a flat plate's x + y may miss its z by as much.
constexpr double kRounding = 1e-5;
constexpr double kPositive = 1e-9;  // of the largest moment; below, it is a needle or worse

}  // namespace

std::optional<std::string> inertia_objection(const Eigen::Matrix3d& inertia_kg_m2) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.compute(inertia_kg_m2, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& moments = axes.eigenvalues();  // ascending
  const std::string listed = fmt::format("principal moments {:.6g}, {:.6g}, {:.6g} kg m2",
                                         moments[0], moments[1], moments[2]);
  if (!(moments[0] > kPositive * moments[2])) {
    return listed + ": all must be positive";
  }
  if (moments[2] > (moments[0] + moments[1]) * (1 + kRounding)) {
    return listed + ": none may exceed the sum of the other two (no rigid body has such)";
  }
  return std::nullopt;
}

}  // namespace torquewright::hopper
