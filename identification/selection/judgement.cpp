// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/judgement.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

constexpr double kExplained = 1.3;     ///< Floors, in rms where no fit saw it.
constexpr double kUnexplained = 3.0;   ///< Floors: beyond it, with structure left, no name is sure ...
constexpr double kLeastShare = 0.6;    ///< ... that takes less of the squares.

double rms(const Rows& rows, const Eigen::VectorXd& values, bool held_out) {
  double square = 0.0, count = 0.0;
  for (const Rows::Block& block : rows.blocks()) {
    if (block.is_held_out() != held_out) continue;
    square += values.segment(block.begin, block.count).squaredNorm();
    count += static_cast<double>(block.count);
  }
  return count > 0.0 ? std::sqrt(square / count) : 0.0;
}

}  // namespace

bool Judgement::is_noise(const ModelFitter& fitter, const ModelFit& fit,
                         const std::vector<ResidualStructure>& structure) const {
  const double floor = rms(fitter.rows(), fit.noise, false);
  const double left = std::max(rms(fitter.rows(), fit.residual, false),
                               rms(fitter.rows(), fit.residual, true));
  if (left <= kExplained * floor) return true;
  if (left > kUnexplained * floor) return false;
  return std::none_of(structure.begin(), structure.end(),
                      [](const ResidualStructure& each) { return is_significant(each); });
}

Judgement judge(const ModelFitter& fitter, Found& found,
                const std::vector<ResidualStructure>& structure_before) {
  Judgement judged;
  judged.is_noise_before =
      found.best.members.empty() && judged.is_noise(fitter, found.empty, structure_before);
  if (found.best.members.empty()) return judged;
  const double floor = rms(fitter.rows(), found.best.noise, false);
  const double left = rms(fitter.rows(), found.best.residual, false);
  const double share = 1.0 - std::max(0.0, found.best.unseen_loss) / std::max(1e-300, found.empty.unseen_loss);
  if (left > kUnexplained * floor && share < kLeastShare) {
    judged.has_tentative = true;
    found.best = found.empty;
    found.gains.clear();
    found.rivals.clear();
  }
  return judged;
}

}  // namespace torquewright::identification
