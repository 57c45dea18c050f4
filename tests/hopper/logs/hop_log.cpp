// SPDX-License-Identifier: Apache-2.0
#include "tests/hopper/logs/hop_log.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

namespace torquewright::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using hopper::Motion;
using hopper::Origin;

constexpr double kLanding_s = 0.06;
constexpr double kLongFlight_s = 0.1;
constexpr double kMatters = 0.1;

MatrixXd every(const MatrixXd& table, Index stride) {
  return table(Eigen::all, Eigen::seq(0, Eigen::last, stride));
}

class Noise {
 public:
  void add(double deviation, Eigen::Ref<MatrixXd> table) {
    for (Index column = 0; column < table.cols(); ++column) {
      for (Index row = 0; row < table.rows(); ++row) table(row, column) += deviation * draw();
    }
  }

  /// A small turn of the base beside the offsets of all else.
  void add_to_positions(bool is_spatial, double deviation, MatrixXd& positions) {
    if (!is_spatial) return add(deviation, positions);
    for (Index column = 0; column < positions.cols(); ++column) {
      const Eigen::Vector3d turn(draw(), draw(), draw());
      const Eigen::Quaterniond small(Eigen::AngleAxisd(deviation * turn.norm(), turn.normalized()));
      const Eigen::Vector4d q = positions.block<4, 1>(3, column);
      const Eigen::Quaterniond turned = Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * small;
      positions.block<4, 1>(3, column) << turned.w(), turned.vec();
    }
    add(deviation, positions.topRows(3));
    add(deviation, positions.bottomRows(positions.rows() - 7));
  }

 private:
  double draw() { return normal_(engine_); }

  std::mt19937_64 engine_{15};
  std::normal_distribution<double> normal_;
};

/// From the sample at which the longest flight ends.
Index touch_down(const SimulatedHop& hop) {
  Index longest = 0, end = 0, flown = 0;
  for (Index i = 0; i < hop.motion.samples(); ++i) {
    flown = hop.motion.touching.col(i).any() ? 0 : flown + 1;
    if (flown <= longest) continue;
    longest = flown;
    end = i + 1;
  }
  return end;
}

double upward_impulse_N_s(const Motion& motion, const MatrixXd& forces_N, double from_s,
                          double until_s) {
  double sum_N_s = 0.0;
  const auto upward_N = [&](Index i) {
    return forces_N.col(i)(Eigen::seq(2, Eigen::last, 3)).sum();
  };
  for (Index i = 0; i + 1 < motion.samples(); ++i) {
    if (motion.time_s(i) < from_s - 1e-9 || motion.time_s(i + 1) > until_s + 1e-9) continue;
    sum_N_s += 0.5 * motion.step_s(i) * (upward_N(i) + upward_N(i + 1));
  }
  return sum_N_s;
}

void compare_torques(const SimulatedHop& hop, const hopper::HopperReport& report,
                     HopErrors& errors) {
  const MatrixXd& truth = hop.motion.efforts;
  const double greatest = truth.cwiseAbs().maxCoeff();
  for (Index joint = 0; joint < truth.rows(); ++joint) {
    const double peak = truth.row(joint).cwiseAbs().maxCoeff();
    if (peak < kMatters * greatest) continue;
    const double rms = truth.row(joint).norm() / std::sqrt(static_cast<double>(truth.cols()));
    const auto& found = report.check.drives[static_cast<std::size_t>(joint)].interpretation;
    errors.peak = std::max(errors.peak, std::abs(found.peak_torque_Nm - peak) / peak);
    errors.rms = std::max(errors.rms, std::abs(found.rms_torque_Nm - rms) / rms);
    if (report.peak_doubts.empty()) continue;  // the file's torques count
    const hopper::PeakDoubt& doubt = report.peak_doubts[static_cast<std::size_t>(joint)];
    const bool is_within =
        peak <= (1.0 + kTorqueGoal) * doubt.most_Nm && peak >= (1.0 - kTorqueGoal) * doubt.least_Nm;
    errors.is_known = errors.is_known && is_within;
    errors.doubt = std::max(errors.doubt, (doubt.most_Nm - doubt.least_Nm) / peak);
  }
}

}  // namespace

std::string words_of(const LogContent& content) {
  std::string text = content.velocities ? "q, v" : "q";
  if (content.accelerations) text += ", a";
  if (content.forces) text += ", forces";
  if (content.flags) text += ", flags";
  if (content.torques) text += ", torques";
  if (content.late) text += "; a row late";
  return text;
}

