// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/landing_load.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "hopper/flip/affine_rows.hpp"
#include "hopper/flip/gear_laws.hpp"
#include "hopper/flip/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using optimization::Bounds;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kMost = 100.0;   // of limits; no plan is near it
constexpr double kTypical = 0.5;  // of a limit

/// Weights of a phase's first instants in the mean over a window from its begin: each interval's
/// parabola, integrated.
std::vector<double> mean_weights(const std::vector<double>& knots, double duration_s,
                                 double window_s) {
  std::vector<double> weights(1, 0.0);
  for (std::size_t i = 0; i + 1 < knots.size() && knots[i] * duration_s < window_s; ++i) {
    const double length_s = (knots[i + 1] - knots[i]) * duration_s;
    const double s = std::min(1.0, (window_s - knots[i] * duration_s) / length_s);
    const double of_window = length_s / window_s;
    weights.back() += of_window * (s - 1.5 * s * s + 2.0 / 3.0 * s * s * s);
    weights.push_back(of_window * (2.0 * s * s - 4.0 / 3.0 * s * s * s));
    weights.push_back(of_window * (-0.5 * s * s + 2.0 / 3.0 * s * s * s));
  }
  return weights;
}

/// Variables: by drive, its gears' load at an instant less the variable that stands for it.
struct LoadIsLaw {
  GearLaw law;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const auto d = static_cast<Index>(law.limits_Nm.size());
    law(dynamics::VectorX<T>(x.head(x.size() - d)), rows);
    rows -= x.tail(d);
  }
};

/// +-(mean of loads) + impulse's size. Columns: loads by instant, the impulse's.
Eigen::MatrixXd mean_rows(const std::vector<double>& weights) {
  const auto count = static_cast<Index>(weights.size());
  Eigen::MatrixXd rows = Eigen::MatrixXd::Ones(2, count + 1);
  rows.row(0).head(count) = Eigen::Map<const Eigen::RowVectorXd>(weights.data(), count);
  rows.row(1).head(count) = -rows.row(0).head(count);
  return rows;
}

int add_shares(const char* name, std::size_t drives, double least, FlipProgram& program) {
  return program.program.add({name, std::vector<double>(drives, 0.1),
                              std::vector<Bounds>(drives, {least, kMost}),
                              std::vector<double>(drives, kTypical)});
}

}  // namespace

void add_landing_load(const PlanModel& model, double window_s, std::size_t phase,
                      FlipProgram& program) {
  // Loads are shares of the limits; a drive without one is measured by its greatest torque.
  std::vector<double> limits_Nm = model.gear_Nm;
  for (std::size_t i = 0; i < limits_Nm.size(); ++i) {
    if (!std::isfinite(limits_Nm[i])) limits_Nm[i] = (*model.regions)[i].greatest_torque_Nm();
  }
  const std::size_t drives = limits_Nm.size();
  const auto d = static_cast<Index>(drives);
  const auto k = static_cast<Index>(model.plane.joints.size());
  const PhaseVariables& variables = program.phases[phase];
  const double duration_s = program.program.starts()[static_cast<std::size_t>(variables.duration)];
  const std::vector<double> weights = mean_weights(program.mesh[phase].knots, duration_s, window_s);
  const int impulse = add_shares("impulse loads", drives, 0.0, program);
  program.program.add_rows(jet_rows(
      program.mesh[phase].stance.name + ": rotors at the impact",
      in_order({impulse_numbers(variables, k), numbers_from(impulse, d)}),
      std::vector<Bounds>(2 * drives, {-kInfinite, 0.0}), std::vector<double>(2 * drives, 1.0),
      MagnitudeLaw<ImpulseLaw>{{&model, limits_Nm, window_s}, d, false}));
  std::vector<int> loads;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    loads.push_back(add_shares("gear loads", drives, -kMost, program));
    program.program.add_rows(
        jet_rows(program.mesh[phase].stance.name + ": gears after the impact",
                 in_order({gear_numbers(variables.points[i], k, d), numbers_from(loads.back(), d)}),
                 std::vector<Bounds>(drives, {0.0, 0.0}), std::vector<double>(drives, 1.0),
                 LoadIsLaw{{&model, limits_Nm}}));
  }
  for (std::size_t drive = 0; drive < drives; ++drive) {
    if (!std::isfinite(model.gear_Nm[drive])) continue;
    std::vector<int> numbers;
    for (const int first : loads) numbers.push_back(first + static_cast<int>(drive));
    numbers.push_back(impulse + static_cast<int>(drive));
    program.program.add_rows(std::make_unique<const AffineRows>(
        program.mesh[phase].stance.name + ": mean gear load at the impact", std::move(numbers),
        std::vector<Bounds>(2, {-kInfinite, 1.0}), std::vector<double>(2, 1.0),
        mean_rows(weights)));
  }
}

}  // namespace torquewright::hopper
