// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "actuator/check/findings.hpp"
#include "actuator/check/time_gap.hpp"
#include "actuator/check/travel_agreement.hpp"
#include "actuator/check/velocity_agreement.hpp"
#include "actuator/check/velocity_words.hpp"
#include "actuator/drive_check/drive_rows.hpp"
#include "actuator/drive_check/heat_ends.hpp"
#include "actuator/drive_check/shared_battery.hpp"
#include "io/faults/refusal.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::size_t kRowsBetweenProgress = 20000;
constexpr char kReadOnce[] = "what comes through a pipe is read once, and was judged as asked for";

/// One pass over the trajectory: rows of joints, velocities filled in; rows of drives,
/// accelerations filled in; each drive's check.
class Pass {
 public:
  explicit Pass(const CheckRequest& request)
      : request_(request),
        rows_(request.drives, request.parallels, request.trajectory.string()),
        reader_(request.trajectory, request.columns, rows_.joints(), request.window),
        agreements_(rows_.joints().size()),
        travels_(rows_.joints().size()),
        to_velocity_(position_slopes(), [this](const Row& row) { take_joints(row); }),
        to_acceleration_(speed_slopes(), [this](const Row& row) { take_drives(row); }) {
    rows_.require_positions(reader_);
    for (std::size_t i = 0; i < request.drives.size(); ++i) {
      const DriveOptions options{every_joint_has(i, &JointColumns::torque), request.inertia,
                                 request.runs, request.pause_s, request.keep_traces};
      checks_.push_back(std::make_unique<DriveCheck>(request.drives[i], options));
    }
  }

  explicit Pass(CheckRequest&&) = delete;  // it refers to it

  CheckReport run() {
    Row row;
    for (std::size_t count = 0; reader_.next(row); ++count) {
      to_velocity_.push(row);
      add_step(row.time_s);
      if (request_.on_progress && count % kRowsBetweenProgress == 0) {
        request_.on_progress(reader_.share_read());
      }
    }
    if (!has_rows_) refuse_empty();
    to_velocity_.finish();
    to_acceleration_.finish();
    return report();
  }

  /// Findings and verdict by what the drives say.
  void settle(CheckReport& report) const {
    report.findings = findings(report.drives);
    const auto some = [&](Verdict verdict) {
      return std::any_of(report.drives.begin(), report.drives.end(),
                         [verdict](const DriveReport& drive) { return drive.verdict == verdict; });
    };
    report.verdict = some(Verdict::kFail)        ? Verdict::kFail
                     : some(Verdict::kUndecided) ? Verdict::kUndecided
                                                 : Verdict::kPass;
  }

 private:
  [[noreturn]] void refuse_empty() const {
    throw io::SpecError({{reader_.file(), "",
                          reader_.has_read_rows() ? "no rows lie between --from and --until"
                                                  : "holds a header and no rows"}});
  }

  void add_step(double time_s) {
    if (!has_rows_) first_s_ = time_s;
    if (has_rows_ && time_s - last_s_ > longest_.duration_s) longest_ = {time_s - last_s_, last_s_};
    if (has_rows_) ++steps_;
    has_rows_ = true;
    last_s_ = time_s;
  }

  LongestStep longest_step() const {
    LongestStep step = longest_;
    if (steps_ > 1) {
      step.usual_s = (last_s_ - first_s_ - step.duration_s) / static_cast<double>(steps_ - 1);
    }
    return step;
  }

  std::vector<SlopeFilter::Pair> position_slopes() const {
    std::vector<SlopeFilter::Pair> pairs;
    for (std::size_t i = 0; i < rows_.joints().size(); ++i) {
      if (!reader_.columns(i).position) continue;
      pairs.push_back({kPlaces * i + kPositionAt, kPlaces * i + kSlopeAt});
    }
    return pairs;
  }

  std::vector<SlopeFilter::Pair> speed_slopes() const {
    std::vector<SlopeFilter::Pair> pairs;
    for (std::size_t i = 0; i < request_.drives.size(); ++i) {
      pairs.push_back({kDrivePlaces * i + kDriveSpeedAt, kDrivePlaces * i + kDriveAccelerationAt});
    }
    return pairs;
  }

  bool every_joint_has(std::size_t drive,
                       std::optional<JointColumns::Source> JointColumns::*quantity) const {
    const std::vector<std::size_t> joints = rows_.joints_of(drive);
    return std::all_of(joints.begin(), joints.end(), [&](std::size_t joint) {
      return (reader_.columns(joint).*quantity).has_value();
    });
  }

