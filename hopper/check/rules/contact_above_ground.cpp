// SPDX-License-Identifier: Apache-2.0
// Points that a file says touch, high above the ground. What they carry is no force of flat ground:
// it is held against the limit of what may be left unexplained.
// docs/derivations/whole_body_check.md, "Above the ground".
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hopper/check/rules/every_rule.hpp"
#include "hopper/demand/running_integral.hpp"
#include "io/text/time_text.hpp"
#include "optimization/fit/quantile.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kCarries = 1e-3;  // of the weight: a point that carries less carries nothing

/// What points carry that lie too high above ground at some height.
struct HighLoad {
  double mean_N = 0.0;     ///< The greatest over a window, of all such points together.
  Index point = 0;         ///< The highest of those that carry something,
  Index sample = 0;        ///< where it is.
  double height_m = 0.0;   ///< Above the ground that the check knows.
  double speed_m_s = 0.0;  ///< The fastest of them up or down, over a window.
};

class TouchingHeights {
 public:
  TouchingHeights(const CheckedMotion& checked, double limit_m)
      : checked_(checked),
        heights_m_(checked.contacts.height_m),
        limit_m_(limit_m),
        sizes_N_(heights_m_.rows(), heights_m_.cols()) {
    const MatrixXd& forces_N =
        checked.motion.has_forces ? checked.motion.forces_N : checked.demand.forces_N;
    for (Index i = 0; i < sizes_N_.rows(); ++i) {
      sizes_N_.row(i) = forces_N.middleRows(3 * i, 3).colwise().norm();
    }
  }

  /// Of all points that carry something, at all samples. Requires that there are some.
  double median_m() const {
    std::vector<double> heights_m;
    for (Index sample = 0; sample < heights_m_.cols(); ++sample) {
      for (Index i = 0; i < heights_m_.rows(); ++i) {
        if (carries(i, sample)) heights_m.push_back(heights_m_(i, sample));
      }
    }
    return heights_m.empty() ? 0.0 : optimization::median(std::move(heights_m));
  }

  HighLoad above(double ground_m) const {
    HighLoad load;
    MatrixXd carried_N = MatrixXd::Zero(1, heights_m_.cols());
    for (Index sample = 0; sample < heights_m_.cols(); ++sample) {
      for (Index i = 0; i < heights_m_.rows(); ++i) {
        if (!is_high(i, sample, ground_m)) continue;
        carried_N(0, sample) += sizes_N_(i, sample);
        load.speed_m_s = std::max(load.speed_m_s, speed_m_s(i, sample, ground_m));
        if (carries(i, sample) && heights_m_(i, sample) > load.height_m) {
          load.height_m = heights_m_(i, sample);
          load.point = i;
          load.sample = sample;
        }
      }
    }
    load.mean_N = greatest_mean_N(carried_N, ground_m);
    return load;
  }

 private:
  bool carries(Index point, Index sample) const {
    return checked_.contacts.touches(point, sample) &&
           sizes_N_(point, sample) > kCarries * checked_.demand.weight_N;
  }

  /// At its row and at those beside it that the row's force may be of.
  bool is_high(Index point, Index sample, double ground_m) const {
    if (!checked_.contacts.touches(point, sample)) return false;
    const Index reach = checked_.motion.reach + 1;
    const Index first = std::max<Index>(0, sample - reach);
    const Index count = std::min(heights_m_.cols(), sample + reach + 1) - first;
    return heights_m_.row(point).segment(first, count).minCoeff() > ground_m + limit_m_;
  }

  /// Mean over a window that the point is high at both ends of and carries something.
  double speed_m_s(Index point, Index sample, double ground_m) const {
    const Motion& motion = checked_.motion;
    if (!carries(point, sample)) return 0.0;
    Index last = sample;
    while (last + 1 < motion.samples() &&
           motion.time_s(last) - motion.time_s(sample) < checked_.options.residual_window_s) {
      ++last;
    }
    const double duration_s = motion.time_s(last) - motion.time_s(sample);
    const bool is_whole = duration_s >= checked_.options.residual_window_s;
    if (!is_whole || !carries(point, last) || !is_high(point, last, ground_m)) return 0.0;
    return std::abs(heights_m_(point, last) - heights_m_(point, sample)) / duration_s;
  }

