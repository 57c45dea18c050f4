// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/steadiness.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace torquewright::identification {
namespace {

constexpr std::size_t kQuarters = 4;
/// Neighbouring rows of a band that is sampled at four times its cut-off say half of it twice.
constexpr double kRowsPerIndependent = 2.0;

constexpr std::string_view kDriveCoordinate = "motor_current_A";

using PartValue = double (*)(const Signals&, std::size_t);

struct PartCoordinate {
  std::string_view name;
  PartValue value;
};

constexpr PartCoordinate kPartCoordinates[] = {
    {"output_position_rad",
     [](const Signals& s, std::size_t i) { return s.at[i].output_angle_rad; }},
    {"output_velocity_rad_s", [](const Signals& s, std::size_t i) { return s.at[i].speed_rad_s; }},
    {"load_torque_Nm", [](const Signals& s, std::size_t i) { return s.at[i].load_torque_Nm; }},
    {"motor_current_A", [](const Signals& s, std::size_t i) { return s.at[i].current_A; }},
    {"time_s", [](const Signals& s, std::size_t i) { return s.time_s[i] - s.time_s.front(); }},
    {"winding_temperature_K",
     [](const Signals& s, std::size_t i) { return s.at[i].winding_temperature_K; }},
    {"run", [](const Signals& s, std::size_t) { return static_cast<double>(s.run); }},
};

/// Of all rows, in their order.
std::vector<double> coordinate_values(const Rows& rows, PartValue value) {
  std::vector<double> values;
  for (std::size_t s = 0; s < rows.signals().size(); ++s) {
    for (const std::size_t i : rows.samples()[s]) values.push_back(value(rows.signals()[s], i));
  }
  return values;
}

/// Which part each training row belongs to, by quarters; the number of parts where it is held out.
std::vector<std::size_t> parts_of(const Rows& rows, const std::vector<double>& values) {
  std::vector<double> sorted;
  std::vector<std::size_t> part(values.size(), kQuarters);
  for (const Rows::Block& block : rows.blocks()) {
    for (Eigen::Index k = 0; k < block.count && !block.is_held_out(); ++k) {
      sorted.push_back(values[static_cast<std::size_t>(block.begin + k)]);
    }
  }
  std::sort(sorted.begin(), sorted.end());
  for (const Rows::Block& block : rows.blocks()) {
    for (Eigen::Index k = 0; k < block.count && !block.is_held_out(); ++k) {
      const auto row = static_cast<std::size_t>(block.begin + k);
      const auto below =
          std::upper_bound(sorted.begin(), sorted.end(), values[row]) - sorted.begin();
      part[row] =
          std::min(kQuarters - 1, static_cast<std::size_t>(below) * kQuarters / sorted.size());
    }
  }
  return part;
}

/// Squares that go if each part has parameters of its own.
double gain_of_parts(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& residual,
                     const std::vector<std::size_t>& part) {
  const Eigen::Index q = slopes.cols();
  std::vector<Eigen::MatrixXd> power(kQuarters, Eigen::MatrixXd::Zero(q, q));
  std::vector<Eigen::VectorXd> descent(kQuarters, Eigen::VectorXd::Zero(q));
  for (std::size_t row = 0; row < part.size(); ++row) {
    if (part[row] == kQuarters) continue;
    const auto i = static_cast<Eigen::Index>(row);
    power[part[row]] += slopes.row(i).transpose() * slopes.row(i);
    descent[part[row]] += slopes.row(i).transpose() * residual[i];
  }
  double gain = 0.0;
  for (std::size_t p = 0; p < kQuarters; ++p) {
    const double trace = power[p].trace();
    if (!(trace > 0.0)) continue;
    power[p].diagonal().array() += 1e-9 * trace;
    gain += descent[p].dot(power[p].ldlt().solve(descent[p]));
  }
  return gain;
}

}  // namespace

Unsteadiness unsteadiness(const ModelFitter& fitter, const ModelFit& fit, std::size_t member) {
  const Rows& rows = fitter.rows();
  const Eigen::MatrixXd all =
      fitter.slopes(fit.members, fit.coordinates, fit.residual, rows.signals());
  const auto count = static_cast<Eigen::Index>(fit.members[member]->parameters.size());
  const Eigen::MatrixXd slopes = all.middleCols(fit.first_of(member), count);
  double left = 0.0, samples = 0.0;
  for (const Rows::Block& block : rows.blocks()) {
    if (block.is_held_out()) continue;
    left += fit.residual.segment(block.begin, block.count).squaredNorm();
    samples += static_cast<double>(block.count);
  }
  Unsteadiness worst;
  for (const PartCoordinate& coordinate : kPartCoordinates) {
    if (fitter.equation().target_is_drive && coordinate.name == kDriveCoordinate) continue;
    const std::vector<double> values = coordinate_values(rows, coordinate.value);
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    if (values.empty() || !(*greatest > *least)) continue;
    const double gain = gain_of_parts(slopes, fit.residual, parts_of(rows, values));
    const double by_chance = kRowsPerIndependent *
                             static_cast<double>(kQuarters * static_cast<std::size_t>(count)) *
                             left / samples;
    const double share = (gain - by_chance) / left;
    if (share > worst.share) worst = {std::string(coordinate.name), share, share * left / samples};
  }
  return worst;
}

}  // namespace torquewright::identification
