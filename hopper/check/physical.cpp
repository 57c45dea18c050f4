// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/physical.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hopper/motion/rounding_words.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kKnownFactor = 0.05;  // relative, for a scale to count as a known one

/// What in the log would help.
std::string help_words(const Motion& motion) {
  if (motion.acceleration_origin != Origin::kDerived) return "";
  if (motion.acceleration_doubt.size() > 0) {
    return fmt::format("; {} would help", better_log(motion));
  }
  return motion.velocity_origin == Origin::kDerived
             ? "; velocities or accelerations in the log, or samples closer together, would help"
             : "; accelerations in the log, or samples closer together, would help";
}

/// What of the file decides where the ground touches; empty: heights and speeds do.
std::string deciding_columns(const Motion& motion) {
  if (motion.has_forces) return "forces";
  return motion.has_touching ? "flags" : "";
}

std::string missed_contact(const Motion& motion) {
  const std::string columns = deciding_columns(motion);
  if (columns.empty()) {
    return "the ground touches where no contact was found (--contact-height, --contact-speed)";
  }
  return fmt::format(
      "the ground touches where the file's contact {0} say that it does not (take these columns "
      "out: without them contacts are found by height and speed)",
      columns);
}

std::string question_of_contacts(const Motion& motion) {
  const std::string columns = deciding_columns(motion);
  if (columns.empty()) return "Are its contacts found (--contact-height, --ground-height)";
  return fmt::format(
      "Are the file's contact {} right, which decide where the ground touches (without these "
      "columns contacts are found by height and speed)",
      columns);
}

std::string sentence(const char* what, const ResidualPeak& peak, const char* unit, double window_s,
                     const Motion& motion, const std::string& question) {
  return fmt::format(
      "t = {} s: neither gravity nor inertia nor contacts explain {} of {:.4g} {} (mean of {:g} "
      "ms). The limit is {:.4g} {}; it is passed in {:.3g} % of the samples. {}? {}? Are its rates "
      "smooth? --residual-limit allows more{}",
      io::time_text(peak.time_s), what, peak.mean, unit, 1e3 * window_s, peak.limit, unit,
      100.0 * peak.share_beyond, question, question_of_contacts(motion), help_words(motion));
}

/// What makes a body fall so: time and lengths in other units, z down, or a force.
std::string cause_of_fall(const Flight& flight, const CheckedMotion& checked) {
  const double share = -flight.fall_m_s2.z() / gravity_of_limits_m_s2(checked.robot.tree);
  struct Known {
    double share;
    const char* words;
  };
  constexpr std::array kShares{
      Known{1e-6, "time_s is in milliseconds"},   Known{1e-12, "time_s is in microseconds"},
      Known{1e-18, "time_s is in nanoseconds"},   Known{1e3, "positions are in millimetres"},
      Known{1e2, "positions are in centimetres"}, Known{-1.0, "z points down"}};
  for (const Known& known : kShares) {
    if (std::abs(share / known.share - 1.0) < kKnownFactor) return known.words;
  }
  return "another gravity, or " + missed_contact(checked.motion);
}

void add_fall(const CheckedMotion& checked, const Flight& flight, std::vector<io::Fault>& faults) {
  if (flight.fall_error_m_s2 <= flight.fall_limit_m_s2) return;
  const double gravity_m_s2 = gravity_of_limits_m_s2(checked.robot.tree);
  faults.push_back(
      {checked.motion.file, "",
       fmt::format(
           "t = {} to {} s: in flight the centre of mass does not fall freely. It accelerates "
           "by ({:.4g}, {:.4g}, {:.4g}) m/s^2, which is off by {:.4g} m/s^2 ({:.3g} % of "
           "gravity; limit {:.3g}). Likely cause: {}; --residual-limit allows more{}",
           io::time_text(flight.from_s), io::time_text(flight.until_s), flight.fall_m_s2.x(),
           flight.fall_m_s2.y(), flight.fall_m_s2.z(), flight.fall_error_m_s2,
           100.0 * flight.fall_error_m_s2 / gravity_m_s2, flight.fall_limit_m_s2,
           cause_of_fall(flight, checked), help_words(checked.motion))});
}

void add_spin(const CheckedMotion& checked, const Flight& flight, std::vector<io::Fault>& faults) {
  if (flight.angular_momentum_drift_Nm_s <= flight.angular_momentum_limit_Nm_s) return;
  const bool is_derived = checked.motion.velocity_origin == Origin::kDerived;
  faults.push_back(
      {checked.motion.file, "",
       fmt::format(
           "t = {} to {} s: in flight the angular momentum about the centre of mass "
           "moves by {:.4g} Nm s from its mean of {:.4g} Nm s (limit {:.3g}). Nothing turns a body "
           "in the air. Likely cause: {}, or {}; --residual-limit allows more{}",
           io::time_text(flight.from_s), io::time_text(flight.until_s),
           flight.angular_momentum_drift_Nm_s, flight.angular_momentum_Nm_s,
           flight.angular_momentum_limit_Nm_s,
           is_derived ? "masses or inertias of another robot, a joint's sign"
                      : "velocities in other units or axes, a joint's sign, masses or "
                        "inertias of another robot",
           missed_contact(checked.motion), help_words(checked.motion))});
}