  double greatest_mean_N(const MatrixXd& carried_N, double ground_m) const {
    const Motion& motion = checked_.motion;
    const double window_s = std::min(checked_.options.residual_window_s, motion.duration_s());
    if (!(window_s > 0.0)) return carried_N.maxCoeff();
    RunningIntegral integral(motion.times_s, carried_N);
    for (const Jolt& jolt : checked_.demand.jolts) {
      Eigen::VectorXd impulse_N_s = Eigen::VectorXd::Zero(1);
      for (Index i = 0; i < heights_m_.rows(); ++i) {
        if (!is_high(i, jolt.sample, ground_m)) continue;
        impulse_N_s[0] += jolt.impulses_N_s.segment<3>(3 * i).norm();
      }
      integral.add_impulse(jolt.sample, impulse_N_s);
    }
    double greatest_N = 0.0;
    for (Index sample = 0; sample < motion.samples(); ++sample) {
      if (sample > 0 && motion.time_s(sample) + window_s > motion.times_s.back()) break;
      greatest_N = std::max(greatest_N, integral.over(sample, window_s)[0] / window_s);
    }
    return greatest_N;
  }

  const CheckedMotion& checked_;
  const MatrixXd& heights_m_;
  double limit_m_;
  MatrixXd sizes_N_;  ///< (points x samples)
};

std::string what_to_do(const CheckedMotion& checked, double level_m, bool is_level,
                       const HighLoad& load) {
  const ContactRule& rule = checked.options.contact;
  if (is_level) {
    return fmt::format(
        "undecided: is the ground at {:.4g} m? --ground-height {:.4g}, else they do "
        "not touch",
        rule.ground_height_m + level_m, rule.ground_height_m + level_m);
  }
  const double counts_m_s = rule.thresholds().speed_m_s;
  if (load.speed_m_s > counts_m_s) {
    return fmt::format(
        "they move up or down at {:.3g} m/s while they carry it, {:g} m/s count as "
        "touching: no ground is there (--ground-height, --contact-height)",
        load.speed_m_s, counts_m_s);
  }
  return "undecided: no flat ground at one height explains it. Does the base's height drift, or is "
         "the ground not flat? Heights corrected, --contact-height or flags without these points "
         "would tell";
}

}  // namespace

std::vector<Finding> contact_above_ground(const CheckedMotion& checked) {
  const ContactSchedule& contacts = checked.contacts;
  const bool is_said = contacts.origin == Origin::kGiven && checked.demand.has_dynamics &&
                       contacts.height_m.size() > 0;
  if (!is_said) return {};
  const ContactRule& rule = checked.options.contact;
  const double limit_m = rule.height_m.value_or(kHighestTouch_m);
  const TouchingHeights touching(checked, limit_m);
  const double most_N = checked.options.residual_share * checked.demand.weight_N;
  const HighLoad load = touching.above(0.0);
  if (!(load.mean_N > most_N)) return {};
  const double level_m = touching.median_m();
  const HighLoad left = touching.above(level_m);
  const bool is_level = left.mean_N <= most_N;
  const bool is_fast = left.speed_m_s > rule.thresholds().speed_m_s;
  Finding finding;
  finding.severity =
      !is_level && is_fast ? actuator::Severity::kViolation : actuator::Severity::kWarning;
  finding.rule = "contact-above-ground";
  finding.joint = checked.robot.contacts[static_cast<std::size_t>(load.point)].name;
  finding.time_s = checked.motion.time_s(load.sample);
  finding.value = load.height_m;
  finding.limit = limit_m;
  finding.unit = "m";
  finding.sentence = fmt::format(
      "{}: touches by the file {:.4g} m above the ground at t = {} s, up to {:.4g} m counts as "
      "touching; points so high carry up to {:.4g} N (mean over {:g} ms). {}",
      finding.joint, load.height_m, io::time_text(*finding.time_s), limit_m, load.mean_N,
      1e3 * checked.options.residual_window_s,
      what_to_do(checked, level_m, is_level, is_level ? load : left));
  return {finding};
}

}  // namespace torquewright::hopper
