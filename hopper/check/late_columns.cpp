// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/late_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hopper/demand/drive_reports.hpp"
#include "hopper/motion/slopes.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kFewestSamples = 10;
constexpr std::size_t kMostRows =
    2000;  // at which the base is asked: where the column changes most
constexpr double kModelErrs =
    2.0;  // times less that the row before must leave where a model judges
constexpr double kLeastShare = 1e-12;

/// Beginning and middle of a step, for simulators of first and of second order.
const std::vector<RowSpan> kStepOwn{{0, 0}, {0, 1}};
const std::vector<RowSpan> kStepBefore{{1, 1}, {1, 2}};
/// Of a sample whose accelerations are given,
const std::vector<RowSpan> kSampleOwn{{0, 0}};
const std::vector<RowSpan> kSampleBefore{{1, 1}};
/// and derived: centred, or half a step early.
const std::vector<RowSpan> kSlopeOwn{{0, 0}, {-1, 0}};
const std::vector<RowSpan> kSlopeBefore{{1, 1}, {0, 1}};

bool states_impacts(const Motion& motion) {
  for (Index i = 0; i + 1 < motion.samples(); ++i) {
    if (motion.step_s(i) == 0.0) return true;
  }
  return false;
}

LateColumns given_columns(const Motion& motion) {
  LateColumns given;
  given.accelerations = motion.acceleration_origin == Origin::kGiven;
  given.forces = motion.has_base && motion.has_forces;
  // Where accelerations are derived, points may press some rows before and after they touch.
  given.flags = motion.has_base && motion.has_touching && !motion.has_forces && given.accelerations;
  given.torques =
      std::any_of(motion.has_effort.begin(), motion.has_effort.end(), [](bool has) { return has; });
  return given;
}

/// No impact lies between the rows that the readings of one look at.
bool is_smooth(const Motion& motion, Index row) {
  for (int at = RowComparison::kFirst + 1; at <= RowComparison::kLast; ++at) {
    if (motion.is_break(row + at)) return false;
  }
  return true;
}

/// The rows after which a table changes most, ascending; each has the neighbours that readings ask.
std::vector<Index> changing_rows(const Motion& motion, const MatrixXd& table) {
  std::vector<Index> rows;
  for (Index row = -RowComparison::kFirst; row + RowComparison::kLast < motion.samples(); ++row) {
    if (is_smooth(motion, row)) rows.push_back(row);
  }
  if (rows.size() <= kMostRows) return rows;
  VectorXd change = VectorXd::Zero(motion.samples());
  for (const Index row : rows) change[row] = (table.col(row + 1) - table.col(row)).squaredNorm();
  const auto middle = rows.begin() + kMostRows;
  std::nth_element(rows.begin(), middle, rows.end(),
                   [&](Index one, Index other) { return change[one] > change[other]; });
  rows.resize(kMostRows);
  std::sort(rows.begin(), rows.end());
  return rows;
}

MatrixXd columns_of(const MatrixXd& table, std::vector<Index> rows, int later) {
  for (Index& row : rows) row += later;
  return table.size() > 0 ? MatrixXd(table(Eigen::all, rows)) : table;
}

/// Some rows of a motion whose rates are derived, as a motion of its own.
Motion some_rows(const Motion& motion, const std::vector<Index>& rows) {
  Motion some;
  some.file = motion.file;
  for (const Index row : rows) some.times_s.push_back(motion.time_s(row));
  some.positions = columns_of(motion.positions, rows, 0);
  some.velocities = columns_of(motion.velocities, rows, 0);
  some.accelerations = columns_of(motion.accelerations, rows, 0);
  some.efforts = columns_of(motion.efforts, rows, 0);
  some.forces_N = columns_of(motion.forces_N, rows, 0);
  some.has_effort = motion.has_effort;
  some.has_forces = motion.has_forces;
  return some;
}

/// Heights are what given forces need of it, touching what solved ones do.
ContactSchedule some_rows(const ContactSchedule& schedule, const std::vector<Index>& rows) {
  ContactSchedule some;
  some.touches = schedule.touches(Eigen::all, rows);
  some.height_m = columns_of(schedule.height_m, rows, 0);
  return some;
}

/// Eq. (23): what the step's change of velocity leaves.
RowEvidence by_velocities(const Motion& derived) {
  RowComparison comparison(kStepOwn, kStepBefore);
  for (Index row = 0; row + RowComparison::kLast < derived.samples(); ++row) {
    if (!is_smooth(derived, row)) continue;
    const VectorXd rate =
        (derived.velocities.col(row + 1) - derived.velocities.col(row)) / derived.step_s(row);
    RowComparison::Left left;
    for (int later = 0; later <= RowComparison::kLast; ++later) {
      left[static_cast<std::size_t>(later - RowComparison::kFirst)] =
          rate - derived.accelerations.col(row + later);
    }
    comparison.add(left);
  }
  return comparison.evidence();
}

