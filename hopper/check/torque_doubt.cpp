// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/torque_doubt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hopper/check/left_out_rows.hpp"
#include "hopper/demand/acceleration_doubt.hpp"
#include "hopper/demand/drive_reports.hpp"
#include "hopper/motion/rounding_words.hpp"
#include "hopper/motion/slopes.hpp"
#include "hopper/motion/smoothing.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kNotable = 0.03;  // of the peak: a warning (docs/checks.md, `torque-doubt`)
constexpr double kDeviations = 4.0;
constexpr double kMatters = 0.1;  // of the greatest peak: smaller ones do not need to be known

/// The largest of the samples within the reach.
MatrixXd spread(const MatrixXd& values, Index reach) {
  MatrixXd largest = values;
  for (Index sample = 0; sample < values.cols(); ++sample) {
    const Index first = std::max<Index>(0, sample - reach);
    const Index count = std::min(values.cols(), sample + reach + 1) - first;
    largest.col(sample) = values.middleCols(first, count).rowwise().maxCoeff();
  }
  return largest;
}

/// Windows twice as wide see the rows that were left out from so far.
void leave_out_windows(const CheckedMotion& checked, MatrixXd& change_Nm) {
  std::vector<Index> seen;
  const Index reach = 2 * checked.motion.reach;
  for (const Index row : checked.demand.left_out) {
    const Index first = std::max(row - reach, seen.empty() ? Index{0} : seen.back() + 1);
    for (Index at = first; at <= std::min(row + reach, change_Nm.cols() - 1); ++at) {
      seen.push_back(at);
    }
  }
  if (static_cast<Index>(seen.size()) < change_Nm.cols()) {
    read_between(checked.motion, seen, change_Nm);
  }
}

std::string help_words(const CheckedMotion& checked, bool by_sharing) {
  if (by_sharing) {
    return "contact forces can be shared among the points that touch in more than one way; contact "
           "forces or joint torques in the log would tell";
  }
  if (checked.motion.acceleration_doubt.size() > 0) {
    return fmt::format("accelerations are derived from {}; {} would tell",
                       source_words(checked.motion), better_log(checked.motion));
  }
  return checked.motion.velocity_origin == Origin::kDerived
             ? "accelerations are derived from positions; velocities, accelerations or samples "
               "closer together would tell"
             : "accelerations are derived; accelerations or joint torques in the log, less noise "
               "or samples closer together would tell";
}

}  // namespace

std::optional<Demand> demand_twice_as_far(const CheckedMotion& checked) {
  const bool can_be = checked.demand.has_dynamics &&
                      checked.motion.acceleration_origin == Origin::kDerived &&
                      checked.motion.samples() > 4 * checked.motion.reach + 1;
  if (!can_be) return std::nullopt;
  Motion motion = checked.motion;
  ContactSchedule contacts = checked.contacts;
  derive_rates(checked.robot.tree, motion, 2 * motion.reach);
  contacts.presses = pressing(contacts.touches, motion);
  guide_by_forces(motion, contacts);
  return demand_of(checked.robot, motion, contacts);
}

MatrixXd torque_doubts(const CheckedMotion& checked) {
  return torque_doubts(checked, demand_twice_as_far(checked));
}

MatrixXd torque_doubts(const CheckedMotion& checked, const std::optional<Demand>& twice) {
  MatrixXd doubt_Nm = checked.demand.shared_doubt_Nm;
  const Motion& motion = checked.motion;
  if (!checked.demand.has_dynamics || doubt_Nm.rows() == 0) return doubt_Nm;
  if (motion.acceleration_origin != Origin::kDerived) {
    const Eigen::VectorXd noise_Nm = sample_noise(motion, torques_by_dynamics(checked.demand));
    return doubt_Nm.colwise() + kDeviations * noise_Nm;
  }
  doubt_Nm += torques_of_acceleration_doubt(checked);
  if (!twice) return doubt_Nm;
  MatrixXd change_Nm =
      (torques_by_dynamics(*twice) - torques_by_dynamics(checked.demand)).cwiseAbs();
  leave_out_windows(checked, change_Nm);
  return doubt_Nm + spread(change_Nm, motion.reach);
}

std::vector<PeakDoubt> peak_doubts(const CheckedMotion& checked, const MatrixXd& torque_Nm,
                                   const MatrixXd& doubt_Nm) {
  std::vector<PeakDoubt> peaks;
  for (const Drivetrain& drivetrain : checked.robot.drivetrains) {
    for (const std::string& name : drivetrain.actuator_names) {
      const auto drive = static_cast<Index>(peaks.size());
      PeakDoubt& peak = peaks.emplace_back();
      peak.drive = name;
      const Eigen::VectorXd size_Nm = torque_Nm.row(drive).cwiseAbs();
      const Eigen::VectorXd doubts_Nm = doubt_Nm.row(drive);
      Index at = 0;
      peak.peak_Nm = size_Nm.maxCoeff(&at);
      peak.time_s = checked.motion.time_s(at);
      peak.least_Nm = std::max(0.0, (size_Nm - doubts_Nm).maxCoeff());
      peak.most_Nm = (size_Nm + doubts_Nm).maxCoeff(&at);
      peak.by_sharing = checked.demand.shared_doubt_Nm(drive, at) > 0.5 * doubts_Nm[at];
    }
  }
  return peaks;
}

std::vector<Finding> doubt_findings(const CheckedMotion& checked,
                                    const std::vector<PeakDoubt>& peaks,
                                    const std::vector<actuator::DriveReport>& drives) {
  double greatest_Nm = 0.0;
  for (const PeakDoubt& peak : peaks) greatest_Nm = std::max(greatest_Nm, peak.peak_Nm);
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    const PeakDoubt& peak = peaks[i];
    // What the winding's heat leaves open is said beside it.
    const bool is_open = drives[i].verdict == actuator::Verdict::kUndecided && !drives[i].held_heat;
    const bool is_notable = peak.most_Nm - peak.least_Nm > kNotable * peak.peak_Nm &&
                            peak.most_Nm > kMatters * greatest_Nm;
    if (!is_open && !is_notable) continue;
    Finding& finding = findings.emplace_back();
    finding.rule = "torque-doubt";
    finding.severity = actuator::Severity::kWarning;
    finding.joint = peak.drive;
    finding.time_s = peak.time_s;
    finding.value = peak.peak_Nm;
    finding.unit = "Nm";
    finding.sentence =
        fmt::format("{}: its peak torque, {:.4g} Nm, lies between {:.4g} and {:.4g} Nm{}: {}",
                    peak.drive, peak.peak_Nm, peak.least_Nm, peak.most_Nm,
                    is_open ? ", and its limits within what that leaves open" : "",
                    help_words(checked, peak.by_sharing));
  }
  return findings;
}

}  // namespace torquewright::hopper
