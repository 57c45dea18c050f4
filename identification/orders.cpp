// SPDX-License-Identifier: Apache-2.0
#include "identification/orders.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/balance.hpp"
#include "identification/model.hpp"

namespace torquewright::identification {
namespace {

constexpr double kSpectrumBand_Hz = 15.0;
constexpr std::size_t kMostOrders = 6;  ///< Of each kind.
constexpr int kHighestMotorOrder = 200;
constexpr int kHighestOutputOrder = 80;
constexpr double kLeastShare = 0.01;  ///< Of the residual's power.

/// What is left, row by row, with the angles and what waves may be multiplied with.
struct LeftOver {
  std::vector<double> residual, motor_rad, output_rad, load_Nm, direction, motor_Hz, output_Hz;
};

LeftOver left_over(const Bench& bench, const std::vector<Signals>& signals,
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
  LeftOver rows;
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

/// Peaks of the share of power that a wave of each whole order holds.
std::vector<double> peaks(const LeftOver& rows, const std::vector<double>& angle_rad,
                          const std::vector<double>& turns_Hz, const std::vector<double>* scale,
                          double range_rad, int highest) {
  std::vector<double> share(static_cast<std::size_t>(highest) + 2, 0.0);
  double power = 0.0;
  for (const double value : rows.residual) power += value * value;
  const auto lowest =
      static_cast<int>(std::ceil(2.0 * std::numbers::pi / std::max(range_rad, 1e-9) - 1e-9));
  for (int order = std::max(1, lowest); order <= highest; ++order) {
    double sine = 0.0, cosine = 0.0, weight = 0.0;
    for (std::size_t i = 0; i < angle_rad.size(); ++i) {
      if (order * turns_Hz[i] > kSpectrumBand_Hz) continue;
      const double s = scale == nullptr ? 1.0 : (*scale)[i];
      sine += rows.residual[i] * s * std::sin(order * angle_rad[i]);
      cosine += rows.residual[i] * s * std::cos(order * angle_rad[i]);
      weight += s * s;
    }
    if (weight > 0.0) {
      share[static_cast<std::size_t>(order)] =
          2.0 * (sine * sine + cosine * cosine) / (weight * power);
    }
  }
  std::vector<std::pair<double, int>> found;
  for (int order = 1; order <= highest; ++order) {
    const auto o = static_cast<std::size_t>(order);
    if (share[o] > kLeastShare && share[o] >= share[o - 1] && share[o] >= share[o + 1]) {
      found.emplace_back(-share[o], order);
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<double> orders;
  for (std::size_t k = 0; k < std::min(kMostOrders, found.size()); ++k) {
    orders.push_back(found[k].second);
  }
  std::sort(orders.begin(), orders.end());
  return orders;
}

}  // namespace

Orders promising_orders(const Bench& bench, const std::vector<Signals>& signals,
                        const std::vector<std::size_t>& fold_of_run, const Extent& extent) {
  Orders orders;
  const LeftOver rows = left_over(bench, signals, fold_of_run);
  if (rows.residual.empty()) return orders;
  orders.motor = peaks(rows, rows.motor_rad, rows.motor_Hz, nullptr, extent.motor_angle_rad,
                       kHighestMotorOrder);
  const auto output = [&](const std::vector<double>* scale) {
    return peaks(rows, rows.output_rad, rows.output_Hz, scale, extent.output_angle_rad,
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
