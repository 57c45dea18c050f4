// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <memory>

#include "hopper/planning/constraints/cone.hpp"
#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/affine_rows.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// A parabola that keeps to a limit at both ends and in the middle passes it most near here.
constexpr std::array kShares{0.25, 0.75};
constexpr Index kOfSole = 2;  // forces upwards of a flat stance, rear and fore, after the one along

/// Of begin, middle and end, in the parabola through them.
std::array<double, 3> weights_at(double s) {
  return {1.0 - 3.0 * s + 2.0 * s * s, 4.0 * s - 4.0 * s * s, 2.0 * s * s - s};
}

/// An interval is asked at its middle.
bool is_asked(const Site& site) { return site.stance().is_flat() && site.index % 2 == 1; }

/// Forces upwards at begin, middle and end of the interval.
std::vector<int> numbers(const Site& site) {
  const std::vector<PointVariables>& points = site.variables().points;
  std::vector<std::vector<int>> parts;
  for (std::size_t i = site.index - 1; i <= site.index + 1; ++i) {
    parts.push_back(numbers_from(points[i].forces + 1, kOfSole));
  }
  return in_order({parts[0], parts[1], parts[2]});
}

/// At each of the shares, for each end of the sole: what it has to bear less what it bears, <= 0.
/// `tipping`: with the edge that a foot has which is about to tip, else with the margin itself.
MatrixXd rows(const Site& site, bool tipping) {
  const std::vector<double>& knots = site.mesh[site.phase].knots;
  const std::size_t interval = site.index / 2;
  MatrixXd out = MatrixXd::Zero(kOfSole * static_cast<Index>(kShares.size()), 3 * kOfSole);
  for (std::size_t i = 0; i < kShares.size(); ++i) {
    const double share = knots[interval] + kShares[i] * (knots[interval + 1] - knots[interval]);
    const double edge = tipping ? edge_at(site, share) : site.options.margins.center_of_pressure;
    const std::array<double, 3> weights = weights_at(kShares[i]);
    for (Index end = 0; end < kOfSole; ++end) {
      const Index row = kOfSole * static_cast<Index>(i) + end;
      for (std::size_t k = 0; k < weights.size(); ++k) {
        const Index column = kOfSole * static_cast<Index>(k);
        out.block(row, column, 1, kOfSole).setConstant(weights[k] * edge);
        out(row, column + end) -= weights[k];
      }
    }
  }
  return out;
}

void add(const Site& site, optimization::Program& program) {
  if (!is_asked(site)) return;
  MatrixXd slopes = rows(site, true);
  const auto count = static_cast<std::size_t>(slopes.rows());
  program.add_rows(std::make_unique<const AffineRows>(
      site.named(constraints::pressure_between_knots.name), numbers(site),
      std::vector<optimization::Bounds>(count, at_most(0.0)),
      std::vector<double>(count, typical::kForce_N), std::move(slopes)));
}

std::vector<PlanLimit> limits(const Site& site, const std::vector<double>& values) {
  if (!is_asked(site) || tips(site)) return {};
  const std::vector<int> variables = numbers(site);
  Eigen::VectorXd forces_N(static_cast<Index>(variables.size()));
  for (std::size_t i = 0; i < variables.size(); ++i) {
    forces_N[static_cast<Index>(i)] = values[static_cast<std::size_t>(variables[i])];
  }
  return {{"centre of pressure between knots", -(rows(site, false) * forces_N).maxCoeff(),
           site.model.weight_N}};
}

}  // namespace

const Constraint constraints::pressure_between_knots{
    "pressure between knots",
    "N",
    "the place of what the ground gives is within the sole a quarter of each interval from either "
    "end too",
    Where::kInstant,
    add,
    limits};

}  // namespace torquewright::hopper
