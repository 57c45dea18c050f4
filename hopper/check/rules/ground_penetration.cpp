// SPDX-License-Identifier: Apache-2.0
// Contact points below the ground. Soft ground lets a foot sink by what its speed at touch-down and
// its load make of the ground's time constant: docs/derivations/whole_body_check.md, eqs.
// (26)-(28).
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "dynamics/point.hpp"
#include "hopper/check/rules/every_rule.hpp"
#include "hopper/contact/sliding.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kSoftest = kSoftestImpedance;
constexpr double kStiffest = kStiffestImpedance;
constexpr double kStiffensOver_m = 1e-3;

/// How deep soft ground lets a point of a motion sink, and of what.
struct Sinking {
  double speed_m_s = 0.0;  ///< Greatest at which it goes below the ground.
  double by_speed_m = 0.0;
  double by_load_m = 0.0;

  double depth_m() const { return by_speed_m + by_load_m; }
};

/// As the heights tell it, of the step that crosses the ground and of the one before.
double touch_down_speed_m_s(const Motion& motion, const Eigen::MatrixXd& heights_m, Index point) {
  const auto speed_after = [&](Index sample) {
    const double step_s = motion.step_s(sample);
    if (step_s == 0.0) return 0.0;
    return (heights_m(point, sample) - heights_m(point, sample + 1)) / step_s;
  };
  double greatest_m_s = 0.0;
  for (Index sample = 0; sample + 1 < motion.samples(); ++sample) {
    if (heights_m(point, sample) <= 0.0 || heights_m(point, sample + 1) > 0.0) continue;
    greatest_m_s = std::max(greatest_m_s, speed_after(sample));
    if (sample > 0) greatest_m_s = std::max(greatest_m_s, speed_after(sample - 1));
  }
  return greatest_m_s;
}

/// How fast loads would take the point down without the ground: what the ground's force gives it,
/// by the mean over the directions of the inverse inertia that its body has at its centre of mass
/// (MuJoCo's body_invweight0), less what the point has.
double load_m_s2(const CheckedMotion& checked, Index point, Index sample) {
  const double force_N = checked.demand.forces_N(3 * point + 2, sample);
  if (!(force_N > 0.0)) return 0.0;
  const ContactPoint& contact = checked.robot.contacts[static_cast<std::size_t>(point)];
  const std::optional<double> moves_1_kg =
      mean_inverse_mass_1_kg(checked.robot, checked.motion, contact.point.body, sample);
  if (!moves_1_kg) return 0.0;
  dynamics::TreeState state(checked.robot.tree);
  state.set(checked.motion.positions.col(sample), checked.motion.velocities.col(sample));
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, checked.robot.tree.velocity_size());
  dynamics::point_jacobian(state, contact.point, jacobian);
  const double up_m_s2 = jacobian.row(2).dot(checked.motion.accelerations.col(sample)) +
                         dynamics::point_bias_acceleration_m_s2(state, contact.point).z();
  return std::max(0.0, force_N * *moves_1_kg - up_m_s2);
}

double sinking_by_load_m(double time_constant_s, double downwards_m_s2) {
  const double softest_s = time_constant_s * kStiffest / kSoftest;
  const double shallow_m = (1.0 - kSoftest) * softest_s * softest_s * downwards_m_s2;
  if (shallow_m <= kStiffensOver_m) return shallow_m;
  return std::max(kStiffensOver_m,
                  (1.0 - kStiffest) * time_constant_s * time_constant_s * downwards_m_s2);
}

Sinking sinking_of(const CheckedMotion& checked, Index point, Index deepest) {
  const double time_constant_s = checked.options.contact.time_constant_s;
  Sinking sinking;
  sinking.speed_m_s = touch_down_speed_m_s(checked.motion, checked.contacts.height_m, point);
  sinking.by_speed_m = sinking.speed_m_s * time_constant_s * kStiffest / kSoftest / std::numbers::e;
  if (!checked.demand.has_dynamics) return sinking;
  Index loaded = 0;
  checked.demand.forces_N.row(3 * point + 2).maxCoeff(&loaded);
  for (const Index sample : {deepest, loaded}) {
    sinking.by_load_m = std::max(
        sinking.by_load_m, sinking_by_load_m(time_constant_s, load_m_s2(checked, point, sample)));
  }
  return sinking;
}

std::string sinking_words(const CheckedMotion& checked, const Sinking& sinking) {
  const ContactRule& rule = checked.options.contact;
  if (rule.height_m) {
    return fmt::format("up to {:.4g} m counts as touching", *rule.height_m);
  }
  return fmt::format(
      "soft ground with a time constant of {:g} s lets it sink by {:.4g} m: {:.3g} m by a "
      "touch-down at {:.3g} m/s, {:.3g} m by its load; --contact-time-constant, --contact-height",
      rule.time_constant_s, sinking.depth_m(), sinking.by_speed_m, sinking.speed_m_s,
      sinking.by_load_m);
}

}  // namespace

std::vector<Finding> ground_penetration(const CheckedMotion& checked) {
  std::vector<Finding> findings;
  const Eigen::MatrixXd& heights_m = checked.contacts.height_m;
  const double touching_m = checked.contacts.thresholds.height_m;
  const bool is_stated = checked.options.contact.height_m.has_value();
  for (Index i = 0; i < heights_m.rows(); ++i) {
    Index sample = 0;
    const double least_m = heights_m.row(i).minCoeff(&sample);
    if (least_m >= -touching_m) continue;
    const std::string& name = checked.robot.contacts[static_cast<std::size_t>(i)].name;
    const Sinking sinking = is_stated ? Sinking{} : sinking_of(checked, i, sample);
    const double limit_m = std::max(touching_m, sinking.depth_m());
    findings.push_back(
        {least_m < -limit_m ? actuator::Severity::kViolation : actuator::Severity::kWarning,
         "contact-below-ground", name, checked.motion.time_s(sample), least_m, -limit_m, "m",
         fmt::format("{}: {:.4g} m below the ground at t = {} s ({}; is the ground at {:.4g} "
                     "m? --ground-height)",
                     name, -least_m, io::time_text(checked.motion.time_s(sample)),
                     sinking_words(checked, sinking), checked.options.contact.ground_height_m)});
  }
  return findings;
}

}  // namespace torquewright::hopper