  /// Of a drive's output: that of its joint, where it turns one alone.
  bool knows_angle(std::size_t drive) const {
    return rows_.joints_of(drive).size() == 1 && every_joint_has(drive, &JointColumns::position);
  }

  void take_joints(const Row& row) {
    joint_row_ = row;
    for (std::size_t i = 0; i < rows_.joints().size(); ++i) {
      double* joint = &joint_row_.values[kPlaces * i];
      if (!reader_.columns(i).velocity) {
        joint[kVelocityAt] = joint[kSlopeAt];
      } else if (reader_.columns(i).position) {
        agreements_[i].add(joint[kVelocityAt], joint[kSlopeAt]);
        travels_[i].add(row.time_s, joint[kPositionAt], joint[kVelocityAt]);
      }
    }
    rows_.convert(joint_row_, drive_row_);
    to_acceleration_.push(drive_row_);
  }

  void take_drives(const Row& row) {
    for (std::size_t i = 0; i < checks_.size(); ++i) {
      const double* drive = &row.values[kDrivePlaces * i];
      const std::optional<double> position_rad =
          knows_angle(i) ? std::optional(drive[kDrivePositionAt]) : std::nullopt;
      checks_[i]->add(row.time_s, position_rad, drive[kDriveSpeedAt], drive[kDriveTorqueAt],
                      drive[kDriveAccelerationAt]);
    }
  }

  /// The joint of a drive whose velocity least agrees with its position, if it is logged at all.
  void add_agreement(std::size_t drive, DriveReport& report) const {
    const std::vector<std::size_t> joints = rows_.joints_of(drive);
    report.is_speed_differentiated = !every_joint_has(drive, &JointColumns::velocity);
    for (const std::size_t joint : joints) {
      const AngleUnwrap& unwrap = reader_.unwrap(joint);
      if (unwrap.count() <= report.unwrapped) continue;
      report.unwrapped = unwrap.count();
      report.unwrapped_from_s = unwrap.first_s();
    }
    if (joints.size() != 1) return;
    report.velocity_over_slope = agreements_[joints.front()].factor();
    report.velocity_correlation = agreements_[joints.front()].correlation();
  }

  void require_seen_speeds(const std::vector<DriveReport>& drives) const {
    const bool differentiated =
        std::any_of(drives.begin(), drives.end(),
                    [](const DriveReport& one) { return one.is_speed_differentiated; });
    if (!differentiated || !hides_motion(longest_step())) return;
    io::refuse(reader_.file(),
               hidden_motion_sentence(longest_step(), reader_.clock().origin_s(), "velocities"));
  }

  std::size_t rows() const { return steps_ + 1; }

  /// Two rows have a velocity where it is differentiated, three an acceleration, which a rotor's
  /// torque takes unless the file's holds it.
  void require_rates(const std::vector<DriveReport>& drives) const {
    const auto some = [&](auto holds) { return std::any_of(drives.begin(), drives.end(), holds); };
    const bool differentiates = some([](const auto& one) { return one.is_speed_differentiated; });
    const bool adds_rotors =
        request_.inertia != InertiaConvention::kIncluded &&
        some([](const auto& one) { return one.has_torque && one.armature_kg_m2 > 0.0; });
    const std::size_t least = 1 + (adds_rotors ? 1 : 0) + (differentiates ? 1 : 0);
    if (rows() >= least) return;
    const bool is_open = adds_rotors && request_.inertia == InertiaConvention::kUnstated;
    io::refuse(
        reader_.file(),
        fmt::format("{} cannot be had from fewer than {} rows, and there {}; {}{}take more "
                    "rows (--from, --until)",
                    adds_rotors ? "the rotors' acceleration" : "velocities", least,
                    rows() == 1 ? "is one" : "are two",
                    is_open ? "say --torque-includes-inertia if the file's torque does, " : "",
                    differentiates ? "state velocities in the file, or " : "or "));
  }

  void require_own_velocities(const std::vector<DriveReport>& drives) const {
    for (std::size_t i = 0; i < drives.size(); ++i) {
      for (const std::size_t joint : rows_.joints_of(i)) {
        const auto found = travels_[joint].contradiction(drives[i].no_load_speed_rad_s);
        if (!found) continue;
        io::refuse(reader_.file(),
                   contradiction_sentence(rows_.joints()[joint], *found, reader_.clock().origin_s(),
                                          agreements_[joint]));
      }
    }
  }

