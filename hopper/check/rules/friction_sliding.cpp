// SPDX-License-Identifier: Apache-2.0
// The ground brakes what slides over it with the friction coefficient times the normal force, and
// never pushes it along. docs/derivations/whole_body_check.md, "Sliding".
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "hopper/check/rules/every_rule.hpp"
#include "hopper/contact/sliding.hpp"
#include "hopper/demand/base_residual.hpp"
#include "hopper/demand/running_integral.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;

constexpr double kNoForce = 1e-3;  // of the weight: smaller forces are none; a choice of ours

/// What friction of sliding points does at a sample, as forces are given or solved.
struct Friction {
  double along_N = 0.0;  ///< Along the slip: braking is negative.
  double normal_N = 0.0;
  double brake_N = 0.0;  ///< What the coefficients make of the normal forces.
  double speed_m_s = 0.0;
  Index point = 0;  ///< That with the greatest normal force.
};

Friction friction_at(const CheckedMotion& checked, const Sliding& sliding, Index sample) {
  const MatrixXd& forces_N =
      checked.motion.has_forces ? checked.motion.forces_N : checked.demand.forces_N;
  Friction friction;
  double most_N = -1.0;
  for (Index i = 0; i < checked.contacts.touches.rows(); ++i) {
    if (!sliding.slides(i, sample)) continue;
    const Vector2d direction = sliding.direction.block<2, 1>(2 * i, sample);
    const double normal_N = std::max(0.0, forces_N(3 * i + 2, sample));
    friction.along_N += forces_N.block<2, 1>(3 * i, sample).dot(direction);
    friction.normal_N += normal_N;
    friction.brake_N +=
        normal_N * checked.robot.contacts[static_cast<std::size_t>(i)].friction_coefficient;
    if (normal_N <= most_N) continue;
    most_N = normal_N;
    friction.point = i;
    friction.speed_m_s = sliding.velocity_m_s.block<2, 1>(2 * i, sample).dot(direction);
  }
  return friction;
}

/// The most friction that may hold a point: its own where it is known, else what all points could
/// have together, since they may share it in any way.
double holding_N(const CheckedMotion& checked, const Sliding& sliding, Index point, Index sample) {
  if (checked.motion.has_forces || !checked.demand.is_shared) {
    const MatrixXd& forces_N =
        checked.motion.has_forces ? checked.motion.forces_N : checked.demand.forces_N;
    return std::max(0.0, -forces_N.block<2, 1>(3 * point, sample)
                              .dot(sliding.direction.block<2, 1>(2 * point, sample)));
  }
  double normal_N = 0.0;
  for (Index i = 0; i < checked.contacts.touches.rows(); ++i) {
    normal_N += std::max(0.0, checked.demand.forces_N(3 * i + 2, sample));
  }
  return normal_N * checked.robot.contacts[static_cast<std::size_t>(point)].friction_coefficient;
}

/// What soft ground lets slip, eq. (31), does not slide.
void let_creep(const CheckedMotion& checked, Sliding& sliding) {
  const ContactRule& rule = checked.options.contact;
  for (Index sample = 0; sample < checked.motion.samples(); ++sample) {
    for (Index i = 0; i < checked.contacts.touches.rows(); ++i) {
      if (!sliding.slides(i, sample)) continue;
      auto direction = sliding.direction.block<2, 1>(2 * i, sample);
      const double speed_m_s = sliding.velocity_m_s.block<2, 1>(2 * i, sample).dot(direction);
      const std::size_t body = checked.robot.contacts[static_cast<std::size_t>(i)].point.body;
      const double creep =
          creep_m_s(rule.time_constant_s, holding_N(checked, sliding, i, sample),
                    mean_inverse_mass_1_kg(checked.robot, checked.motion, body, sample).value_or(0),
                    sliding.braked_m_s2(i, sample));
      if (speed_m_s <= rule.thresholds().speed_m_s + creep) direction.setZero();
    }
  }
}

/// What is lacking of the least that friction brakes with.
struct Lacking {
  double mean_N = 0.0;  ///< Or Nm.
  double limit_N = 0.0;
  const char* unit = "N";
  double time_s = 0.0;
};

/// No forces that brake what slides explain the motion, beyond what is left anyhow.
std::optional<Lacking> left_unexplained(const CheckedMotion& checked, const Sliding& sliding) {
  const MatrixXd left = left_by_sliding(checked.robot, checked.motion, checked.contacts,
                                        sliding.direction, checked.demand.residual);
  const BaseResidual braked = base_residual(checked, left);
  const BaseResidual anyhow = base_residual(checked);
  std::optional<Lacking> worst;
  const auto note = [&](const ResidualPeak& peak, const ResidualPeak& without, const char* unit) {
    const double limit = peak.limit + without.mean;
    if (!(peak.mean > limit)) return;
    if (worst && peak.mean / limit <= worst->mean_N / worst->limit_N) return;
    worst = Lacking{peak.mean, limit, unit, peak.time_s};
  };
  note(braked.force, anyhow.force, "N");
  note(braked.moment, anyhow.moment, "Nm");
  note(braked.passive, anyhow.passive, "Nm");
  return worst;
}

