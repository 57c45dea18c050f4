// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/rate_agreement.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "hopper/motion/rounding_steps.hpp"
#include "hopper/motion/slopes.hpp"
#include "io/text/time_text.hpp"
#include "io/text/wording.hpp"
#include "optimization/fit/quantile.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kStretch = 10;        // samples: noise of a position divides by as many steps
constexpr double kDiffers = 0.25;     // of the larger rate
constexpr double kHardlyMoves = 0.1;  // of the coordinate's rms: there a stretch says nothing
constexpr double kTooMany = 0.25;     // of the stretches in which it moves
constexpr Index kFewest = 3;          // stretches that disagree
constexpr double kNoise = 4.0;        // standard deviations of a stretch's slope
constexpr double kStands = 0.02;      // of the fastest of its kind, in rms: noise
constexpr double kKnownFactor = 0.05;
constexpr double kClearFactor = 0.8;  // squared correlation that a factor explains

/// Mean rates over stretches, (coordinates x stretches).
struct Rates {
  MatrixXd given;
  MatrixXd slope;
  MatrixXd turned;    ///< Given, a spatial base's rotation read in the world's axes.
  VectorXd noise;     ///< Standard deviation of the slopes, by coordinate.
  VectorXd rounding;  ///< By how much steps may change the slopes at most.
  std::vector<double> from_s;
  std::vector<double> until_s;
};

/// Change from a sample to the next of what the rates are the rates of.
VectorXd change_after(const dynamics::Tree& tree, const Motion& motion, bool of_velocity,
                      Index sample) {
  if (of_velocity) return motion.velocities.col(sample + 1) - motion.velocities.col(sample);
  return displacement(tree, motion.positions.col(sample), motion.positions.col(sample + 1));
}

/// By coordinate: of a sample, from the median of second differences, which few impacts do not
/// move.
VectorXd noise_of(const dynamics::Tree& tree, const Motion& motion, bool of_velocity) {
  constexpr double kMedianOfNormal = 0.6745;
  std::vector<std::vector<double>> seconds(static_cast<std::size_t>(motion.velocities.rows()));
  VectorXd noise = VectorXd::Zero(motion.velocities.rows());
  for (Index i = 1; i + 1 < motion.samples(); ++i) {
    const double before_s = motion.step_s(i - 1);
    const double after_s = motion.step_s(i);
    if (before_s == 0.0 || after_s == 0.0) continue;
    const VectorXd second = change_after(tree, motion, of_velocity, i) * (before_s / after_s) -
                            change_after(tree, motion, of_velocity, i - 1);
    for (Index row = 0; row < noise.size(); ++row) {
      seconds[static_cast<std::size_t>(row)].push_back(std::abs(second[row]));
    }
  }
  for (Index row = 0; row < noise.size(); ++row) {
    std::vector<double>& sizes = seconds[static_cast<std::size_t>(row)];
    if (sizes.empty()) continue;
    noise[row] = optimization::median(std::move(sizes)) / (kMedianOfNormal * std::sqrt(6.0));
  }
  return noise;
}

VectorXd in_base_axes(const dynamics::Tree& tree, const VectorXd& position, VectorXd rate) {
  if (tree.base != dynamics::BaseKind::kSpatial) return rate;
  const Eigen::Quaterniond R_WB(position[3], position[4], position[5], position[6]);
  rate.segment<3>(3) = R_WB.normalized().conjugate() * Eigen::Vector3d(rate.segment<3>(3));
  return rate;
}

Rates rates_of(const dynamics::Tree& tree, const Motion& motion, bool of_velocity) {
  const MatrixXd& given = of_velocity ? motion.accelerations : motion.velocities;
  const Index most = motion.samples() / kStretch + 1;
  Rates rates;
  for (MatrixXd* table : {&rates.given, &rates.slope, &rates.turned}) {
    table->resize(given.rows(), most);
  }
  Index count = 0;
  for (Index first = 0; first + 1 < motion.samples(); first += kStretch) {
    const Index last = std::min(first + kStretch, motion.samples() - 1);
    VectorXd sum = VectorXd::Zero(given.rows()), change = sum, turned = sum;
    double duration_s = 0.0;
    for (Index i = first; i < last; ++i) {
      if (motion.is_break(i + 1)) continue;
      const double step_s = motion.step_s(i);
      const VectorXd mean = 0.5 * (given.col(i) + given.col(i + 1));
      sum += step_s * mean;
      turned += step_s * in_base_axes(tree, motion.positions.col(i), mean);
      change += change_after(tree, motion, of_velocity, i);
      duration_s += step_s;
    }
    if (duration_s == 0.0) continue;
    rates.given.col(count) = sum / duration_s;
    rates.slope.col(count) = change / duration_s;
    rates.turned.col(count) = turned / duration_s;
    rates.from_s.push_back(motion.time_s(first));
    rates.until_s.push_back(motion.time_s(last));
    ++count;
  }
  for (MatrixXd* table : {&rates.given, &rates.slope, &rates.turned}) {
    table->conservativeResize(Eigen::NoChange, count);
  }
  const double stretch_s =
      motion.duration_s() * static_cast<double>(kStretch) / static_cast<double>(motion.samples());
  rates.noise = std::sqrt(2.0) / std::max(stretch_s, 1e-300) * noise_of(tree, motion, of_velocity);
  const VectorXd steps = of_velocity ? velocity_steps(motion) : position_steps(tree, motion);
  rates.rounding = steps / std::max(stretch_s, 1e-300);
  return rates;
}

