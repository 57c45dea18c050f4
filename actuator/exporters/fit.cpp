// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "actuator/exporters/downhill_simplex.hpp"
#include "actuator/region/bracketed_search.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kExactSpeed = 1e-12;  // of the greatest speed
// Of a square of braking where it competes with driving: it decides only what that leaves open.
constexpr double kBrakingWeight = 1e-3;
constexpr double kExact = 1e-9;       // of the peak torque: rounding, not a difference of shape
constexpr std::size_t kStride = 8;    // every which sample the squares are summed over
constexpr double kFirstShare = 1e-6;  // of the greatest speed: bounds may jump at rest itself

struct Sample {
  double speed_rad_s;
  double least_Nm;
  double greatest_Nm;
  bool holds_zero;  ///< Of torque: only there can a law stay inside.
};

std::vector<Sample> samples_of(const Subject& subject) {
  const double end_rad_s = subject.region.greatest_speed_rad_s();
  std::vector<double> speeds_rad_s;
  for (const double direction : {-1.0, 1.0}) {
    for (int i = 0; i <= kFitSpeeds; ++i) {
      const double share = i == 0 ? kFirstShare : static_cast<double>(i) / kFitSpeeds;
      speeds_rad_s.push_back(direction * share * end_rad_s);
    }
  }
  for (const MorRow& row : subject.table.rows) {
    if (row.speed_rad_s != 0.0) speeds_rad_s.push_back(row.speed_rad_s);
  }
  std::vector<Sample> samples;
  for (const double speed_rad_s : speeds_rad_s) {
    const JointRange range = subject.region.at(speed_rad_s);
    if (range.is_empty) continue;
    const double least_Nm = range.least.torque_Nm;
    const double greatest_Nm = range.greatest.torque_Nm;
    samples.push_back({speed_rad_s, least_Nm, greatest_Nm, least_Nm <= 0.0 && greatest_Nm >= 0.0});
  }
  return samples;
}

/// Up to which the region drives, the lesser of both directions'; where it drives in one only or
/// not at all, its greatest speed.
double driving_end_rad_s(const Subject& subject) {
  const double end_rad_s = subject.region.greatest_speed_rad_s();
  double least_rad_s = end_rad_s;
  for (const double direction : {1.0, -1.0}) {
    const auto driving_Nm = [&](double speed_rad_s) {
      const JointRange range = subject.region.at(direction * speed_rad_s, direction);
      if (range.is_empty) return -1.0;
      return direction > 0.0 ? range.greatest.torque_Nm : -range.least.torque_Nm;
    };
    if (driving_Nm(0.0) <= 0.0 || driving_Nm(end_rad_s) >= 0.0) continue;
    least_rad_s = std::min(least_rad_s,
                           last_nonnegative(driving_Nm, 0.0, end_rad_s, kExactSpeed * end_rad_s));
  }
  return least_rad_s;
}

/// How far a law lies outside a sample; without end where its numbers have no meaning.
double excess_Nm(const TorqueLimits& limits, const Sample& sample) {
  if (!sample.holds_zero) return 0.0;
  if (limits.greatest_Nm == -std::numeric_limits<double>::infinity()) return -limits.greatest_Nm;
  return std::max(
      {0.0, limits.greatest_Nm - sample.greatest_Nm, sample.least_Nm - limits.least_Nm});
}

class Judge {
 public:
  Judge(const Subject& subject, const Exporter& exporter)
      : exporter_(exporter),
        samples_(samples_of(subject)),
        peak_Nm_(subject.table.peak_torque_Nm),
        driving_end_rad_s_(exporter.derates_braking
                               ? driving_end_rad_s(subject) * (1.0 + 2.0 * kExactSpeed)
                               : kUnlimited) {}

  bool has_samples() const { return !samples_.empty(); }

  /// The shape with its no-load speed drawn in to where the region stops driving, and with it a
  /// knee that would lie beyond.
  Shape within_no_load(Shape shape) const {
    const auto no_load = place_of("no_load_speed_rad_s");
    if (!no_load || shape[*no_load] <= driving_end_rad_s_) return shape;
    const auto knee = place_of("knee_speed_rad_s");
    if (knee && shape[*knee] >= driving_end_rad_s_) {
      shape[*knee] *= driving_end_rad_s_ / shape[*no_load];
    }
    shape[*no_load] = driving_end_rad_s_;
    return shape;
  }

