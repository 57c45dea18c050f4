// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/scatter.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

constexpr double kDeviationsOfMedian = 1.4826;
constexpr std::size_t kMostStates = 2000;  ///< That are looked at: each with each other.
/// Planes through as few states as leave some freedom follow a curve best.
constexpr std::size_t kMoreThanPlane = 4;
/// A coordinate along which the surface is curved counts so many times the distance of others, so
/// that neighbours differ in it as little as the states let them.
constexpr double kCurved = 10.0;

constexpr std::array kSpeeds = {Quantity::kOutputVelocity, Quantity::kLinearVelocity,
                                Quantity::kMotorVelocity};
constexpr std::array kDrives = {Quantity::kMotorCurrent, Quantity::kReportedTorque,
                                Quantity::kCommandedTorque, Quantity::kWindingVoltage,
                                Quantity::kDuty};
constexpr std::array kPositions = {Quantity::kOutputPosition, Quantity::kLinearPosition,
                                   Quantity::kMotorPosition};
constexpr std::array kTemperatures = {Quantity::kWindingTemperature, Quantity::kCaseTemperature};

bool changes(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(),
                     [&](double each) { return each != values.front(); });
}

/// The first that was logged, if it changes.
template <std::size_t N>
void take_first(const Channels& channels, const std::array<Quantity, N>& of,
                std::vector<Quantity>& coordinates) {
  const auto found =
      std::find_if(of.begin(), of.end(), [&](Quantity each) { return channels.has(each); });
  if (found != of.end() && changes(channels[*found])) coordinates.push_back(*found);
}

std::vector<Quantity> coordinates_of(const Channels& channels) {
  std::vector<Quantity> coordinates;
  take_first(channels, kSpeeds, coordinates);
  take_first(channels, kDrives, coordinates);
  take_first(channels, kPositions, coordinates);
  take_first(channels, kTemperatures, coordinates);
  return coordinates;
}

bool is_in(const std::vector<Quantity>& list, Quantity quantity) {
  return std::find(list.begin(), list.end(), quantity) != list.end();
}

std::vector<Quantity> dependent_on(const std::vector<Quantity>& coordinates,
                                   const Channels& channels) {
  std::vector<Quantity> dependent;
  for (std::size_t q = 0; q < kQuantityCount; ++q) {
    const auto quantity = static_cast<Quantity>(q);
    const bool is_motion = std::find(kSpeeds.begin(), kSpeeds.end(), quantity) != kSpeeds.end();
    const bool is_other = quantity == Quantity::kTime || quantity == Quantity::kRun || is_motion;
    if (is_other || is_command(quantity) || is_in(coordinates, quantity)) continue;
    if (channels.has(quantity)) dependent.push_back(quantity);
  }
  return dependent;
}

}  // namespace

Scatter::Scatter(const Log& log, std::size_t joint) {
  const Channels& like = log.runs.front().joints[joint];
  coordinates_ = coordinates_of(like);
  dependent_ = dependent_on(coordinates_, like);
  values_.resize(dependent_.size());
  const std::size_t step = 1 + log.runs.rows() / kMostStates;
  std::vector<double> widths(coordinates_.size(), 0.0);
  for (const Run& run : log.runs) {
    const Channels& channels = run.joints[joint];
    for (std::size_t row = 0; row < run.masked.size(); row += step) {
      if (run.masked[row] != 0) continue;
      State state;
      for (std::size_t c = 0; c < coordinates_.size(); ++c) {
        state.at.push_back(channels[coordinates_[c]][row]);
        widths[c] = std::max(widths[c], std::abs(state.at.back()));
      }
      states_.push_back(std::move(state));
      for (std::size_t d = 0; d < dependent_.size(); ++d) {
        values_[d].push_back(channels[dependent_[d]][row]);
      }
    }
  }
  for (State& state : states_) {
    for (std::size_t c = 0; c < widths.size(); ++c) {
      if (widths[c] > 0.0) state.at[c] /= widths[c];
    }
  }
}

double Scatter::distance_from_plane(std::size_t state, const std::vector<double>& values,
                                    std::size_t curved) const {
  const State& here = states_[state];
  const std::size_t dimensions = coordinates_.size(), count = dimensions + kMoreThanPlane;
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t other = 0; other < states_.size(); ++other) {
    if (other == state || (here.at[0] > 0.0) != (states_[other].at[0] > 0.0)) continue;
    double square = 0.0;
    for (std::size_t c = 0; c < dimensions; ++c) {
      const double apart = (states_[other].at[c] - here.at[c]) * (c == curved ? kCurved : 1.0);
      square += apart * apart;
    }
    near.emplace_back(square, other);
  }
  if (near.size() < count) return std::nan("");
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
  Eigen::MatrixXd plane(count, dimensions + 1);
  Eigen::VectorXd heights(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    plane(row, 0) = 1.0;
    for (std::size_t c = 0; c < dimensions; ++c) {
      plane(row, static_cast<Eigen::Index>(c + 1)) = states_[near[k].second].at[c] - here.at[c];
    }
    heights[row] = values[near[k].second];
  }
  // The plane's height here is its first coefficient: a sum of the neighbours by these weights.
  const Eigen::RowVectorXd weights = plane.completeOrthogonalDecomposition().pseudoInverse().row(0);
  return (values[state] - weights.dot(heights)) / std::sqrt(1.0 + weights.squaredNorm());
}

double Scatter::level(Quantity quantity) const {
  const auto found = std::find(dependent_.begin(), dependent_.end(), quantity);
  if (found == dependent_.end()) return 0.0;
  const std::vector<double>& values = values_[static_cast<std::size_t>(found - dependent_.begin())];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t curved = 0; curved < coordinates_.size(); ++curved) {
    std::vector<double> distances;
    for (std::size_t state = 0; state < states_.size(); ++state) {
      const double distance = distance_from_plane(state, values, curved);
      if (std::isfinite(distance)) distances.push_back(std::abs(distance));
    }
    if (distances.empty()) return 0.0;
    least = std::min(least, kDeviationsOfMedian * optimization::median(distances));
  }
  return std::isfinite(least) ? least : 0.0;
}

}  // namespace torquewright::identification
