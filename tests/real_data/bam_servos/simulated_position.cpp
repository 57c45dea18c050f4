// SPDX-License-Identifier: Apache-2.0
#include "tests/real_data/bam_servos/simulated_position.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "identification/simulated/rig_plant.hpp"
#include "io/faults/spec_error.hpp"
#include "simulation/run/simulate.hpp"

namespace torquewright::identification {
namespace {

std::vector<double> differences(const std::vector<double>& time_s,
                                const std::vector<double>& position_rad) {
  std::vector<double> speed(position_rad.size(), 0.0);
  for (std::size_t i = 0; i < speed.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, speed.size() - 1);
    if (after > before) {
      speed[i] = (position_rad[after] - position_rad[before]) / (time_s[after] - time_s[before]);
    }
  }
  return speed;
}

/// A bench's torque drive without current stands for its command.
struct DriveSource {
  Quantity quantity;
  simulation::DriveKind kind;
};
constexpr DriveSource kDriveSources[] = {
    {Quantity::kMotorCurrent, simulation::DriveKind::kCurrent},
    {Quantity::kReportedTorque, simulation::DriveKind::kTorque},
    {Quantity::kCommandedTorque, simulation::DriveKind::kTorque},
    {Quantity::kWindingVoltage, simulation::DriveKind::kVoltage},
    {Quantity::kDuty, simulation::DriveKind::kDuty}};

[[noreturn]] void refuse(const Rig& rig, const std::string& what) {
  throw io::SpecError({{rig.file, "/columns", what}});
}

simulation::JointDrive drive_of(const Rig& rig, const Channels& channels,
                                double position_gain_1_rad) {
  simulation::JointDrive drive;
  drive.bus_V = channels[Quantity::kBusVoltage];
  drive.winding_K = channels[Quantity::kWindingTemperature];
  if (drive.winding_K.empty()) drive.winding_K = channels[Quantity::kCaseTemperature];
  if (position_gain_1_rad > 0.0) {
    if (!channels.has(Quantity::kCommandedPosition)) refuse(rig, "no commanded_position_rad");
    drive.kind = simulation::DriveKind::kPosition;
    drive.value = channels[Quantity::kCommandedPosition];
    drive.position_gain_1_rad = position_gain_1_rad;
    return drive;
  }
  for (const DriveSource& source : kDriveSources) {
    if (!channels.has(source.quantity)) continue;
    drive.kind = source.kind;
    drive.value = channels[source.quantity];
    break;
  }
  if (drive.value.empty()) {
    refuse(rig,
           "nothing drives the simulation: no current, torque command, duty or winding voltage");
  }
  return drive;
}

void open_where_disabled(const Channels& channels, simulation::JointDrive& drive) {
  const std::vector<double>& enabled = channels[Quantity::kEnabled];
  if (enabled.empty()) return;
  drive.enabled.assign(enabled.begin(), enabled.end());
}

struct Sums {
  std::size_t samples = 0;
  double absolute = 0.0;
  double square = 0.0;

  void add(double error) {
    ++samples;
    absolute += std::abs(error);
    square += error * error;
  }
  double mean() const { return samples == 0 ? 0.0 : absolute / static_cast<double>(samples); }
  double rms() const {
    return samples == 0 ? 0.0 : std::sqrt(square / static_cast<double>(samples));
  }
};

std::size_t window_end(const ReplayedRun& run, std::size_t first, double window_s) {
  const std::vector<double>& time_s = run.excitation.time_s;
  if (window_s <= 0.0) return time_s.size() - 1;
  std::size_t last = first;
  while (last + 1 < time_s.size() && time_s[last] - time_s[first] < window_s) ++last;
  return last;
}

}  // namespace

std::vector<ReplayedRun> replayed_runs(const Rig& rig, const Log& log,
                                       const PositionScoreOptions& options) {
  std::vector<ReplayedRun> runs;
  for (std::size_t r = 0; r < log.runs.size(); ++r) {
    const Run& run = log.runs[r];
    const double gain =
        r < options.position_gain_1_rad.size() ? options.position_gain_1_rad[r] : 0.0;
    if (run.time_s.size() < 2) continue;
    ReplayedRun replayed;
    replayed.name = run.name;
    replayed.excitation.time_s = run.time_s;
    replayed.masked = run.masked;
    for (const Channels& channels : run.joints) {
      if (!channels.has(Quantity::kOutputPosition))
        refuse(rig, "no output_position_rad to compare");
      replayed.excitation.joints.push_back(drive_of(rig, channels, gain));
      open_where_disabled(channels, replayed.excitation.joints.back());
      replayed.position_rad.push_back(channels[Quantity::kOutputPosition]);
      // A logged velocity may be filtered or scaled; what starts a window is the position's own.
      replayed.speed_rad_s.push_back(differences(run.time_s, replayed.position_rad.back()));
    }
    runs.push_back(std::move(replayed));
  }
  return runs;
}

PositionScore position_score(const Rig& rig,
                             const std::vector<const actuator::Actuator*>& actuators,
                             const std::vector<ReplayedRun>& runs,
                             const PositionScoreOptions& options) {
  const std::unique_ptr<simulation::Plant> plant = plant_of(rig.load);
  simulation::SimulationOptions stepping;
  stepping.longest_step_s = options.longest_step_s;
  PositionScore score;
  Sums all;
  for (const ReplayedRun& run : runs) {
    Sums sums;
    const std::size_t count = run.excitation.time_s.size();
    for (std::size_t first = 0; first + 1 < count;) {
      const std::size_t last = window_end(run, first, options.window_s);
      std::vector<simulation::JointStart> start;
      for (std::size_t j = 0; j < actuators.size(); ++j) {
        start.push_back({run.position_rad[j][first], run.speed_rad_s[j][first], {}, {}});
      }
      const simulation::SimulatedRun simulated = simulation::simulate_part(
          *plant, actuators, run.excitation, start, first, last, stepping);
      score.is_finite = score.is_finite && simulated.is_finite;
      for (std::size_t j = 0; j < actuators.size(); ++j) {
        const std::vector<double>& position = simulated.joints[j].position_rad;
        for (std::size_t i = first; i <= last; ++i) {
          if (run.masked.size() == count && run.masked[i] != 0) continue;
          const bool there = i - first < position.size() && std::isfinite(position[i - first]);
          sums.add(there ? position[i - first] - run.position_rad[j][i] : std::numbers::pi);
          all.add(there ? position[i - first] - run.position_rad[j][i] : std::numbers::pi);
        }
      }
      first = last;
    }
    score.runs.push_back({run.name, sums.samples, sums.mean(), sums.rms()});
  }
  score.mean_absolute_rad = all.mean();
  score.rms_rad = all.rms();
  return score;
}

}  // namespace torquewright::identification
