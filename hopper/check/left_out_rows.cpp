// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/left_out_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr std::size_t kNamed = 6;  // stretches of rows in a sentence

bool is_in(Index sample, const std::vector<Index>& rows) {
  return std::binary_search(rows.begin(), rows.end(), sample);
}

/// Whether what these samples ask for stays below the limits on the mean over the lasting window.
bool is_no_push(const CheckedMotion& checked, const BaseResidual& residual,
                const std::vector<Index>& rows) {
  MatrixXd asked = MatrixXd::Zero(checked.demand.residual.rows(), checked.demand.residual.cols());
  for (const Index row : rows) asked.col(row) = checked.demand.residual.col(row);
  const BaseResidual alone = base_residual(checked, asked);
  return alone.lasting_force.mean <= residual.force.limit &&
         alone.lasting_moment.mean <= residual.moment.limit;
}

/// A field of all drives as a table, and back.
void read_between(const Motion& motion, const std::vector<Index>& rows, double DriveInstant::*field,
                  std::vector<std::vector<DriveInstant>>& drives) {
  MatrixXd table(static_cast<Index>(drives.size()), motion.samples());
  const auto each = [&](const auto& take) {
    for (Index drive = 0; drive < table.rows(); ++drive) {
      for (Index sample = 0; sample < table.cols(); ++sample) {
        take(table(drive, sample),
             drives[static_cast<std::size_t>(drive)][static_cast<std::size_t>(sample)].*field);
      }
    }
  };
  each([](double& cell, double value) { cell = value; });
  hopper::read_between(motion, rows, table);
  each([](double cell, double& value) { value = cell; });
}

/// "t = 1.2 to 1.24 s, 3.02 s"
std::string times_of(const Motion& motion, const std::vector<Index>& rows) {
  std::vector<std::string> stretches;
  for (std::size_t i = 0; i < rows.size();) {
    std::size_t last = i;
    while (last + 1 < rows.size() && rows[last + 1] == rows[last] + 1) ++last;
    const std::string from = io::time_text(motion.time_s(rows[i]));
    stretches.push_back(last == i ? from
                                  : from + " to " + io::time_text(motion.time_s(rows[last])));
    i = last + 1;
  }
  const std::size_t more = stretches.size() - std::min(stretches.size(), kNamed);
  stretches.resize(stretches.size() - more);
  return fmt::format("t = {} s{}", fmt::join(stretches, ", "),
                     more > 0 ? fmt::format(" and {} more times", more) : "");
}

}  // namespace

std::vector<Index> rows_to_leave_out(const CheckedMotion& checked, const BaseResidual& residual) {
  const double share = checked.options.left_out_share;
  if (!(share > 0.0)) return {};
  std::vector<Index> rows = samples_beyond(checked, residual);
  const double most = share * static_cast<double>(checked.motion.samples());
  const bool are_few = !rows.empty() && static_cast<double>(rows.size()) <= most;
  if (!are_few || !is_no_push(checked, residual, rows)) return {};
  return rows;
}

void read_between(const Motion& motion, const std::vector<Index>& columns, MatrixXd& table) {
  for (const Index column : columns) {
    Index before = column;
    Index after = column;
    while (before >= 0 && is_in(before, columns)) --before;
    while (after < table.cols() && is_in(after, columns)) ++after;
    if (before < 0) {
      table.col(column) = table.col(after);
    } else if (after == table.cols()) {
      table.col(column) = table.col(before);
    } else {
      const double whole_s = motion.time_s(after) - motion.time_s(before);
      const double share = (motion.time_s(column) - motion.time_s(before)) / whole_s;
      table.col(column) = (1.0 - share) * table.col(before) + share * table.col(after);
    }
  }
}

void leave_out(const Motion& motion, const std::vector<Index>& rows, Demand& demand) {
  for (MatrixXd* table : {&demand.contact_Nm, &demand.unsampled_Nm_s, &demand.joint_effort,
                          &demand.forces_N, &demand.residual, &demand.shared_doubt_Nm,
                          &demand.center_of_mass_m, &demand.angular_momentum_Nm_s,
                          &demand.angular_velocity_rad_s, &demand.lateral_inertia_kg_m2}) {
    if (table->cols() == motion.samples()) read_between(motion, rows, *table);
  }
  for (double DriveInstant::*field :
       {&DriveInstant::position_rad, &DriveInstant::speed_rad_s, &DriveInstant::acceleration_rad_s2,
        &DriveInstant::load_torque_Nm, &DriveInstant::torque_Nm, &DriveInstant::carried_Nm}) {
    read_between(motion, rows, field, demand.drives);
  }
  demand.left_out = rows;
}

std::vector<Finding> left_out_findings(const CheckedMotion& checked, const BaseResidual& whole) {
  const std::vector<Index>& rows = checked.demand.left_out;
  if (rows.empty()) return {};
  const double share =
      static_cast<double>(rows.size()) / static_cast<double>(checked.motion.samples());
  Finding finding;
  finding.rule = "rows-left-out";
  finding.severity = actuator::Severity::kWarning;
  finding.time_s = checked.motion.time_s(rows.front());
  finding.value = share;
  finding.limit = checked.options.left_out_share;
  finding.sentence = fmt::format(
      "{} of {} rows ({:.3g} %) need forces that neither gravity nor inertia nor contacts explain: "
      "{}; over {:g} ms up to {:.4g} N and {:.4g} Nm (limits {:.4g} N, {:.4g} Nm). The verdict is "
      "of the other {:.4g} %; torques of these are read between the rows beside (--left-out-share, "
      "{:g}, says how many may be)",
      rows.size(), checked.motion.samples(), 100.0 * share, times_of(checked.motion, rows),
      1e3 * whole.window_s, whole.force.mean, whole.moment.mean, whole.force.limit,
      whole.moment.limit, 100.0 * (1.0 - share), checked.options.left_out_share);
  return {finding};
}

}  // namespace torquewright::hopper
