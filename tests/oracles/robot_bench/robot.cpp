// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/robot_bench/robot.hpp"

#include <algorithm>
#include <stdexcept>

namespace torquewright::oracles::robot_bench {
namespace {

// Steiner: of a mass at `offset` from where the inertia is wanted.
Eigen::Matrix3d steiner(double mass_kg, const Eigen::Vector3d& offset_m) {
  return mass_kg *
         (offset_m.squaredNorm() * Eigen::Matrix3d::Identity() - offset_m * offset_m.transpose());
}

template <class List>
auto& named(List& list, const std::string& name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.name == name; });
  if (found == list.end()) throw std::invalid_argument("no such part of the robot: " + name);
  return *found;
}

}  // namespace

void Body::add(double more_kg, const Eigen::Vector3d& at_m, const Eigen::Matrix3d& inertia) {
  const double whole = mass_kg + more_kg;
  if (whole <= 0) return;
  const Eigen::Vector3d center = (mass_kg * center_m + more_kg * at_m) / whole;
  inertia_kg_m2 += steiner(mass_kg, center_m - center) + inertia + steiner(more_kg, at_m - center);
  mass_kg = whole;
  center_m = center;
}

Body& Robot::body(const std::string& of) { return named(bodies, of); }
const Body& Robot::body(const std::string& of) const { return named(bodies, of); }
Joint& Robot::joint(const std::string& of) { return named(joints, of); }
const Joint& Robot::joint(const std::string& of) const { return named(joints, of); }

bool Robot::is_held(const std::string& joint) const {
  return std::find(held.begin(), held.end(), joint) != held.end();
}

std::vector<std::string> Robot::moved() const {
  std::vector<std::string> names;
  for (const Joint& one : joints)
    if (!is_held(one.name)) names.push_back(one.name);
  return names;
}

const Joint* Robot::carrier(const std::string& of) const {
  for (const Joint& one : joints)
    if (one.child == of) return &one;
  return nullptr;
}

}  // namespace torquewright::oracles::robot_bench