  /// Mean square difference of both bounds, in parts of the peak torque, plus `price` times that of
  /// what lies outside.
  double cost(const Shape& shape, double price) const {
    if (std::any_of(shape.begin(), shape.end(), [](double value) { return !(value > 0.0); })) {
      return std::numeric_limits<double>::infinity();
    }
    if (within_no_load(shape) != shape) return std::numeric_limits<double>::infinity();
    double sum = 0.0;
    for (std::size_t i = 0; i < samples_.size(); i += kStride) {
      const Sample& sample = samples_[i];
      const TorqueLimits limits = exporter_.law(shape, sample.speed_rad_s);
      const double outside = excess_Nm(limits, sample) / peak_Nm_;
      sum += difference(limits, sample) + price * outside * outside;
    }
    return sum * kStride / static_cast<double>(samples_.size());
  }

  bool is_inside(const Shape& shape) const {
    return std::all_of(samples_.begin(), samples_.end(), [&](const Sample& sample) {
      return excess_Nm(exporter_.law(shape, sample.speed_rad_s), sample) <= kExact * peak_Nm_;
    });
  }

  Shape scaled(Shape shape, double factor) const {
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (exporter_.parameters[i].scales == Scales::kWithRegion) shape[i] *= factor;
    }
    return shape;
  }

 private:
  std::optional<std::size_t> place_of(std::string_view parameter) const {
    for (std::size_t i = 0; i < exporter_.parameters.size(); ++i) {
      if (exporter_.parameters[i].name == parameter) return i;
    }
    return std::nullopt;
  }

  /// Sum of both bounds' squares.
  double difference(const TorqueLimits& limits, const Sample& sample) const {
    const double least = (limits.least_Nm - sample.least_Nm) / peak_Nm_;
    const double greatest = (limits.greatest_Nm - sample.greatest_Nm) / peak_Nm_;
    if (!exporter_.derates_braking) return least * least + greatest * greatest;
    // Past the no-load speed the region's bound has left zero, to which such a law can come only.
    const bool is_forward = sample.speed_rad_s > 0.0;
    const double driving = (is_forward ? limits.greatest_Nm - std::max(0.0, sample.greatest_Nm)
                                       : limits.least_Nm - std::min(0.0, sample.least_Nm)) /
                           peak_Nm_;
    const double braking = is_forward ? least : greatest;
    return driving * driving + kBrakingWeight * braking * braking;
  }

  const Exporter& exporter_;
  std::vector<Sample> samples_;
  double peak_Nm_;
  double driving_end_rad_s_;
};

Shape least_cost(const Judge& judge, Shape shape, double price) {
  constexpr double kStep = 0.1;
  constexpr double kFlatness = 1e-12;
  constexpr int kEvaluations = 2000;
  constexpr int kRestarts = 3;  // a simplex may collapse before it arrives
  const auto cost = [&](const Shape& at) { return judge.cost(at, price); };
  for (int i = 0; i < kRestarts; ++i) shape = downhill(cost, shape, kStep, kFlatness, kEvaluations);
  return shape;
}

/// The largest image of the shape, scaled about the origin, that lies inside. (Not every smaller
/// one does: past its own overspeed a law may leave the region again.)
Shape largest_inside(const Judge& judge, const Shape& shape) {
  if (judge.is_inside(shape)) return shape;
  constexpr int kSteps = 200;
  for (int step = kSteps - 1; step > 0; --step) {
    double inside = static_cast<double>(step) / kSteps;
    if (!judge.is_inside(judge.scaled(shape, inside))) continue;
    double outside = static_cast<double>(step + 1) / kSteps;
    while (outside - inside > 1e-12) {
      const double middle = 0.5 * (inside + outside);
      (judge.is_inside(judge.scaled(shape, middle)) ? inside : outside) = middle;
    }
    return judge.scaled(shape, inside);
  }
  return judge.scaled(shape, 1.0 / kSteps);  // the error report says what remains
}

}  // namespace

Shape fitted(const Subject& subject, const Exporter& exporter, const Shape& given) {
  const Judge judge(subject, exporter);
  const Shape start = judge.within_no_load(given);
  if (!judge.has_samples() || judge.cost(start, 0.0) < kExact * kExact) return start;
  if (subject.fit == LawFit::kBest) return least_cost(judge, start, 0.0);
  Shape shape = start;
  for (const double price : {1e2, 1e4, 1e6}) shape = least_cost(judge, shape, price);
  // The start, drawn in, may be the answer itself, which the search meets only nearly.
  const Shape near = largest_inside(judge, start);
  const Shape far = largest_inside(judge, shape);
  return judge.cost(near, 0.0) <= judge.cost(far, 0.0) ? near : far;
}

}  // namespace torquewright::actuator
