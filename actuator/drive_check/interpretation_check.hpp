// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "actuator/drive_check/demand.hpp"
#include "actuator/drive_check/geared_torque.hpp"
#include "actuator/drive_check/integral.hpp"
#include "actuator/drive_check/region_lookup.hpp"
#include "actuator/drive_check/report.hpp"
#include "actuator/drive_check/winding_heat.hpp"

namespace torquewright::actuator {

/// Returns the speed at the output [rad/s] below which a drive counts as at rest: what rounding
/// leaves of no speed must not choose the direction that the mesh drives in.
double rest_speed_rad_s(const Actuator& actuator, const PhaseModel& model);

/// What all samples of one actuator are judged by.
struct CheckBasis {
  CheckBasis(const Actuator& actuator, const OperatingConditions& conditions);

  /// Returns the speed, or 0 where it counts as rest.
  double counted_rad_s(double speed_rad_s) const {
    return std::abs(speed_rad_s) < rest_rad_s ? 0.0 : speed_rad_s;
  }

  const Actuator* actuator;
  double temperature_K;
  RotorBeforeMesh rotor;
  RegionLookup lookup;  ///< Region of the motor; the limit of the teeth is not part of it.
  double rest_rad_s;    ///< Slower speeds count as rest.
  std::optional<HeatModel> heat;
};

/// Returns the region that a drive's samples are judged by while others load its battery.
std::shared_ptr<const HeldRegion> held_region(const CheckBasis& basis,
                                              const OperatingConditions& conditions);

/// Gathers the results of one interpretation of an actuator's samples, in constant memory.
class InterpretationCheck {
 public:
  /// `wants_speed_margin`: compute speed margins, which takes longer and no verdict needs.
  explicit InterpretationCheck(const CheckBasis& basis, bool wants_speed_margin = true);

  /// Uses this region for the samples that follow: the same actuator's on another bus voltage.
  void use(RegionLookup lookup) { lookup_ = std::move(lookup); }

  /// Adds a sample; times ascend, and the torque is at the joint, with all inertia of rotor and
  /// gears. True if the sample lies outside the region or loads the teeth too much.
  bool add(double time_s, double speed_rad_s, double torque_Nm, double acceleration_rad_s2);

  CheckedInterpretation finish(std::size_t runs, double pause_s) const;

 private:
  /// A sample that may have the least speed margin.
  struct Slow {
    RegionLookup lookup;
    double speed_rad_s;
    double torque_Nm;
  };
  void note_speed_margin(double speed_rad_s, double torque_Nm);
  static double least_speed_margin_rad_s(const std::vector<Slow>& waiting, double least_rad_s);
  void add_demand(double time_s, double speed_rad_s, double torque_Nm, const TorqueRange& range);
  void add_heat(double time_s, double square_A2);
  void add_continuous(double pause_s, CheckedInterpretation& result) const;
  WorstSample exactly(WorstSample sample, const RegionLookup& lookup) const;
  WorstSample in_the_teeth(WorstSample sample, const RegionLookup& lookup) const;

  const CheckBasis* basis_;
  RegionLookup lookup_;
  RegionLookup lookup_of_worst_;
  /// Of the first sample outside, if one lies outside.
  RegionLookup lookup_of_first_;
  bool wants_speed_margin_;
  CheckedInterpretation interpretation_;
  std::size_t samples_ = 0;
  double worst_excess_Nm_ = -kUnlimited;
  /// Least speed margin of all samples but those that wait.
  double speed_margin_rad_s_ = kUnlimited;
  std::vector<Slow> waiting_;
  double voltage_margin_V_ = kUnlimited;
  double peak_motor_torque_Nm_ = 0.0;
  double first_s_ = 0.0;
  double last_s_ = 0.0;
  double last_speed_rad_s_ = 0.0;
  double last_square_A2_ = 0.0;
  Integral clipped_, torque_square_, motor_torque_square_, current_square_, drawn_, returned_;
  std::optional<WindingHeat> heat_;
};

}  // namespace torquewright::actuator