  CheckReport report() {
    CheckReport result;
    for (std::size_t i = 0; i < checks_.size(); ++i) {
      DriveReport drive = checks_[i]->finish();
      add_agreement(i, drive);
      if (request_.keep_traces) result.traces.push_back(checks_[i]->trace());
      result.drives.push_back(std::move(drive));
    }
    require_rates(result.drives);
    require_seen_speeds(result.drives);
    require_own_velocities(result.drives);
    settle(result);
    result.sha256 = reader_.sha256();
    return result;
  }

  std::vector<Finding> findings(const std::vector<DriveReport>& drives) const {
    std::vector<Finding> findings = findings_of(drives);
    if (const std::string shifted = reader_.clock().sentence(); !shifted.empty()) {
      Finding finding;
      finding.rule = "clock";
      finding.severity = Severity::kNote;
      finding.sentence = shifted;
      findings.push_back(std::move(finding));
    }
    if (auto gap = gap_finding(longest_step())) findings.push_back(std::move(*gap));
    for (Finding& finding : shared_battery_findings(request_.drives)) {
      findings.push_back(std::move(finding));
    }
    return findings;
  }

  const CheckRequest& request_;
  DriveRows rows_;
  TrajectoryReader reader_;
  std::vector<VelocityAgreement> agreements_;
  std::vector<TravelAgreement> travels_;
  SlopeFilter to_velocity_;
  SlopeFilter to_acceleration_;
  std::vector<std::unique_ptr<DriveCheck>> checks_;
  Row joint_row_;
  Row drive_row_;
  bool has_rows_ = false;
  double first_s_ = 0.0;
  double last_s_ = 0.0;
  std::size_t steps_ = 0;
  LongestStep longest_;
};

using Ends = std::vector<std::vector<HeatEnd>>;

/// By drive.
Ends ends_to_judge(const CheckRequest& request, const CheckReport& report) {
  Ends ends;
  for (std::size_t i = 0; i < request.drives.size(); ++i) {
    ends.push_back(heat_ends(request.drives[i], report.drives[i]));
    if (!need_judging(report.drives[i], ends.back())) ends.back().clear();
  }
  return ends;
}

/// With windings as warm as at one of their ends; empty where none is to be judged there.
std::optional<CheckRequest> at_end(CheckRequest request, const Ends& ends, std::size_t which) {
  bool some = false;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i].size() <= which || !ends[i][which].is_to_be_judged()) continue;
    request.drives[i].conditions = ends[i][which].conditions;
    some = true;
  }
  return some ? std::optional(std::move(request)) : std::nullopt;
}

bool can_be_read_again(const std::filesystem::path& file) {
  std::error_code unknown;
  return std::filesystem::is_regular_file(file, unknown);
}

/// Whole checks at the coldest and at the warmest; empty where there is none.
using AtEnds = std::array<std::optional<CheckReport>, 2>;

void settle_drive(std::size_t drive, const std::vector<HeatEnd>& ends, const AtEnds& at_ends,
                  const std::string& why_not, CheckReport& report) {
  std::vector<std::optional<DriveReport>> there(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (at_ends[i] && ends[i].is_to_be_judged()) there[i] = at_ends[i]->drives[drive];
  }
  DriveReport& mine = report.drives[drive];
  mine = judged_at_ends(std::move(mine), ends, std::move(there), why_not);
  if (report.traces.empty() || !mine.held_heat->shown_K) return;
  const std::size_t shown = *mine.held_heat->shown_K == ends.front().winding_K ? 0 : 1;
  report.traces[drive] = at_ends[shown]->traces[drive];
}

}  // namespace

CheckReport check(const CheckRequest& request) {
  Pass pass(request);
  CheckReport report = pass.run();
  const Ends ends = ends_to_judge(request, report);
  const bool is_pipe = !can_be_read_again(request.trajectory);
  AtEnds at_ends;
  for (std::size_t which = 0; which < at_ends.size() && !is_pipe; ++which) {
    const std::optional<CheckRequest> there = at_end(request, ends, which);
    if (there) at_ends[which] = Pass(*there).run();
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!ends[i].empty()) settle_drive(i, ends[i], at_ends, kReadOnce, report);
  }
  pass.settle(report);
  return report;
}

}  // namespace torquewright::actuator