/// Names of the velocities' rows, and which of them turn.
struct Coordinates {
  std::vector<std::string> names;
  std::vector<bool> turns;
};

Coordinates coordinates_of(const dynamics::Tree& tree) {
  Coordinates found;
  const auto add = [&](const std::string& name, bool turns) {
    found.names.push_back(name);
    found.turns.push_back(turns);
  };
  if (tree.base == dynamics::BaseKind::kPlanar) {
    add("base_x", false);
    add("base_z", false);
    add("base_pitch", true);
  } else if (tree.base == dynamics::BaseKind::kSpatial) {
    for (const char* axis : {"x", "y", "z"}) add(fmt::format("base_{}", axis), false);
    for (const char* axis : {"x", "y", "z"}) add(fmt::format("base_angular_{}", axis), true);
  }
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
    const dynamics::Joint& joint = tree.bodies[i].joint;
    add(joint.name, joint.kind == dynamics::JointKind::kRevolute);
  }
  return found;
}

double rms(const MatrixXd& table, Index row) {
  return table.row(row).norm() / std::sqrt(static_cast<double>(table.cols()));
}

std::string cause_of(const RateMismatch& mismatch, bool turns) {
  if (mismatch.correlation < kClearFactor) return "";
  struct Known {
    double factor;
    const char* words;
    bool only_turning;
  };
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  constexpr std::array kFactors{
      Known{1e3, "time_s seems to be in milliseconds", false},
      Known{1e6, "time_s seems to be in microseconds", false},
      Known{1e9, "time_s seems to be in nanoseconds", false},
      Known{1e-3, "it seems to be per millisecond", false},
      Known{-1.0, "its sign seems to be the other way round", false},
      Known{kDegrees, "it seems to be in degrees", true},
      Known{1.0 / kDegrees, "what it is the rate of seems to be in degrees", true},
      Known{30.0 / std::numbers::pi, "it seems to be in revolutions per minute", true},
  };
  for (const Known& known : kFactors) {
    if (known.only_turning && !turns) continue;
    if (std::abs(mismatch.factor / known.factor - 1.0) < kKnownFactor) return known.words;
  }
  return fmt::format("it seems to be scaled by {:.4g}", mismatch.factor);
}

class Comparison {
 public:
  Comparison(const Robot& robot, const Motion& motion, bool of_velocity)
      : coordinates_(coordinates_of(robot.tree)),
        rates_(rates_of(robot.tree, motion, of_velocity)),
        of_velocity_(of_velocity),
        is_spatial_(robot.tree.base == dynamics::BaseKind::kSpatial) {}

  void add_to(std::vector<RateMismatch>& found) const {
    if (rates_.given.cols() == 0) return;
    for (Index row = 0; row < rates_.given.rows(); ++row) {
      if (!moves(row)) continue;
      RateMismatch mismatch = compare(rates_.given, row);
      if (mismatch.share <= kTooMany) continue;
      const auto index = static_cast<std::size_t>(row);
      mismatch.likely_cause = cause_of(mismatch, coordinates_.turns[index]);
      if (is_spatial_ && row >= 3 && row < 6 && !of_velocity_ &&
          compare(rates_.turned, row).share <= kTooMany) {
        mismatch.likely_cause = "it seems to be in the world's axes; the base's are asked for";
      }
      if (mismatch.likely_cause.empty()) {
        mismatch.likely_cause = "another column's, another joint's, or late";
      }
      found.push_back(std::move(mismatch));
    }
  }

 private:
  bool turns(Index row) const { return coordinates_.turns[static_cast<std::size_t>(row)]; }

  /// Either table says that it does, beside others of its kind.
  bool moves(Index row) const {
    double fastest_given = 0.0, fastest_slope = 0.0;
    for (Index other = 0; other < rates_.given.rows(); ++other) {
      if (turns(other) != turns(row)) continue;
      fastest_given = std::max(fastest_given, rms(rates_.given, other));
      fastest_slope = std::max(fastest_slope, rms(rates_.slope, other));
    }
    return rms(rates_.given, row) > kStands * fastest_given ||
           rms(rates_.slope, row) > kStands * fastest_slope;
  }