namespace {

/// As a simulator stores it: what it computed at a row's beginning beside the next one's state.
void make_late(Motion& log) {
  const Index rows = log.samples() - 1;
  log.times_s.erase(log.times_s.begin());
  for (MatrixXd* table : {&log.positions, &log.velocities}) {
    *table = MatrixXd(table->rightCols(rows));
  }
  for (MatrixXd* table : {&log.accelerations, &log.efforts, &log.forces_N, &log.touching}) {
    *table = MatrixXd(table->leftCols(rows));
  }
}

}  // namespace

Motion log_of(const PublicHopper& hopper, const SimulatedHop& hop, const LogContent& content) {
  const Motion& all = hop.motion;
  const auto stride = static_cast<Index>(std::lround(1.0 / (content.rate_Hz * hop.step_s)));
  Motion log;
  log.file = all.file;
  for (Index i = 0; i < all.samples(); i += stride) log.times_s.push_back(all.time_s(i));
  const SensorNoise sigma;
  Noise noise;
  log.positions = every(all.positions, stride);
  const bool is_spatial = hopper.robot.tree.base == dynamics::BaseKind::kSpatial;
  noise.add_to_positions(is_spatial, content.noise * sigma.position, log.positions);
  log.velocity_origin = content.velocities ? Origin::kGiven : Origin::kAbsent;
  log.velocities = every(all.velocities, stride);
  noise.add(content.noise * sigma.velocity, log.velocities);
  log.acceleration_origin = content.accelerations ? Origin::kGiven : Origin::kAbsent;
  log.accelerations = every(all.accelerations, stride);
  noise.add(content.noise * sigma.acceleration, log.accelerations);
  log.efforts = every(all.efforts, stride);
  log.has_effort.assign(static_cast<std::size_t>(all.efforts.rows()), content.torques);
  log.has_forces = content.forces;
  log.has_touching = content.flags;
  log.touching = every(all.touching, stride);
  log.forces_N = every(all.forces_N, stride);
  MatrixXd off = MatrixXd::Zero(log.forces_N.rows(), log.samples());
  noise.add(content.noise * sigma.force_share * log.forces_N.cwiseAbs().maxCoeff(), off);
  log.forces_N.array() += (log.forces_N.array() != 0.0).select(off.array(), 0.0);
  if (content.late) make_late(log);
  return log;
}

HopErrors errors_of(const SimulatedHop& hop, const Motion& log,
                    const hopper::HopperReport& report) {
  HopErrors errors;
  compare_torques(hop, report, errors);
  std::vector<Index> fine;
  for (const double time_s : log.times_s) fine.push_back(std::lround(time_s / hop.step_s));
  const MatrixXd momentum = hop.angular_momentum_Nm_s(Eigen::all, fine);
  const double greatest = hop.angular_momentum_Nm_s.colwise().norm().maxCoeff();
  errors.momentum =
      (report.demand.angular_momentum_Nm_s - momentum).colwise().norm().maxCoeff() / greatest;
  for (const hopper::Flight& flight : report.flights) {
    const double middle_s = 0.5 * (flight.from_s + flight.until_s);
    const auto at = static_cast<Index>(std::lround(middle_s / hop.step_s));
    if (flight.until_s - flight.from_s < kLongFlight_s) continue;
    const double truth = hop.angular_momentum_Nm_s.col(at).norm();
    errors.flight_momentum =
        std::max(errors.flight_momentum, std::abs(flight.angular_momentum_Nm_s - truth) / truth);
  }
  // From a sample of the log in flight to one on the ground.
  const double landed_s = hop.motion.time_s(touch_down(hop));
  const double step_s = log.step_s(0);
  const double from_s = std::floor(landed_s / step_s + 1e-6) * step_s - 2.0 * step_s;
  const double until_s = from_s + std::round(kLanding_s / step_s) * step_s;
  const double truth_N_s = upward_impulse_N_s(hop.motion, hop.motion.forces_N, from_s, until_s);
  double found_N_s = upward_impulse_N_s(log, report.demand.forces_N, from_s, until_s);
  for (const hopper::Jolt& jolt : report.demand.jolts) {
    if (jolt.time_s <= from_s || jolt.time_s > until_s) continue;
    found_N_s += jolt.impulses_N_s(Eigen::seq(2, Eigen::last, 3)).sum();
  }
  errors.impulse = std::abs(found_N_s - truth_N_s) / truth_N_s;
  return errors;
}

}  // namespace torquewright::test
