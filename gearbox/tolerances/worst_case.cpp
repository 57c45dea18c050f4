// SPDX-License-Identifier: Apache-2.0
#include "gearbox/tolerances/worst_case.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "gearbox/teeth/scalar_functions.hpp"

namespace torquewright::gearbox {
namespace {

std::vector<double> middles(const ToleratedTrain& train) {
  std::vector<double> deviations;
  for (const PartLimit& limit : train.limits) deviations.push_back(limit.middle());
  return deviations;
}

double output_rad(const ToleratedTrain& train, Deviations deviations) {
  std::vector<double> backlash_mm;
  for (std::size_t mesh = 0; mesh < train.cut.meshes.size(); ++mesh) {
    backlash_mm.push_back(built_mesh(train, mesh, deviations).backlash_mm);
  }
  return train.backlash_rad(backlash_mm);
}

using Quantity = std::function<double(Deviations)>;

/// Of a quantity that is monotone in every dimension.
WorstCase at_corners(const ToleratedTrain& train, const Quantity& quantity) {
  const std::vector<double> middle = middles(train);
  std::vector<double> low = middle, high = middle;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    std::vector<double> one = middle;
    one[i] = train.limits[i].least;
    const double at_least = quantity(one);
    one[i] = train.limits[i].greatest;
    const bool grows = quantity(one) >= at_least;
    low[i] = grows ? train.limits[i].least : train.limits[i].greatest;
    high[i] = grows ? train.limits[i].greatest : train.limits[i].least;
  }
  return {quantity(low), quantity(high), true};
}

bool is_centre(const PartLimit& limit) { return limit.dimension == Dimension::kCentreDistance; }

/// Between which two the output's slope over the centre distance lies [rad/mm]: each mesh's own
/// falls or grows all along.
struct Slopes {
  double least = 0.0;
  double greatest = 0.0;
};

Slopes slopes_between(const ToleratedTrain& train, double from_mm, double to_mm) {
  Slopes slopes;
  for (std::size_t mesh = 0; mesh < train.cut.meshes.size(); ++mesh) {
    const double at_from = backlash_per_centre_distance(train, mesh, from_mm);
    const double at_to = backlash_per_centre_distance(train, mesh, to_mm);
    slopes.least += train.output_rad_per_mm[mesh] * std::min(at_from, at_to);
    slopes.greatest += train.output_rad_per_mm[mesh] * std::max(at_from, at_to);
  }
  return slopes;
}

/// The output's backlash over the centre distance from one to the other; `value_at` computes it.
WorstCase over_centre_distance(const ToleratedTrain& train,
                               const std::function<double(double)>& value_at, double from_mm,
                               double to_mm, int halvings) {
  const double first = value_at(from_mm), second = value_at(to_mm);
  WorstCase ends{std::min(first, second), std::max(first, second), true};
  const Slopes slopes = slopes_between(train, from_mm, to_mm);
  if (slopes.least >= 0.0 || slopes.greatest <= 0.0 || from_mm == to_mm) return ends;
  const double middle_mm = 0.5 * (from_mm + to_mm);
  if (halvings == 0) {
    const double steepest = std::max(-slopes.least, slopes.greatest);
    const double reach = 0.5 * steepest * (to_mm - from_mm);
    const double at_middle = value_at(middle_mm);
    return {std::min(ends.least, at_middle - reach), std::max(ends.greatest, at_middle + reach),
            false};
  }
  const WorstCase left = over_centre_distance(train, value_at, from_mm, middle_mm, halvings - 1);
  const WorstCase right = over_centre_distance(train, value_at, middle_mm, to_mm, halvings - 1);
  return {std::min(left.least, right.least), std::max(left.greatest, right.greatest), false};
}

/// Slope of the output's backlash over each dimension, parts at the middle of their limits: all
/// but the centre distance are straight lines.
std::vector<double> slopes_of(const ToleratedTrain& train) {
  const std::vector<double> middle = middles(train);
  std::vector<double> slopes;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const PartLimit& limit = train.limits[i];
    if (is_centre(limit)) {
      slopes.push_back(slopes_between(train, middle[i], middle[i]).least);
      continue;
    }
    std::vector<double> one = middle;
    one[i] = limit.greatest;
    const double at_greatest = output_rad(train, one);
    one[i] = limit.least;
    slopes.push_back(limit.width() > 0.0 ? (at_greatest - output_rad(train, one)) / limit.width()
                                         : 0.0);
  }
  return slopes;
}

/// Square of what each dimension adds over the whole of its limits.
std::vector<double> squares_of(const ToleratedTrain& train) {
  std::vector<double> squares = slopes_of(train);
  for (std::size_t i = 0; i < squares.size(); ++i) {
    squares[i] = square(squares[i] * train.limits[i].width());
  }
  return squares;
}

}  // namespace

MeshWorstCase worst_case_of_mesh(const ToleratedTrain& train, std::size_t mesh) {
  MeshWorstCase worst;
  const auto of = [&](double BuiltMesh::*member) {
    return at_corners(
        train, [&](Deviations deviations) { return built_mesh(train, mesh, deviations).*member; });
  };
  worst.backlash_mm = of(&BuiltMesh::backlash_mm);
  worst.contact_ratio = of(&BuiltMesh::contact_ratio);
  const WorstCase tip_1 = of(&BuiltMesh::tip_1_clearance_mm);
  const WorstCase tip_2 = of(&BuiltMesh::tip_2_clearance_mm);
  worst.tip_clearance_mm = {std::min(tip_1.least, tip_2.least),
                            std::min(tip_1.greatest, tip_2.greatest), true};
  return worst;
}

WorstCase worst_case_of_output_rad(const ToleratedTrain& train) {
  const std::vector<double> middle = middles(train);
  const double at_middle = output_rad(train, middle);
  WorstCase worst{at_middle, at_middle, true};
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const auto value_at = [&](double deviation) {
      std::vector<double> one = middle;
      one[i] = deviation;
      return output_rad(train, one);
    };
    const PartLimit& limit = train.limits[i];
    const double first = value_at(limit.least), second = value_at(limit.greatest);
    constexpr int kHalvings = 10;
    const WorstCase own =
        is_centre(limit)
            ? over_centre_distance(train, value_at, limit.least, limit.greatest, kHalvings)
            : WorstCase{std::min(first, second), std::max(first, second), true};
    worst.least += own.least - at_middle;
    worst.greatest += own.greatest - at_middle;
    worst.is_attained = worst.is_attained && own.is_attained;
  }
  return worst;
}

std::vector<double> variance_shares(const ToleratedTrain& train) {
  std::vector<double> shares = squares_of(train);
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share = sum > 0.0 ? share / sum : 0.0;
  return shares;
}

double linear_deviation_rad(const ToleratedTrain& train, double variance_per_width_squared) {
  const std::vector<double> squares = squares_of(train);
  return std::sqrt(variance_per_width_squared *
                   std::accumulate(squares.begin(), squares.end(), 0.0));
}

}  // namespace torquewright::gearbox
