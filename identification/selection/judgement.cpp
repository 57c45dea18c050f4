// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

constexpr double kExplainedFloors = 1.3;   ///< In rms, where no fit saw it.
constexpr double kSeveralFold = 2.0;       ///< Factor between a value as fitted and as stated.
constexpr double kLeastRemoved = 0.6;      ///< Of the squares, by sure names where much is left.
constexpr std::size_t kFewestOfASpot = 4;  ///< Waves of friction that are multiples of one.

/// A hard spot is no wave: it shows as many, all multiples of one.
bool is_one_spot(const EffectSet& members) {
  std::vector<double> orders;
  for (const EffectCandidate* each : members) {
    if (actuator::is_wave_of_friction(each->effect)) orders.push_back(each->order);
  }
  if (orders.size() < kFewestOfASpot) return false;
  const double lowest = *std::min_element(orders.begin(), orders.end());
  return std::all_of(orders.begin(), orders.end(), [&](double order) {
    return std::abs(order / lowest - std::round(order / lowest)) < 1e-6;
  });
}

double rms_over(const Rows& rows, const Eigen::VectorXd& values, bool held_out) {
  double square = 0.0, count = 0.0;
  for (const Rows::Block& block : rows.blocks()) {
    if (block.is_held_out() != held_out) continue;
    square += values.segment(block.begin, block.count).squaredNorm();
    count += static_cast<double>(block.count);
  }
  return count > 0.0 ? std::sqrt(square / count) : 0.0;
}

/// The member whose parameters, fitted apart in parts of the log, take most of what is left; none
/// if each holds everywhere.
std::optional<Wanderer> most_unsteady(const ModelFitter& fitter, const SearchRules& rules,
                                      const Found& found) {
  std::optional<Wanderer> worst;
  const double floor = noise_floor(fitter, found.best);
  const double left = rms_over(fitter.rows(), found.best.residual, false);
  for (std::size_t m = 0; m < found.best.members.size() && left > kExplainedFloors * floor; ++m) {
    Unsteadiness wanders = unsteadiness(fitter, found.best, m);
    const double own = found.gains[m].change_rms * found.gains[m].change_rms;
    const double most = worst ? worst->by.share : rules.steady_share;
    if (wanders.share <= most || wanders.squares <= rules.least_share * own) continue;
    worst = {found.best.members[m], std::move(wanders)};
  }
  return worst;
}

/// The member that the log can do without beside others; null if it needs each. A search ends at
/// such a member where one that it dropped helped to bring it in.
const EffectCandidate* least_needed(const Search& search, const Found& found) {
  const EffectCandidate* least = nullptr;
  double t = search.chance_t();
  for (std::size_t m = 0; m < found.gains.size() && found.gains.size() > 1; ++m) {
    if (found.gains[m].t > t) continue;
    t = found.gains[m].t;
    least = found.best.members[m];
  }
  return least;
}

}  // namespace

double noise_floor(const ModelFitter& fitter, const ModelFit& fit) {
  const ForwardEquation& equation = fitter.equation();
  Eigen::VectorXd coordinates = fit.coordinates;
  bool is_several_fold = false;
  for (std::size_t k = 0; k < equation.pointers.size(); ++k) {
    double& value = coordinates[static_cast<Eigen::Index>(k)];
    const double stated = equation.always_start[k], factor = value / stated;
    if (stated == 0.0 || (factor < kSeveralFold && factor > 1.0 / kSeveralFold)) continue;
    value = stated;
    is_several_fold = true;
  }
  const double own = rms_over(fitter.rows(), fit.noise, false);
  if (!is_several_fold) return own;
  return std::min(own, rms_over(fitter.rows(), fitter.noise(fit.members, coordinates), false));
}

bool leaves_noise(const Search& search, const ModelFitter& fitter, const ModelFit& fit,
                  const std::vector<ResidualStructure>& structure) {
  const double floor = noise_floor(fitter, fit);
  const double left = std::max(rms_over(fitter.rows(), fit.residual, false),
                               rms_over(fitter.rows(), fit.residual, true));
  if (left <= kExplainedFloors * floor) return true;
  // What is too small for any name is nothing to explain.
  if (std::hypot(floor, search.rules().least_change) >= left) return true;
  if (left > search.rules().unexplained_floors * floor) return false;
  return std::none_of(structure.begin(), structure.end(),
                      [](const ResidualStructure& each) { return is_significant(each); });
}

Judgement judge(const ModelFitter& fitter, Search& search, Found& found,
                const std::vector<ResidualStructure>& structure_before) {
  Judgement judged;
  judged.is_noise_before =
      found.best.members.empty() && leaves_noise(search, fitter, found.empty, structure_before);
  for (;;) {
    const EffectCandidate* left_out = least_needed(search, found);
    if (left_out == nullptr) {
      const auto wanderer = most_unsteady(fitter, search.rules(), found);
      if (!wanderer) break;
      judged.wanderers.push_back(*wanderer);
      left_out = wanderer->candidate;
    }
    search.leave_out(left_out, found);
    judged.has_tentative = true;
  }
  if (found.best.members.empty()) return judged;
  const double floor = noise_floor(fitter, found.best);
  const double left = rms_over(fitter.rows(), found.best.residual, false);
  const double share =
      1.0 - std::max(0.0, found.best.unseen_loss) / std::max(1e-300, found.empty.unseen_loss);
  const bool is_sure =
      share >= (judged.wanderers.empty() ? kLeastRemoved : 1.0 - search.rules().least_share);
  if (is_one_spot(found.best.members) ||
      (left > search.rules().unexplained_floors * floor && !is_sure)) {
    judged.has_tentative = true;
    found.best = found.empty;
    found.gains.clear();
    found.rivals.clear();
  }
  return judged;
}

}  // namespace torquewright::identification