  RateMismatch compare(const MatrixXd& given, Index row) const {
    RateMismatch mismatch;
    mismatch.coordinate = coordinates_.names[static_cast<std::size_t>(row)];
    mismatch.is_acceleration = of_velocity_;
    mismatch.given_rms = rms(given, row);
    mismatch.slope_rms = rms(rates_.slope, row);
    mismatch.difference_rms = rms(given - rates_.slope, row);
    const double product = given.row(row).dot(rates_.slope.row(row));
    const double square = rates_.slope.row(row).squaredNorm();
    const double other = given.row(row).squaredNorm();
    if (square > 0.0) mismatch.factor = product / square;
    if (square * other > 0.0) mismatch.correlation = product * product / (square * other);
    count_stretches(given, row, mismatch);
    return mismatch;
  }

  void count_stretches(const MatrixXd& given, Index row, RateMismatch& mismatch) const {
    const double small = kHardlyMoves * std::max(mismatch.given_rms, mismatch.slope_rms) +
                         kNoise * rates_.noise[row] + rates_.rounding[row];
    Index moving = 0;
    Index differing = 0;
    for (Index i = 0; i < given.cols(); ++i) {
      const double larger = std::max(std::abs(given(row, i)), std::abs(rates_.slope(row, i)));
      if (larger <= small) continue;
      ++moving;
      const double allowed = kDiffers * larger + small;
      if (std::abs(given(row, i) - rates_.slope(row, i)) <= allowed) continue;
      const auto stretch = static_cast<std::size_t>(i);
      if (differing++ == 0) mismatch.from_s = rates_.from_s[stretch];
      mismatch.until_s = rates_.until_s[stretch];
    }
    // Few stretches are all that a short motion has.
    if (differing < std::min(kFewest, given.cols())) return;
    mismatch.share = static_cast<double>(differing) / static_cast<double>(moving);
  }

  Coordinates coordinates_;
  Rates rates_;
  bool of_velocity_;
  bool is_spatial_;
};

io::Fault fault_of(const std::string& file, const std::vector<RateMismatch>& alike) {
  const RateMismatch& worst = *std::max_element(
      alike.begin(), alike.end(),
      [](const RateMismatch& one, const RateMismatch& other) { return one.share < other.share; });
  std::vector<std::string> names;
  for (const RateMismatch& one : alike) names.push_back(one.coordinate);
  const char* given = worst.is_acceleration ? "acceleration" : "velocity";
  const char* from = worst.is_acceleration ? "velocity" : "position";
  return {file, "",
          fmt::format("t = {} to {} s: the {} of {} is not the rate of its {}: {} differs by "
                      "{:.4g} rms of {:.4g} (SI units), in {:.3g} % of the motion by more than a "
                      "quarter; likely cause: {}",
                      io::time_text(worst.from_s), io::time_text(worst.until_s), given,
                      io::listed(names), from, worst.coordinate, worst.difference_rms,
                      std::max(worst.given_rms, worst.slope_rms), 100.0 * worst.share,
                      worst.likely_cause)};
}

}  // namespace

std::vector<RateMismatch> rate_mismatches(const Robot& robot, const Motion& motion) {
  std::vector<RateMismatch> found;
  const bool has_velocity = motion.velocity_origin == Origin::kGiven;
  if (has_velocity) Comparison(robot, motion, false).add_to(found);
  if (!has_velocity || motion.acceleration_origin != Origin::kGiven) return found;
  std::vector<RateMismatch> of_velocities;
  Comparison(robot, motion, true).add_to(of_velocities);
  for (RateMismatch& mismatch : of_velocities) {
    // Of a wrong velocity an acceleration cannot be the rate: that says nothing new.
    const bool is_known = std::any_of(found.begin(), found.end(), [&](const RateMismatch& one) {
      return one.coordinate == mismatch.coordinate;
    });
    if (!is_known) found.push_back(std::move(mismatch));
  }
  return found;
}

void require_rates_agree(const Robot& robot, const Motion& motion) {
  std::vector<RateMismatch> left = rate_mismatches(robot, motion);
  std::vector<io::Fault> faults;
  while (!left.empty()) {
    // Those of one cause in one sentence.
    const auto others = std::stable_partition(
        left.begin(), left.end(), [first = left.front()](const RateMismatch& one) {
          return one.is_acceleration == first.is_acceleration &&
                 one.likely_cause == first.likely_cause;
        });
    faults.push_back(fault_of(motion.file, {left.begin(), others}));
    left.erase(left.begin(), others);
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
}

}  // namespace torquewright::hopper
