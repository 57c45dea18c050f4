// SPDX-License-Identifier: Apache-2.0
#include "identification/orders.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/balance.hpp"
#include "identification/model.hpp"
#include "identification/wave_pursuit.hpp"

namespace torquewright::identification {
namespace {

constexpr double kSpectrumBand_Hz = 15.0;
constexpr std::size_t kMostOrders = 6;  ///< Of each kind.
constexpr int kHighestMotorOrder = 200;
constexpr int kHighestOutputOrder = 80;
constexpr double kLeastShare = 0.01;    ///< Of the residual's power.
constexpr std::size_t kAskedAnew = 24;  ///< Orders of the spectrum, beside one another.

/// What is left, row by row, with the angles and what waves may be multiplied with.
struct ResidualRows {
  Eigen::MatrixXd plain;  ///< What a smooth model is made of, and the target behind it.
  std::vector<double> residual, motor_rad, output_rad, load_Nm, direction, motor_Hz, output_Hz;
};

ResidualRows residual_rows(const Bench& bench, const std::vector<Signals>& signals,
                           const std::vector<std::size_t>& fold_of_run) {
  const Balance balance(bench);
  std::vector<Column> columns;
  const auto add = [&](std::function<double(const Signals&, std::size_t)> value) {
    columns.push_back({"", [value](const Signals& s, std::vector<double>& out) {
                         for (std::size_t i = 0; i < out.size(); ++i) out[i] = value(s, i);
                       }});
  };
  add([](const Signals& s, std::size_t i) { return s.at[i].direction; });
  add([](const Signals& s, std::size_t i) { return s.at[i].speed_rad_s; });
  add([](const Signals& s, std::size_t i) {
    return std::abs(s.at[i].load_torque_Nm) * s.at[i].direction;
  });
  add([&](const Signals& s, std::size_t i) { return balance.driven_Nm(s, i); });
  add([](const Signals& s, std::size_t i) { return s.at[i].acceleration_rad_s2; });
  add([](const Signals&, std::size_t) { return 1.0; });
  std::vector<const Column*> pointers;
  for (const Column& column : columns) pointers.push_back(&column);
  const Target target = [&](const Signals& s) { return torque_residual(bench, s); };
  std::vector<BandRows> parts;
  std::vector<const Signals*> owners;
  Eigen::Index total = 0;
  for (const Signals& stretch : signals) {
    if (fold_of_run[stretch.run] == Fitter::kNoFold) continue;
    parts.push_back(band_rows(stretch, pointers, target, {kSpectrumBand_Hz, 1.5, 400}));
    owners.push_back(&stretch);
    total += parts.back().values.rows();
  }
  ResidualRows rows;
  if (total < 50) return rows;
  const auto count = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd all(total, count + 1);
  Eigen::Index at = 0;
  for (const BandRows& part : parts) {
    all.middleRows(at, part.values.rows()) = part.values;
    at += part.values.rows();
  }
  // Rank-revealing: columns that coincide in this log do no harm.
  const Eigen::VectorXd fit = all.leftCols(count).colPivHouseholderQr().solve(all.col(count));
  const Eigen::VectorXd left = all.col(count) - all.leftCols(count) * fit;
  const double ratio = std::abs(bench.actuator().transmission.ratio);
  rows.plain = std::move(all);
  at = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const std::size_t i : parts[p].index) {
      const actuator::Instant& instant = owners[p]->at[i];
      rows.residual.push_back(left[at++]);
      rows.motor_rad.push_back(instant.motor_angle_rad);
      rows.output_rad.push_back(instant.output_angle_rad);
      rows.load_Nm.push_back(instant.load_torque_Nm);
      rows.direction.push_back(instant.direction);
      rows.output_Hz.push_back(std::abs(instant.speed_rad_s) / (2.0 * std::numbers::pi));
      rows.motor_Hz.push_back(rows.output_Hz.back() * ratio);
    }
  }
  return rows;
}

/// The angle of waves, its turns in a second, and what they are multiplied with (nothing: one).
struct Angle {
  const std::vector<double>& rad;
  const std::vector<double>& turns_Hz;
  const std::vector<double>* scale;

  double size(std::size_t i, int order) const {
    if (order * turns_Hz[i] > kSpectrumBand_Hz) return 0.0;
    return scale == nullptr ? 1.0 : (*scale)[i];
  }
};

/// Share of the residual's power that a wave of one order holds when it stands alone.
double share_of(const ResidualRows& rows, const Angle& angle, int order, double power) {
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
std::vector<int> loudest(const ResidualRows& rows, const Angle& angle, double range_rad,
                         int highest) {
  double power = 0.0;
  for (const double value : rows.residual) power += value * value;
  const auto lowest =
      static_cast<int>(std::ceil(2.0 * std::numbers::pi / std::max(range_rad, 1e-9) - 1e-9));
  std::vector<std::pair<double, int>> shares;
  for (int order = std::max(1, lowest); order <= highest; ++order) {
    const double share = share_of(rows, angle, order, power);
    if (share > kLeastShare) shares.emplace_back(-share, order);
  }
  std::sort(shares.begin(), shares.end());
  std::vector<int> orders;
  for (std::size_t k = 0; k < std::min(kAskedAnew, shares.size()); ++k) {
    orders.push_back(shares[k].second);
  }
  return orders;
}

/// Of those, the ones that hold power beside one another and beside the smooth model: over part of
/// a turn, or a turn at uneven speed, a strong wave sounds in many orders that are not there.
std::vector<double> peaks(const ResidualRows& rows, const Angle& angle, double range_rad,
                          int highest) {
  const std::vector<int> asked = loudest(rows, angle, range_rad, highest);
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
  for (const std::size_t place : pursuit.strongest(kMostOrders, kLeastShare)) {
    orders.push_back(asked[place]);
  }
  std::sort(orders.begin(), orders.end());
  return orders;
}

}  // namespace

Orders promising_orders(const Bench& bench, const std::vector<Signals>& signals,
                        const std::vector<std::size_t>& fold_of_run, const Extent& extent) {
  Orders orders;
  const ResidualRows rows = residual_rows(bench, signals, fold_of_run);
  if (rows.residual.empty()) return orders;
  orders.motor = peaks(rows, {rows.motor_rad, rows.motor_Hz, nullptr}, extent.motor_angle_rad,
                       kHighestMotorOrder);
  const auto output = [&](const std::vector<double>* scale) {
    return peaks(rows, {rows.output_rad, rows.output_Hz, scale}, extent.output_angle_rad,
                 kHighestOutputOrder);
  };
  orders.output = output(nullptr);
  orders.load = output(&rows.load_Nm);
  orders.friction = output(&rows.direction);
  // A pendulum's centre of mass that is not where the rig says makes a first harmonic over any
  // range: it is always asked for.
  if (extent.output_angle_rad >= std::numbers::pi / 2.0 &&
      std::find(orders.output.begin(), orders.output.end(), 1.0) == orders.output.end()) {
    orders.output.insert(orders.output.begin(), 1.0);
  }
  return orders;
}

}  // namespace torquewright::identification
