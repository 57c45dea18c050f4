// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "actuator/drive_check/winding_heat.hpp"
#include "actuator/region/motor_region.hpp"
#include "actuator/severity.hpp"

namespace torquewright::actuator {

enum class Verdict { kPass, kFail, kUndecided };
std::string_view name_of(Verdict verdict);

/// A finding of a check; docs/checks.md lists the rules.
struct Finding {
  Severity severity = Severity::kNote;
  std::string rule;
  std::string joint;             ///< Name of the joint; empty: it concerns no single joint.
  std::optional<double> time_s;  ///< Time at which it is worst.
  std::optional<double> value;   ///< Value in the unit of the limit.
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
  double excess_Nm = 0.0;          ///< Torque beyond the bound; 0 inside.
  Limiter limiter = Limiter::kCurrent;
};

/// A root mean square over the motion and the pause after it, with the continuous limit that the
/// document states.
struct ContinuousUse {
  double rms = 0.0;
  std::optional<double> limit;    ///< Limit in the unit of rms; empty: none is stated.
  std::optional<double> pause_s;  ///< Pause after each run that would meet the limit.
  /// Limit less rms; negative: exceeded. Empty: none is stated.
  std::optional<double> margin() const;
  /// Whether the limit is exceeded beyond rounding; false where none is stated.
  bool is_passed() const;
};

/// Result of one interpretation of the data: torque and speed against the region.
struct CheckedInterpretation {
  std::size_t clipped_samples = 0;
  /// Clipped time, by the trapezoidal rule like all integrals over time.
  double clipped_time_s = 0.0;
  WorstSample worst;
  std::optional<WorstSample> first;  ///< The first sample that lies outside.
  double margin_Nm = 0.0;            ///< Least distance to the nearer bound; negative: missing.
  /// Least speed margin; empty: some torque exists at no speed.
  std::optional<double> speed_margin_rad_s;
  /// Least voltage margin at the bus; empty: the supply gives out.
  std::optional<double> voltage_margin_V;
  double peak_torque_Nm = 0.0;
  double rms_torque_Nm = 0.0;
  bool has_winding = true;      ///< False: currents, volts and energies are not known.
  double peak_current_A = 0.0;  ///< Greatest current of the torque asked for, clipped or not.
  double rms_current_A = 0.0;
  double energy_drawn_J = 0.0;
  double energy_returned_J = 0.0;
  /// Number of samples whose torque no current yields; counted at the bound.
  std::size_t unreachable_samples = 0;
  std::optional<WindingReport> winding;
  ContinuousUse continuous_current;  ///< Current in A, in the document's convention.
  ContinuousUse continuous_torque;   ///< Torque in Nm, on the side of the datasheet.
  bool is_rated_at_joint = true;     ///< Side of continuous_torque: the joint; else the motor.
};

/// Whether torque in the file is the motor's, which accelerates its own rotor too, or the load's.
enum class InertiaConvention { kUnstated, kIncluded, kExcluded };

/// Range of the winding's temperature in the last run, and the one at which the report is made.
struct HeldHeat {
  double coldest_K = 0.0;
  double warmest_K = 0.0;  ///< Warmest temperature; of a single run the one it begins with.
  /// Temperature of the report; empty: as asked for, which is the worst.
  std::optional<double> shown_K;
  std::string objection;  ///< Why an end could not be judged; empty: both were.
};

/// An effect of the document that the check leaves out.
struct LeftOutEffect {
  std::string effect;
  /// Greatest torque at the output by which the motion is misjudged (LeftOutSizes); empty: it
  /// depends on the output's angle, which is unknown.
  std::optional<double> misjudged_Nm;
};

/// Report of one actuator.
struct DriveReport {
  std::string name;
  std::string actuator;
  Verdict verdict = Verdict::kPass;
  std::size_t samples = 0;
  double from_s = 0.0;
  double until_s = 0.0;
  double peak_speed_rad_s = 0.0;
  double no_load_speed_rad_s = 0.0;
  double armature_kg_m2 = 0.0;  ///< Inertia of rotor and gears, at the joint.
  bool has_torque = true;
  bool is_speed_differentiated = false;
  /// The speed that no torque can hold, of a motion whose file states no torque; empty: none.
  std::optional<double> limiting_speed_rad_s;
  std::optional<double> limiting_time_s;
  std::size_t impossible_speeds = 0;  ///< Number of samples at speeds where the region is empty.
  InertiaConvention inertia = InertiaConvention::kUnstated;
  /// Interpretation as the file has it, or as the user says.
  CheckedInterpretation interpretation;
  std::optional<CheckedInterpretation>
      with_inertia;  ///< Where that is open: the interpretation with the rotor's torque added.
  double velocity_over_slope = 1.0;   ///< Logged velocity over d(position)/dt, by least squares.
  double velocity_correlation = 0.0;  ///< Squared correlation of both; 0: not compared.
  std::size_t unwrapped = 0;      ///< Number of whole turns that were removed from its position.
  double unwrapped_from_s = 0.0;  ///< Time of the first of them.
  /// Present where it was judged at other conditions than those asked for.
  std::optional<HeldHeat> held_heat;
  std::vector<std::string> left_out;
  std::vector<LeftOutEffect> effects_left_out;
  std::vector<std::string> assumed;
};

/// A point of the motion in the plane of speed and torque.
struct TracePoint {
  double time_s;
  double speed_rad_s;
  double torque_Nm;
  bool is_outside;
};

/// The longest time between two samples, and the mean of the others.
struct LongestStep {
  double duration_s = 0.0;
  double from_s = 0.0;
  double usual_s = 0.0;  ///< Mean of the other steps; 0: there is no other.
};

struct CheckReport {
  Verdict verdict = Verdict::kPass;
  std::vector<DriveReport> drives;
  std::vector<Finding> findings;
  /// Points for pictures, one list for each drive, if asked for; thinned.
  std::vector<std::vector<TracePoint>> traces;
  std::string sha256;  ///< Hash of the trajectory.
};

/// Whether an interpretation fails: a sample is clipped, the winding passes its limit in the runs
/// asked for, or current or torque exceed their continuous limits.
bool fails(const CheckedInterpretation& interpretation);

}  // namespace torquewright::actuator
