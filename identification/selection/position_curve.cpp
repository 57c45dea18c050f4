// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/position_curve.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

constexpr double kMost = 0.5;  ///< Of the squares that the laws leave.

bool is_law_of_position(const std::string& effect) {
  const actuator::EffectKind* kind = actuator::find_effect(effect);
  return effect == "gravity_imbalance" ||
         (kind != nullptr && kind->acts == actuator::Acts::kOutputTorque);
}

/// (n x p) Chebyshev polynomials of the position over its range, from the constant on.
Eigen::MatrixXd polynomials(const Rows& rows, Eigen::Index count) {
  const auto angle = [](const Signals& signals) {
    std::vector<double> values;
    for (const actuator::Instant& at : signals.at) values.push_back(at.output_angle_rad);
    return values;
  };
  const Eigen::VectorXd position = rows.values(angle);
  const double low = position.minCoeff(), high = position.maxCoeff();
  const Eigen::ArrayXd x = (2.0 * position.array() - low - high) / std::max(high - low, 1e-12);
  Eigen::MatrixXd columns(position.size(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    columns.col(k) = (static_cast<double>(k) * x.max(-1.0).min(1.0).acos()).cos();
  }
  return columns;
}

/// What the least squares of the rows that fits see leave everywhere.
Eigen::VectorXd left_by(const Rows& rows, const Eigen::MatrixXd& columns,
                        const Eigen::VectorXd& values) {
  Eigen::MatrixXd seen = columns;
  Eigen::VectorXd target = values;
  for (const Rows::Block& block : rows.blocks()) {
    if (!block.is_held_out()) continue;
    seen.middleRows(block.begin, block.count).setZero();
    target.segment(block.begin, block.count).setZero();
  }
  return values - columns * seen.colPivHouseholderQr().solve(target);
}

double rms(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() /
                   static_cast<double>(std::max<Eigen::Index>(1, values.size())));
}

}  // namespace

void doubt_laws_of_position(const ModelFitter& fitter, const ModelFit& fit,
                            EquationResult& result) {
  const PartOfModel bare = part_of(
      fit, [](const EffectCandidate& member) { return !is_law_of_position(member.effect); });
  const Eigen::Index numbers = fit.coordinates.size() - bare.coordinates.size();
  const double floor = rms(fit.noise), laws = rms(fit.residual);
  if (numbers == 0) return;
  const Eigen::VectorXd rest = fitter.residual(bare.members, bare.coordinates);
  const double curve = rms(left_by(fitter.rows(), polynomials(fitter.rows(), numbers), rest));
  if (curve * curve - floor * floor >= kMost * (laws * laws - floor * floor)) return;
  for (NamedEffect& each : result.added) {
    if (!is_law_of_position(each.effect) || !each.doubt.empty()) continue;
    each.doubt = fmt::format(
        "a smooth curve of the position with as many numbers, {}, leaves {:.4g} {} where this "
        "leaves {:.4g}: the torque is another function of the position",
        numbers, curve, result.unit, laws);
  }
}

}  // namespace torquewright::identification