/// Difference of the file's contact forces from those that the motion asks for, all points
/// together, averaged over the motion: by Newton's law momentum alone decides it, however rough the
/// accelerations are.
double mean_force_error_N(const CheckedMotion& checked) {
  const Eigen::MatrixXd apart_N = checked.contacts.guide_N - checked.demand.forces_N;
  Eigen::Vector3d mean_N = Eigen::Vector3d::Zero();
  for (Eigen::Index row = 0; row < apart_N.rows(); row += 3) {
    mean_N += apart_N.middleRows<3>(row).rowwise().mean();
  }
  return mean_N.norm();
}

/// What impacts may carry beside the forces of samples, as a mean over the motion.
double impacts_N(const CheckedMotion& checked) {
  double impulses_N_s = 0.0;
  for (const Jolt& jolt : checked.demand.jolts) impulses_N_s += jolt.impulses_N_s.norm();
  return impulses_N_s / checked.motion.duration_s();
}

/// Refuses contact forces of a file that another robot's weight, or another unit, must have made.
void add_forces(const CheckedMotion& checked, std::vector<io::Fault>& faults) {
  if (!checked.motion.forces_guide) return;
  const double weight_N = checked.demand.weight_N;
  const double error_N = mean_force_error_N(checked);
  const double limit_N = checked.options.residual_share * weight_N + impacts_N(checked);
  if (error_N <= limit_N) return;
  const auto up_N = [](const Eigen::MatrixXd& forces_N) {
    double sum_N = 0.0;
    for (Eigen::Index row = 2; row < forces_N.rows(); row += 3) sum_N += forces_N.row(row).mean();
    return sum_N;
  };
  faults.push_back(
      {checked.motion.file, "",
       fmt::format(
           "the file's contact forces carry {:.4g} N on average. This robot's motion asks for "
           "{:.4g} N (its weight is {:.4g} N). As vectors they are off by {:.4g} N (limit {:.3g} "
           "N). Are the forces in another unit, in other axes or of another robot? Without these "
           "columns forces are solved from the motion; --residual-limit allows more",
           up_N(checked.contacts.guide_N), up_N(checked.demand.forces_N), weight_N, error_N,
           limit_N)});
}

}  // namespace

bool is_physical(const BaseResidual& residual, const std::vector<Flight>& flights) {
  const auto is_within = [](const ResidualPeak& peak) { return peak.mean <= peak.limit; };
  const bool explains = is_within(residual.force) && is_within(residual.moment) &&
                        is_within(residual.passive) && is_within(residual.lasting_force) &&
                        is_within(residual.lasting_moment);
  return explains && std::all_of(flights.begin(), flights.end(), [](const Flight& flight) {
           return flight.fall_error_m_s2 <= flight.fall_limit_m_s2 &&
                  flight.angular_momentum_drift_Nm_s <= flight.angular_momentum_limit_Nm_s;
         });
}

void require_physical(const CheckedMotion& checked, const BaseResidual& residual,
                      const std::vector<Flight>& flights) {
  std::vector<io::Fault> faults;
  for (const Flight& flight : flights) {
    add_fall(checked, flight, faults);
    add_spin(checked, flight, faults);
  }
  add_forces(checked, faults);
  const auto require_over = [&](double window_s, const char* question, const ResidualPeak& peak,
                                const char* what, const char* unit) {
    if (peak.mean <= peak.limit) return;
    faults.push_back(
        {checked.motion.file, "", sentence(what, peak, unit, window_s, checked.motion, question)});
  };
  const auto require = [&](const ResidualPeak& peak, const char* what, const char* unit) {
    require_over(residual.window_s, "Is it this robot's motion", peak, what, unit);
  };
  require(residual.force, "a force on the base", "N");
  require(residual.moment, "a moment about the centre of mass", "Nm");
  require(residual.passive,
          "a torque of joints without an actuator (forces of slides times the robot's size)", "Nm");
  if (faults.empty()) {
    const double window_s = std::min(residual.lasting_window_s, checked.motion.duration_s());
    const char* question = "It would topple or slide away: does it stay above what it stands on";
    require_over(window_s, question, residual.lasting_force, "a force on the base", "N");
    require_over(window_s, question, residual.lasting_moment, "a moment about the centre of mass",
                 "Nm");
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
}

}  // namespace torquewright::hopper
