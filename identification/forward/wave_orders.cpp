// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/wave_orders.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/forward/wave_pursuit.hpp"

namespace torquewright::identification {
namespace {

constexpr double kWaveSpectrumBand_Hz = 15.0;
constexpr std::size_t kWaveLeastRows = 50;
constexpr std::size_t kWaveMostOrders = 6;  ///< Of each kind.
constexpr int kWaveHighestMotorOrder = 200;
constexpr int kWaveHighestOutputOrder = 80;
constexpr double kWaveLeastShare = 0.01;    ///< Of the residual's power.
constexpr std::size_t kWaveAskedAnew = 24;  ///< WaveOrders of the spectrum, beside one another.

/// What is left, row by row, with the angles and what waves may be multiplied with.
struct WaveRows {
  Eigen::MatrixXd plain;  ///< What a smooth model is made of, and the target behind it.
  std::vector<double> residual, motor_rad, output_rad, load_Nm, direction, motor_Hz, output_Hz;
};

/// What a smooth model of a torque balance is made of.
const std::vector<double (*)(const Signals&, std::size_t)>& smooth_columns() {
  static const std::vector<double (*)(const Signals&, std::size_t)> columns = {
      [](const Signals& s, std::size_t i) { return s.filtered_direction[i]; },
      [](const Signals& s, std::size_t i) { return s.at[i].speed_rad_s; },
      [](const Signals& s, std::size_t i) {
        return std::abs(s.at[i].load_torque_Nm) * s.filtered_direction[i];
      },
      [](const Signals& s, std::size_t i) { return s.at[i].load_torque_Nm; },
      [](const Signals& s, std::size_t i) { return s.at[i].acceleration_rad_s2; },
      [](const Signals&, std::size_t) { return 1.0; }};
  return columns;
}

/// Rows that may be fitted.
std::vector<Eigen::Index> training_rows(const Rows& rows) {
  std::vector<Eigen::Index> training;
  for (const Rows::Block& block : rows.blocks()) {
    for (Eigen::Index k = 0; k < block.count && !block.is_held_out(); ++k) {
      training.push_back(block.begin + k);
    }
  }
  return training;
}

/// Angles and factors at those rows, which are in the order of stretches and samples.
void take_instants(const Rows& rows, const std::vector<Eigen::Index>& training, double ratio,
                   WaveRows& taken) {
  std::size_t at = 0;
  Eigen::Index row = 0;
  for (std::size_t s = 0; s < rows.signals().size(); ++s) {
    for (const std::size_t i : rows.samples()[s]) {
      if (at == training.size() || training[at] != row++) continue;
      ++at;
      const actuator::Instant& instant = rows.signals()[s].at[i];
      taken.motor_rad.push_back(instant.motor_angle_rad);
      taken.output_rad.push_back(instant.output_angle_rad);
      taken.load_Nm.push_back(instant.load_torque_Nm);
      taken.direction.push_back(instant.direction);
      taken.output_Hz.push_back(std::abs(instant.speed_rad_s) / (2.0 * std::numbers::pi));
      taken.motor_Hz.push_back(taken.output_Hz.back() * std::abs(ratio));
    }
  }
}

WaveRows wave_rows(const Bench& bench, const OfStretch& left, const std::vector<Signals>& signals,
                   const std::vector<std::size_t>& fold_of_run) {
  const Rows rows(signals, fold_of_run, {kWaveSpectrumBand_Hz});
  const std::vector<Eigen::Index> training = training_rows(rows);
  WaveRows taken;
  if (training.size() < kWaveLeastRows) return taken;
  const auto count = static_cast<Eigen::Index>(smooth_columns().size());
  taken.plain.resize(static_cast<Eigen::Index>(training.size()), count + 1);
  for (Eigen::Index c = 0; c < count; ++c) {
    const auto column = smooth_columns()[static_cast<std::size_t>(c)];
    const Eigen::VectorXd all = rows.values([&](const Signals& s) {
      std::vector<double> values(s.size());
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = column(s, i);
      return values;
    });
    taken.plain.col(c) = all(training);
  }
  taken.plain.col(count) = rows.values(left)(training);
  // Rank-revealing: columns that coincide in this log do no harm.
  const Eigen::VectorXd fit =
      taken.plain.leftCols(count).colPivHouseholderQr().solve(taken.plain.col(count));
  const Eigen::VectorXd rest = taken.plain.col(count) - taken.plain.leftCols(count) * fit;
  taken.residual.assign(rest.data(), rest.data() + rest.size());
  take_instants(rows, training, bench.actuator().transmission.ratio, taken);
  return taken;
}

/// The angle of waves, its turns in a second, and what they are multiplied with (nothing: one).
struct WaveAngle {
  const std::vector<double>& rad;
  const std::vector<double>& turns_Hz;
  const std::vector<double>* scale;