/// Forces of the file that do not brake.
std::optional<Lacking> lacking_in_file(const CheckedMotion& checked, const Sliding& sliding) {
  const Motion& motion = checked.motion;
  if (!motion.has_forces) return std::nullopt;
  MatrixXd lacking_N = MatrixXd::Zero(1, motion.samples());
  for (Index sample = 0; sample < motion.samples(); ++sample) {
    const Friction friction = friction_at(checked, sliding, sample);
    lacking_N(0, sample) = std::max(0.0, friction.along_N + friction.brake_N / std::numbers::sqrt2);
  }
  const double window_s = std::min(checked.options.residual_window_s, motion.duration_s());
  if (!(window_s > 0.0)) return std::nullopt;
  const RunningIntegral integral(motion.times_s, lacking_N);
  Lacking worst{0.0, checked.options.residual_share * checked.demand.weight_N, "N", 0.0};
  for (Index sample = 0; sample < motion.samples(); ++sample) {
    const double mean_N = integral.over(sample, window_s)[0] / window_s;
    if (mean_N <= worst.mean_N) continue;
    worst.mean_N = mean_N;
    worst.time_s = motion.time_s(sample);
  }
  if (worst.mean_N <= worst.limit_N) return std::nullopt;
  return worst;
}

/// The first sample that slides, in the window or after it.
Index sliding_sample(const CheckedMotion& checked, const Sliding& sliding, double time_s) {
  Index found = 0;
  for (Index sample = 0; sample < checked.motion.samples(); ++sample) {
    if (sliding.direction.col(sample).isZero(0.0)) continue;
    found = sample;
    if (checked.motion.time_s(sample) >= time_s) break;
  }
  return found;
}

std::string along_words(double along_N, double weight_N) {
  if (std::abs(along_N) < kNoForce * weight_N) return "let it slide without a brake";
  return along_N > 0.0 ? fmt::format("push it along with {:.4g} N", along_N)
                       : fmt::format("brake it with {:.4g} N", -along_N);
}

Finding slides(const CheckedMotion& checked, const Sliding& sliding, const Lacking& lacking) {
  const Index sample = sliding_sample(checked, sliding, lacking.time_s);
  const Friction friction = friction_at(checked, sliding, sample);
  Finding finding;
  finding.severity = actuator::Severity::kViolation;
  finding.rule = "friction-sliding";
  finding.joint = checked.robot.contacts[static_cast<std::size_t>(friction.point)].name;
  finding.time_s = checked.motion.time_s(sample);
  finding.value = lacking.mean_N;
  finding.limit = lacking.limit_N;
  finding.unit = lacking.unit;
  finding.sentence = fmt::format(
      "{}: slides at {:.3g} m/s at t = {} s, where the ground would have to {}; what slides "
      "under {:.4g} N is braked with {:.4g} N. {:.4g} {} over {:g} ms are not explained by such "
      "friction (limit {:.3g} {}). Is the friction_coefficient right, does the point touch?",
      finding.joint, friction.speed_m_s, io::time_text(*finding.time_s),
      along_words(friction.along_N, checked.demand.weight_N), friction.normal_N, friction.brake_N,
      lacking.mean_N, lacking.unit, 1e3 * checked.options.residual_window_s, lacking.limit_N,
      lacking.unit);
  return finding;
}

/// An impact that pushes along what slides before it and after it.
std::optional<Finding> pushed_in_impact(const CheckedMotion& checked) {
  std::optional<Finding> worst;
  const double counts_m_s = checked.options.contact.thresholds().speed_m_s;
  for (const Jolt& jolt : checked.demand.jolts) {
    double pushed_N_s = 0.0;
    double before = 0.0;
    double after = 0.0;
    double doubt = 0.0;
    double most_N_s = 0.0;
    Index point = 0;
    for (Index i = 0; i < checked.contacts.touches.rows(); ++i) {
      const Vector2d impulse_N_s = jolt.impulses_N_s.segment<2>(3 * i);
      pushed_N_s += impulse_N_s.norm();
      before += impulse_N_s.dot(jolt.before_m_s.segment<2>(3 * i));
      after += impulse_N_s.dot(jolt.after_m_s.segment<2>(3 * i));
      doubt += impulse_N_s.norm() * (jolt.beside_m_s[i] + counts_m_s);
      if (impulse_N_s.norm() <= most_N_s) continue;
      most_N_s = impulse_N_s.norm();
      point = i;
    }
    const double negligible_N_s = checked.options.residual_share * checked.demand.weight_N *
                                  checked.options.residual_window_s;
    const bool pushes = pushed_N_s > negligible_N_s && before > doubt && after > doubt;
    if (!pushes || (worst && pushed_N_s <= *worst->value)) continue;
    const std::string& name = checked.robot.contacts[static_cast<std::size_t>(point)].name;
    worst = {actuator::Severity::kViolation,
             "friction-sliding",
             name,
             jolt.time_s,
             pushed_N_s,
             negligible_N_s,
             "N s",
             fmt::format("{}: slides before and after the impact at t = {} s, at {:.3g} and "
                         "{:.3g} m/s along the {:.4g} N s that the ground would have to push it "
                         "with, and it only brakes what slides",
                         name, io::time_text(jolt.time_s), before / pushed_N_s, after / pushed_N_s,
                         pushed_N_s)};
  }
  return worst;
}

}  // namespace

std::vector<Finding> friction_sliding(const CheckedMotion& checked) {
  std::vector<Finding> findings;
  if (!checked.demand.has_dynamics || checked.robot.contacts.empty()) return findings;
  if (auto pushed = pushed_in_impact(checked)) findings.push_back(std::move(*pushed));
  Sliding sliding =
      find_sliding(checked.robot, checked.options.contact, checked.contacts, checked.motion);
  let_creep(checked, sliding);
  if (!sliding.any()) return findings;
  std::optional<Lacking> lacking = lacking_in_file(checked, sliding);
  if (!lacking) lacking = left_unexplained(checked, sliding);
  if (lacking) findings.push_back(slides(checked, sliding, *lacking));
  return findings;
}

}  // namespace torquewright::hopper
