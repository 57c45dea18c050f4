// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/region/joint_region.hpp"
#include "identification/rig/rig.hpp"
#include "simulation/run/simulated_run.hpp"

namespace torquewright::identification {

/// Limits of the rig, besides the actuator's region.
struct RigLimits {
  /// The output stays within this distance of where it starts.
  std::optional<double> position_rad;
  std::optional<double> speed_rad_s;
};

/// How far an excitation may go: the region at the joint at peak rating, the rig's limits, and the
/// winding's temperature. Throws io::SpecError where the region cannot be asked for.
class ExcitationLimits {
 public:
  ExcitationLimits(const Rig& rig, const actuator::Actuator& actuator, const RigLimits& limits);

  /// Largest speed that is planned for: a margin below where the region ends, or the rig's.
  double speed_rad_s() const { return speed_rad_s_; }

  /// Largest magnitude of current that is planned for at that speed, in the direction of `sign`.
  double current_A(double speed_rad_s, double sign) const;

  /// Current that the load takes (inertia and gravity) in a sine of that speed amplitude and
  /// frequency.
  double current_for_A(double speed_rad_s, double frequency_Hz) const;

  /// Largest amplitude of speed that the position range allows at a frequency.
  double speed_at(double frequency_Hz) const;

  /// Whether every `stride`-th sample of a simulated run lies inside the limits.
  bool hold(const simulation::JointTrace& trace, std::size_t stride = 1) const;

  const RigLimits& rig() const { return limits_; }
  bool is_imposed() const { return is_imposed_; }
  double greatest_torque_Nm() const;

 private:
  RigLimits limits_;
  bool is_imposed_;
  actuator::Region region_;
  double per_ampere_Nm_A_;
  double inertia_kg_m2_;
  double stiffness_Nm_rad_ = 0.0;
  double winding_limit_K_;
  double speed_rad_s_ = 0.0;
};

}  // namespace torquewright::identification
