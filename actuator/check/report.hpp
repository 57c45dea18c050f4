// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "actuator/check/winding_heat.hpp"
#include "actuator/region/motor_region.hpp"
#include "actuator/severity.hpp"

namespace torquewright::actuator {

enum class Verdict { kPass, kFail, kUndecided };
std::string_view name_of(Verdict verdict);

/// One thing the check noticed; docs/checks.md lists the rules.
struct Finding {
  Severity severity = Severity::kNote;
  std::string rule;
  std::string joint;             ///< Empty: not of one joint.
  std::optional<double> time_s;  ///< Where it is worst.
  std::optional<double> value;   ///< In the same unit as the limit.
  std::optional<double> limit;
  std::string unit;
  std::string sentence;
};

/// The sample whose torque lies furthest outside the region, or, if none does, nearest to its
/// bound.
struct WorstSample {
  double time_s = 0.0;
  double speed_rad_s = 0.0;
  double torque_Nm = 0.0;
  std::optional<double> limit_Nm;  ///< The bound; empty where the region is empty.
  double excess_Nm = 0.0;          ///< What would be cut off; 0 inside.
  Limiter limiter = Limiter::kCurrent;
};

/// A root mean square over the motion and the pause after it, against what the document says may
/// last.
struct ContinuousUse {
  double rms = 0.0;
  std::optional<double> limit;           ///< In the unit of rms; empty: none is stated.
  std::optional<double> pause_s;         ///< After each run that would meet the limit.
  std::optional<double> margin() const;  ///< Negative: missing. Empty: none is stated.
  bool is_passed() const;                ///< Beyond rounding. What is not stated is not passed.
};

/// What follows from torque and speed against the region: one interpretation of the data.
struct CheckedInterpretation {
  std::size_t clipped_samples = 0;
  double clipped_time_s = 0.0;  ///< By the trapezoidal rule, like all integrals over time.
  WorstSample worst;
  std::optional<WorstSample> first;          ///< That lies outside.
  double margin_Nm = 0.0;                    ///< To the nearer bound, the least; negative: missing.
  std::optional<double> speed_margin_rad_s;  ///< Empty: some torque is there at no speed.
  std::optional<double> voltage_margin_V;    ///< At the bus; empty: the supply gives out.
  double peak_torque_Nm = 0.0;
  double rms_torque_Nm = 0.0;
  bool has_winding = true;      ///< False: currents, volts and energies are not known.
  double peak_current_A = 0.0;  ///< Of the torque that is asked for, clipped or not.
  double rms_current_A = 0.0;
  double energy_drawn_J = 0.0;
  double energy_returned_J = 0.0;
  std::size_t unreachable_samples = 0;  ///< Whose torque no current yields: counted at the bound.
  std::optional<WindingReport> winding;
  ContinuousUse continuous_current;  ///< A, in the document's convention.
  ContinuousUse continuous_torque;   ///< Nm, on the side that the datasheet is of.
  bool is_rated_at_joint = true;     ///< Of the torque: which side that is.
};

/// Whether torque in the file is the motor's, which accelerates its own rotor too, or the load's.
enum class InertiaConvention { kUnstated, kIncluded, kExcluded };

/// Between which temperatures the winding is in the last run, and at which the report is.
struct HeldHeat {
  double coldest_K = 0.0;
  double warmest_K = 0.0;         ///< Of a single run the same: what it begins with.
  std::optional<double> shown_K;  ///< Empty: as asked for, which is no better.
  std::string objection;          ///< Why an end could not be judged; empty: both were.
};

/// An effect of the document that the check does not reckon with.
struct LeftOutEffect {
  std::string effect;
  /// Torque at the output by which the motion is misjudged at most (LeftOutSizes); empty: it turns
  /// on the output's angle, which nothing tells.
  std::optional<double> misjudged_Nm;
};

/// One actuator's part of the report.
struct DriveReport {
  std::string name;
  std::string actuator;
  Verdict verdict = Verdict::kPass;
  std::size_t samples = 0;
  double from_s = 0.0;
  double until_s = 0.0;
  double peak_speed_rad_s = 0.0;
  double no_load_speed_rad_s = 0.0;
  double armature_kg_m2 = 0.0;  ///< Rotor and gears, at the joint.
  bool has_torque = true;
  bool is_speed_differentiated = false;
  std::optional<double> limiting_speed_rad_s;  ///< Without torque: a speed that no torque holds.
  std::optional<double> limiting_time_s;
  std::size_t impossible_speeds = 0;  ///< Samples at speeds where the region is empty.
  InertiaConvention inertia = InertiaConvention::kUnstated;
  CheckedInterpretation interpretation;  ///< As the file has it, or as the user says it is.
  std::optional<CheckedInterpretation>
      with_inertia;                   ///< Where that is open: with the rotor's torque added.
  double velocity_over_slope = 1.0;   ///< Logged velocity over d(position)/dt, least squares.
  double velocity_correlation = 0.0;  ///< Of the two, squared; 0: not compared.
  std::size_t unwrapped = 0;          ///< Times that its position was made to run on,
  double unwrapped_from_s = 0.0;      ///< and when first.
  std::optional<HeldHeat> held_heat;  ///< Where it was judged elsewhere than as asked for.
  std::vector<std::string> left_out;
  std::vector<LeftOutEffect> effects_left_out;
  std::vector<std::string> assumed;
};

/// A point of the motion in the plane of the region.
struct TracePoint {
  double time_s;
  double speed_rad_s;
  double torque_Nm;
  bool is_outside;
};

/// The longest time between two samples, and how long the others take on average.
struct LongestStep {
  double duration_s = 0.0;
  double from_s = 0.0;
  double usual_s = 0.0;  ///< 0: there is no other.
};

struct CheckReport {
  Verdict verdict = Verdict::kPass;
  std::vector<DriveReport> drives;
  std::vector<Finding> findings;
  std::vector<std::vector<TracePoint>> traces;  ///< One a drive, if asked for; thinned out.
  std::string sha256;                           ///< Of the trajectory.
};

/// An interpretation fails where a sample is clipped, the winding passes its limit in the runs
/// asked for, or current or torque pass over them what is stated as continuous.
bool fails(const CheckedInterpretation& interpretation);

}  // namespace torquewright::actuator
