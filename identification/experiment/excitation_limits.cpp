// SPDX-License-Identifier: Apache-2.0
#include "identification/experiment/excitation_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "dynamics/gravity.hpp"
#include "identification/rig/load_inertia.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::identification {
namespace {

constexpr double kShareOfRegion = 0.9;  ///< What is planned for, of what the region allows.
constexpr int kSpeedsTried = 64;

actuator::Region peak_region(const Rig& rig, const actuator::Actuator& actuator) {
  const actuator::OperatingConditions conditions;
  const std::vector<std::string> why = actuator::objections(actuator, conditions);
  if (!why.empty()) throw io::SpecError({{rig.file, "", "no region to plan in: " + why.front()}});
  return actuator::Region(actuator, conditions);
}

/// Both signs of torque are there.
bool is_two_sided(const actuator::JointRange& range) {
  return !range.is_empty && range.least.torque_Nm < 0.0 && range.greatest.torque_Nm > 0.0;
}

}  // namespace

ExcitationLimits::ExcitationLimits(const Rig& rig, const actuator::Actuator& actuator,
                                   const RigLimits& limits)
    : limits_(limits),
      is_imposed_(rig.load.type == LoadType::kDynamometer),
      region_(peak_region(rig, actuator)),
      per_ampere_Nm_A_(std::abs(actuator.transmission.ratio) * actuator.motor.torque_constant_Nm_A),
      inertia_kg_m2_(load_inertia_kg_m2(rig.load) + actuator.motor.rotor_inertia_kg_m2 *
                                                        actuator.transmission.ratio *
                                                        actuator.transmission.ratio),
      winding_limit_K_(actuator.thermal ? actuator.thermal->winding_limit_K
                                        : std::numeric_limits<double>::infinity()) {
  if (!rig.states_load) {
    throw io::SpecError({{rig.file, "/load",
                          "missing; a plan is made for one load, and \"loads\" are those of runs "
                          "that were logged"}});
  }
  if (rig.load.type == LoadType::kPendulum) {
    stiffness_Nm_rad_ = rig.load.mass_kg * dynamics::kGravity_m_s2 * rig.load.length_m;
  }
  for (int k = 1; k <= kSpeedsTried; ++k) {
    const double speed = region_.greatest_speed_rad_s() * k / kSpeedsTried;
    if (!is_two_sided(region_.at(speed)) || !is_two_sided(region_.at(-speed))) break;
    speed_rad_s_ = kShareOfRegion * speed;
  }
  if (limits.speed_rad_s) speed_rad_s_ = std::min(speed_rad_s_, *limits.speed_rad_s);
  if (!(speed_rad_s_ > 0.0)) {
    throw io::SpecError(
        {{rig.file, "", "the actuator's region holds no motion in both directions"}});
  }
}

double ExcitationLimits::current_A(double speed_rad_s, double sign) const {
  const actuator::JointRange range = region_.at(speed_rad_s);
  if (range.is_empty) return 0.0;
  const actuator::JointBound& bound = sign > 0.0 ? range.greatest : range.least;
  const double torque_Nm = std::max(0.0, sign * bound.torque_Nm);
  return kShareOfRegion * std::min(std::abs(bound.current_A), torque_Nm / per_ampere_Nm_A_);
}

double ExcitationLimits::current_for_A(double speed_rad_s, double frequency_Hz) const {
  const double omega = 2.0 * std::numbers::pi * frequency_Hz;
  // Near the pendulum's own frequency hardly any torque is needed; friction asks for some.
  const double needed_Nm_rad = std::max(
      std::abs(stiffness_Nm_rad_ - inertia_kg_m2_ * omega * omega), 0.3 * stiffness_Nm_rad_);
  return needed_Nm_rad * speed_rad_s / omega / per_ampere_Nm_A_;
}

double ExcitationLimits::speed_at(double frequency_Hz) const {
  if (!limits_.position_rad) return speed_rad_s_;
  return std::min(speed_rad_s_, *limits_.position_rad * 2.0 * std::numbers::pi * frequency_Hz);
}

bool ExcitationLimits::hold(const simulation::JointTrace& trace, std::size_t stride) const {
  for (std::size_t i = 0; i < trace.speed_rad_s.size(); i += stride) {
    const double moved_rad = trace.position_rad[i] - trace.position_rad.front();
    if (limits_.position_rad && std::abs(moved_rad) > *limits_.position_rad) return false;
    if (limits_.speed_rad_s && std::abs(trace.speed_rad_s[i]) > *limits_.speed_rad_s) return false;
    if (trace.winding_K[i] > winding_limit_K_) return false;
    const actuator::JointRange range = region_.at(trace.speed_rad_s[i]);
    if (range.is_empty || trace.torque_Nm[i] > range.greatest.torque_Nm ||
        trace.torque_Nm[i] < range.least.torque_Nm) {
      return false;
    }
  }
  return true;
}

double ExcitationLimits::greatest_torque_Nm() const { return region_.at(0.0).greatest.torque_Nm; }

}  // namespace torquewright::identification