  double size(std::size_t i, int order) const {
    if (order * turns_Hz[i] > kWaveSpectrumBand_Hz) return 0.0;
    return scale == nullptr ? 1.0 : (*scale)[i];
  }
};

/// Share of the residual's power that a wave of one order holds when it stands alone.
double wave_share(const WaveRows& rows, const WaveAngle& angle, int order, double power) {
  double sine = 0.0, cosine = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < angle.rad.size(); ++i) {
    const double s = angle.size(i, order);
    if (s == 0.0) continue;
    sine += rows.residual[i] * s * std::sin(order * angle.rad[i]);
    cosine += rows.residual[i] * s * std::cos(order * angle.rad[i]);
    weight += s * s;
  }
  return weight > 0.0 ? 2.0 * (sine * sine + cosine * cosine) / (weight * power) : 0.0;
}

/// The orders of the highest shares, each asked alone.
std::vector<int> loudest_waves(const WaveRows& rows, const WaveAngle& angle, double range_rad,
                               int highest) {
  double power = 0.0;
  for (const double value : rows.residual) power += value * value;
  const auto lowest =
      static_cast<int>(std::ceil(2.0 * std::numbers::pi / std::max(range_rad, 1e-9) - 1e-9));
  std::vector<std::pair<double, int>> shares;
  for (int order = std::max(1, lowest); order <= highest; ++order) {
    const double share = wave_share(rows, angle, order, power);
    if (share > kWaveLeastShare) shares.emplace_back(-share, order);
  }
  std::sort(shares.begin(), shares.end());
  std::vector<int> orders;
  for (std::size_t k = 0; k < std::min(kWaveAskedAnew, shares.size()); ++k) {
    orders.push_back(shares[k].second);
  }
  return orders;
}

/// Of those, the ones that hold power beside one another and beside the smooth model: over part of
/// a turn, or a turn at uneven speed, a strong wave sounds in many orders that are not there.
std::vector<double> wave_peaks(const WaveRows& rows, const WaveAngle& angle, double range_rad,
                               int highest) {
  const std::vector<int> asked = loudest_waves(rows, angle, range_rad, highest);
  const Eigen::Index plain = rows.plain.cols() - 1;
  WavePursuit pursuit(plain, asked.size());
  Eigen::VectorXd row(1 + plain + 2 * static_cast<Eigen::Index>(asked.size()));
  for (std::size_t i = 0; i < angle.rad.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    row[0] = rows.plain(at, plain);
    row.segment(1, plain) = rows.plain.row(at).head(plain);
    Eigen::Index c = 1 + plain;
    for (const int order : asked) {
      const double s = angle.size(i, order);
      row[c++] = s * std::sin(order * angle.rad[i]);
      row[c++] = s * std::cos(order * angle.rad[i]);
    }
    pursuit.add(row);
  }
  std::vector<double> orders;
  for (const std::size_t place : pursuit.strongest(kWaveMostOrders, kWaveLeastShare)) {
    orders.push_back(asked[place]);
  }
  std::sort(orders.begin(), orders.end());
  return orders;
}

}  // namespace

WaveOrders promising_waves(const Bench& bench, const OfStretch& left,
                           const std::vector<Signals>& signals,
                           const std::vector<std::size_t>& fold_of_run,
                           const actuator::Ranges& ranges) {
  WaveOrders orders;
  const WaveRows rows = wave_rows(bench, left, signals, fold_of_run);
  if (rows.residual.empty()) return orders;
  orders.motor = wave_peaks(rows, {rows.motor_rad, rows.motor_Hz, nullptr}, ranges.motor_angle_rad,
                            kWaveHighestMotorOrder);
  const auto output = [&](const std::vector<double>* scale) {
    return wave_peaks(rows, {rows.output_rad, rows.output_Hz, scale}, ranges.angle_rad,
                      kWaveHighestOutputOrder);
  };
  orders.output = output(nullptr);
  orders.load = output(&rows.load_Nm);
  orders.friction = output(&rows.direction);
  return orders;
}

}  // namespace torquewright::identification
