// SPDX-License-Identifier: Apache-2.0
// The ground takes energy in an impact and never gives any: impulses times the mean of the points'
// velocities before and after are what it does, and points leave no faster than their restitution
// lets them. docs/derivations/whole_body_check.md, "Energy of impacts".
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "hopper/check/rules/every_rule.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr double kNegligibleImpulse = 1e-3;  // of weight times the residual's window

/// What the ground does in one impact, all points together.
struct GroundWork {
  double made_J = 0.0;        ///< By impulses and velocities,
  double doubt_J = 0.0;       ///< known to this.
  double rebound_m_s = 0.0;   ///< Mean normal speed afterwards, by the points' impulses,
  double approach_m_s = 0.0;  ///< before,
  double allowed_m_s = 0.0;   ///< and what the restitutions make of that.
  double doubt_m_s = 0.0;     ///< Of the rebound.
  double normal_N_s = 0.0;
  Index point = 0;  ///< That of the greatest normal impulse.
};

GroundWork ground_work(const Robot& robot, const Jolt& jolt) {
  GroundWork work;
  double most_N_s = 0.0;
  for (Index i = 0; i < static_cast<Index>(robot.contacts.size()); ++i) {
    const Vector3d impulse_N_s = jolt.impulses_N_s.segment<3>(3 * i);
    const Vector3d before_m_s = jolt.before_m_s.segment<3>(3 * i);
    const Vector3d after_m_s = jolt.after_m_s.segment<3>(3 * i);
    const double restitution = robot.contacts[static_cast<std::size_t>(i)].restitution;
    const double normal_N_s = impulse_N_s.z();
    work.made_J += 0.5 * impulse_N_s.dot(before_m_s + after_m_s);
    work.doubt_J += impulse_N_s.norm() * jolt.beside_m_s[i];
    work.normal_N_s += normal_N_s;
    work.rebound_m_s += normal_N_s * after_m_s.z();
    work.approach_m_s -= normal_N_s * before_m_s.z();
    work.allowed_m_s -= normal_N_s * restitution * before_m_s.z();
    work.doubt_m_s += normal_N_s * jolt.beside_m_s[i];
    if (normal_N_s > most_N_s) {
      most_N_s = normal_N_s;
      work.point = i;
    }
  }
  if (!(work.normal_N_s > 0.0)) return work;
  for (double* speed_m_s :
       {&work.rebound_m_s, &work.approach_m_s, &work.allowed_m_s, &work.doubt_m_s}) {
    *speed_m_s /= work.normal_N_s;
  }
  return work;
}

Finding violation(const CheckedMotion& checked, const Jolt& jolt, const GroundWork& work) {
  Finding finding;
  finding.severity = actuator::Severity::kViolation;
  finding.joint = checked.robot.contacts[static_cast<std::size_t>(work.point)].name;
  finding.time_s = jolt.time_s;
  return finding;
}

}  // namespace

std::vector<Finding> impact_energy(const CheckedMotion& checked) {
  std::optional<Finding> made;
  std::optional<Finding> rebounds;
  const double counts_m_s = checked.options.contact.thresholds().speed_m_s;
  const double negligible_N_s =
      kNegligibleImpulse * checked.demand.weight_N * checked.options.residual_window_s;
  for (const Jolt& jolt : checked.demand.jolts) {
    const GroundWork work = ground_work(checked.robot, jolt);
    if (work.normal_N_s <= negligible_N_s) continue;
    if (work.made_J > work.doubt_J && (!made || work.made_J > *made->value)) {
      made = violation(checked, jolt, work);
      made->rule = "impact-energy";
      made->value = work.made_J;
      made->limit = work.doubt_J;
      made->unit = "J";
      made->sentence = fmt::format(
          "{}: in the impact at t = {} s the ground would have to give {:.4g} J, and it only "
          "takes (known to {:.2g} J by the velocities' steps beside it)",
          made->joint, io::time_text(jolt.time_s), work.made_J, work.doubt_J);
    }
    const double limit_m_s = std::max(work.allowed_m_s, 0.0) + work.doubt_m_s + counts_m_s;
    const bool is_more = !rebounds || work.rebound_m_s > *rebounds->value;
    if (work.rebound_m_s > limit_m_s && is_more) {
      rebounds = violation(checked, jolt, work);
      rebounds->rule = "impact-rebound";
      rebounds->value = work.rebound_m_s;
      rebounds->limit = limit_m_s;
      rebounds->unit = "m/s";
      rebounds->sentence = fmt::format(
          "{}: met the ground at {:.4g} m/s at t = {} s and leaves it at {:.4g} m/s; its "
          "restitution lets it leave at {:.4g} m/s (and {:.2g} m/s for what counts as touching and "
          "the velocities' steps beside the impact)",
          rebounds->joint, work.approach_m_s, io::time_text(jolt.time_s), work.rebound_m_s,
          std::max(work.allowed_m_s, 0.0), work.doubt_m_s + counts_m_s);
    }
  }
  std::vector<Finding> findings;
  for (std::optional<Finding>* finding : {&made, &rebounds}) {
    if (*finding) findings.push_back(std::move(**finding));
  }
  return findings;
}

}  // namespace torquewright::hopper