/// A comparison of samples, and by how many rows its readings reach.
struct SampleReadings {
  explicit SampleReadings(const Motion& derived)
      : is_given(derived.acceleration_origin == Origin::kGiven),
        first(is_given ? 0 : RowComparison::kFirst),
        comparison(is_given ? kSampleOwn : kSlopeOwn, is_given ? kSampleBefore : kSlopeBefore) {}

  bool is_given;
  int first;
  RowComparison comparison;

  /// Of every sample; tables of rows by sample, one for each of the rows from `first` to 1.
  RowEvidence evidence(const std::vector<MatrixXd>& tables) {
    for (Index sample = 0; sample < tables.front().cols(); ++sample) {
      RowComparison::Left left;
      for (std::size_t i = 0; i < tables.size(); ++i) {
        left[i + static_cast<std::size_t>(first - RowComparison::kFirst)] = tables[i].col(sample);
      }
      comparison.add(left);
    }
    return comparison.evidence();
  }
};

/// Eq. (24): what the base's rows leave.
RowEvidence forces_by_base(const Robot& robot, const Motion& derived,
                           const ContactSchedule& schedule) {
  SampleReadings readings(derived);
  const MatrixXd forces_N =
      readings.is_given ? derived.forces_N : spread_as_accelerations(derived, derived.forces_N);
  const std::vector<Index> rows = changing_rows(derived, forces_N);
  if (rows.empty()) return {};
  Motion some = some_rows(derived, rows);
  const ContactSchedule contacts = some_rows(schedule, rows);
  std::vector<MatrixXd> left;
  for (int later = readings.first; later <= 1; ++later) {
    some.forces_N = columns_of(forces_N, rows, later);
    left.push_back(demand_of(robot, some, contacts).residual);
  }
  return left.front().rows() > 0 ? readings.evidence(left) : RowEvidence{};
}

/// The same with the shortest forces of the points that are said to touch.
RowEvidence flags_by_base(const Robot& robot, const Motion& derived,
                          const ContactSchedule& schedule) {
  std::vector<Index> rows = changing_rows(derived, derived.touching);
  std::erase_if(rows, [&](Index row) {
    return (derived.touching.col(row) - derived.touching.col(row + 1)).isZero(0.0);
  });
  if (rows.empty()) return {};
  const Motion some = some_rows(derived, rows);
  const std::vector<double> left =
      unexplained_shares(robot, some, some_rows(schedule, rows),
                         {columns_of(derived.touching, rows, 0).array() != 0.0,
                          columns_of(derived.touching, rows, 1).array() != 0.0});
  RowEvidence evidence;
  evidence.differs = true;
  evidence.times_less = (left[0] + kLeastShare) / (left[1] + kLeastShare);
  evidence.log_odds = static_cast<double>(rows.size()) * std::log(evidence.times_less);
  return evidence;
}

/// Eq. (25): file less dynamics, without or with the rotors, whichever is nearer.
RowEvidence torques_by_drives(const Motion& motion, const Demand& demand, bool is_moved) {
  SampleReadings readings(motion);
  const std::vector<Index> rows = changing_rows(motion, demand.file_torque_Nm);
  const int shift = is_moved ? 1 : 0;  // of the file's rows against the motion's
  const auto near = [&](const MatrixXd& torque_Nm, int later) -> MatrixXd {
    return columns_of(demand.file_torque_Nm, rows, later - shift) - columns_of(torque_Nm, rows, 0);
  };
  const MatrixXd with = torques_by_dynamics(demand);
  const MatrixXd without = load_torques_by_dynamics(demand);
  const bool holds_rotors = near(with, shift).norm() <= near(without, shift).norm();
  std::vector<MatrixXd> left;
  for (int later = readings.first; later <= 1; ++later) {
    left.push_back(near(holds_rotors ? with : without, later));
  }
  return rows.empty() ? RowEvidence{} : readings.evidence(left);
}

LateColumns turned(LateColumns columns, const LateColumns& open) {
  for (const auto column : {&LateColumns::accelerations, &LateColumns::forces, &LateColumns::flags,
                            &LateColumns::torques}) {
    columns.*column = columns.*column != open.*column;
  }
  return columns;
}

}  // namespace

std::string words_of(const LateColumns& columns) {
  std::vector<std::string> words;
  if (columns.accelerations) words.emplace_back("accelerations");
  if (columns.forces) words.emplace_back("contact forces");
  if (columns.flags) words.emplace_back("contact flags");
  if (columns.torques) words.emplace_back("torques");
  return fmt::format("{}", fmt::join(words, " and "));
}

