// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "actuator/check/drive_rows.hpp"
#include "actuator/check/findings.hpp"
#include "actuator/check/last_run_heat.hpp"
#include "actuator/check/shared_battery.hpp"
#include "actuator/check/travel_agreement.hpp"
#include "actuator/check/velocity_agreement.hpp"
#include "io/refusal.hpp"
#include "io/spec_error.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::size_t kRowsBetweenProgress = 20000;

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
      checks_[i]->add(row.time_s, drive[kDriveSpeedAt], drive[kDriveTorqueAt],
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

using Heats = std::vector<std::optional<LastRunHeat>>;

/// By drive; empty where none is warmer in its last run than its region was asked at.
Heats last_run_heats(const CheckRequest& request, const CheckReport& report) {
  Heats heats;
  for (std::size_t i = 0; i < request.drives.size(); ++i) {
    heats.push_back(last_run_heat(request.drives[i], report.drives[i]));
  }
  const bool some =
      std::any_of(heats.begin(), heats.end(), [](const auto& heat) { return !!heat; });
  return some ? heats : Heats{};
}

CheckRequest at_heat(CheckRequest request, const Heats& heats,
                     OperatingConditions LastRunHeat::*which) {
  for (std::size_t i = 0; i < heats.size(); ++i) {
    if (heats[i]) request.drives[i].conditions = (*heats[i]).*which;
  }
  return request;
}

/// Of what comes through a pipe, which cannot be read again.
Finding read_once() {
  Finding finding;
  finding.severity = Severity::kWarning;
  finding.rule = "winding-temperature";
  finding.sentence =
      "windings get warmer than their regions were asked at, and what comes through a pipe is "
      "read once: check it again with --winding-temperature, or from a file";
  return finding;
}

/// Holds what passes cold against the heat of its last run.
CheckReport held_warm(const CheckRequest& request, const Heats& heats, CheckReport cold) {
  const CheckRequest at_warmest = at_heat(request, heats, &LastRunHeat::warmest);
  const CheckRequest at_coldest = at_heat(request, heats, &LastRunHeat::coldest);
  Pass pass(at_warmest);
  CheckReport warmest = pass.run();
  if (warmest.verdict != Verdict::kFail) return cold;
  const CheckReport coldest = Pass(at_coldest).run();
  for (std::size_t i = 0; i < heats.size(); ++i) {
    DriveReport& drive = warmest.drives[i];
    const bool turns = heats[i] && drive.verdict == Verdict::kFail;
    if (turns) hold_warm(*heats[i], coldest.drives[i].verdict, drive);
  }
  pass.settle(warmest);
  return warmest;
}

}  // namespace

CheckReport check(const CheckRequest& request) {
  CheckReport report = Pass(request).run();
  if (report.verdict == Verdict::kFail) return report;
  const Heats heats = last_run_heats(request, report);
  if (heats.empty()) return report;
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(request.trajectory, unknown)) {
    report.findings.push_back(read_once());
    return report;
  }
  return held_warm(request, heats, std::move(report));
}

}  // namespace torquewright::actuator
