// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace torquewright::oracles::loop {

/// A law of the contract's table of effects, by its name; a wave is "order", "amplitude_Nm" and
/// "phase_rad". Names that the table does not have are laws outside of it (drawing.cpp).
struct Law {
  std::string name;
  std::map<std::string, double> values;
  double at(const std::string& key) const { return values.at(key); }
};

/// The first law of this name, or none.
const Law* law_named(const std::vector<Law>& laws, const std::string& name);

/// What a joint does at an instant.
struct Moment {
  double time_s = 0.0;
  double position_rad = 0.0;
  double speed_rad_s = 0.0;
  double load_Nm = 0.0;  ///< Torque on the load: what the gear carries.
};

/// Dry friction at the output, for motion forwards and backwards [Nm]; both not negative.
struct DryFriction {
  double forwards_Nm = 0.0, backwards_Nm = 0.0;
};

DryFriction dry_friction(const std::vector<Law>& laws, const Moment& at);
/// What acts against the motion in proportion to it, drags and waves: added to the drive's torque.
double smooth_torque_Nm(const std::vector<Law>& laws, const Moment& at, double ratio);
/// Motor torque over the stated torque constant, as a current [A], and the current that makes it.
double effective_current_A(const std::vector<Law>& laws, double current_A);
double current_of_A(const std::vector<Law>& laws, double effective_A);
/// Viscous friction that differs by direction, or not at all [Nm s/rad].
double viscous_Nm_s_rad(const std::vector<Law>& laws, double speed_rad_s);

}  // namespace torquewright::oracles::loop