Motion moved_to_row_before(Motion motion, const LateColumns& columns) {
  if (!columns.any()) return motion;
  const Index rows = motion.samples() - 1;
  const auto take = [&](bool is_late, MatrixXd& table) {
    if (table.cols() == 0) return;
    table = is_late ? MatrixXd(table.rightCols(rows)) : MatrixXd(table.leftCols(rows));
  };
  take(false, motion.positions);
  take(false, motion.velocities);
  take(columns.accelerations, motion.accelerations);
  take(columns.torques, motion.efforts);
  take(columns.forces, motion.forces_N);
  take(columns.flags, motion.touching);
  motion.times_s.pop_back();
  return motion;
}

RowReading::RowReading(const Robot& robot, const CheckOptions& options, Motion& motion)
    : file_(motion), given_(given_columns(motion)) {
  const bool is_short = motion.samples() < kFewestSamples;
  const bool has_impacts = states_impacts(motion);
  if (options.late_columns == LateRows::kShift) {
    if (!given_.any()) {
      io::refuse(motion.file,
                 "--late-columns shift: there is nothing to shift, neither accelerations nor "
                 "contact forces nor torques (contact flags are shifted beside accelerations)");
    }
    if (has_impacts) {
      io::refuse(motion.file,
                 "--late-columns shift: two rows of one time state an impact, as no log of a "
                 "simulator's steps does");
    }
    if (!is_short) late_ = given_;
    motion = moved_to_row_before(file_, late_);
  }
  if (options.late_columns != LateRows::kFind || is_short || has_impacts || !given_.any()) return;
  is_judged_ = true;
  judge(robot, options, motion);
}

void RowReading::judge(const Robot& robot, const CheckOptions& options, Motion& motion) {
  Motion derived;
  ContactSchedule schedule;
  const auto prepare = [&] {
    motion = derived = moved_to_row_before(file_, late_);
    schedule = schedule_contacts(robot, options.contact, derived);
  };
  prepare();
  if (given_.accelerations) settle(&LateColumns::accelerations, by_velocities(derived), false);
  // Flags and torques of a simulator's step are likely to go with its accelerations.
  late_.torques = given_.torques && late_.accelerations;
  if (late_.any()) prepare();
  if (given_.forces) {
    settle(&LateColumns::forces, forces_by_base(robot, derived, schedule), true);
  } else if (given_.flags) {
    settle(&LateColumns::flags, flags_by_base(robot, derived, schedule), true);
  }
  motion = moved_to_row_before(file_, late_);
}

void RowReading::settle(bool LateColumns::*column, const RowEvidence& evidence, bool by_model) {
  const bool is_clear = !by_model || evidence.times_less >= kModelErrs;
  const bool is_before = evidence.is_before() && is_clear;
  open_.*column = evidence.is_open() || (evidence.is_before() && !is_clear);
  const bool is_told = is_before || evidence.is_own();
  late_.*column = is_told ? is_before : late_.accelerations;
  if (!is_before) return;
  LateColumns one;
  one.*column = true;
  reasons_.push_back(
      fmt::format("{} leave {:.3g} times less unexplained so", words_of(one), evidence.times_less));
}

bool RowReading::settle_torques(const Demand& demand, Motion& motion) {
  if (!is_judged_ || !given_.torques || demand.file_torque_Nm.size() == 0 || !demand.has_dynamics) {
    return false;
  }
  const bool was_late = late_.torques;
  settle(&LateColumns::torques, torques_by_drives(motion, demand, was_late), true);
  if (late_.torques == was_late) return false;
  motion = moved_to_row_before(file_, late_);
  return true;
}

std::vector<Finding> RowReading::findings() const {
  if (!late_.any()) return {};
  Finding finding;
  finding.rule = "late-columns";
  finding.sentence = fmt::format(
      "{} belong to the row before, as where a simulator stores what it computed at the beginning "
      "of a step beside the positions at its end: moved by one row, and the last row left out{}; "
      "--late-columns keep takes them as they stand",
      words_of(late_), reasons_.empty() ? "" : fmt::format(" ({})", fmt::join(reasons_, ", ")));
  return {finding};
}

std::optional<Motion> RowReading::other() const {
  if (!open_.any()) return std::nullopt;
  return moved_to_row_before(file_, turned(late_, open_));
}

void RowReading::take_other() {
  late_ = turned(late_, open_);
  open_ = {};
  reasons_ = {"else it is no motion"};
}

}  // namespace torquewright::hopper
