// SPDX-License-Identifier: Apache-2.0
#include "identification/robot_search/simulated_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/library.hpp"
#include "identification/findings/verdict.hpp"
#include "identification/findings/with_effects.hpp"

namespace torquewright::identification {
namespace {

using Of = FreeValue::Of;

constexpr double kMoved = 3.0;  ///< Standard errors of a value that is not as stated.

/// Effects that are plain numbers of every joint's fit, and their number there.
struct PlainNumber {
  const actuator::EffectKind* kind;
  Of of;
};
constexpr PlainNumber kPlain[] = {
    {&actuator::effects::coulomb_friction, Of::kEffect},
    {&actuator::effects::viscous_friction, Of::kEffect},
    {&actuator::effects::reflected_inertia, Of::kRotor},
};

bool is_in(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const FittedValue* plain_value(const RobotStudy& study, std::size_t joint,
                               const std::string& effect) {
  for (const PlainNumber& plain : kPlain) {
    if (effect != plain.kind->name) continue;
    for (const FittedValue& each : study.fit.values) {
      const bool is_own = plain.of == Of::kRotor || each.which.effect == effect;
      if (each.which.joint == joint && each.which.of == plain.of && is_own) return &each;
    }
  }
  return nullptr;
}

FoundParameters parameters_of(const SimulatedEffect& found) {
  FoundParameters parameters;
  for (const FittedValue& each : found.values) {
    if (each.which.of == Of::kEffect)
      parameters.numbers.push_back({each.which.name, each.value, each.standard_error});
  }
  for (const actuator::Harmonic& each : found.effect.harmonics) {
    FoundWave wave;
    wave.order = each.order;
    wave.amplitude = {found.effect.proportional ? "amplitude_ratio" : "amplitude_Nm",
                      each.amplitude};
    wave.phase_rad.value = each.phase_rad;
    parameters.waves.push_back(std::move(wave));
  }
  if (found.effect.kind->may_be_proportional) parameters.proportional = found.effect.proportional;
  return parameters;
}

std::string evidence_of(const SimulatedEffect& found) {
  return fmt::format(
      "Simulated under its own loop, the robot follows its log better by {:.0f} standard errors "
      "with it; on the runs not fitted the joint is {:.3g} mrad off, and was {:.3g}.",
      found.sigmas, 1e3 * found.after_rad, 1e3 * found.before_rad);
}

/// One joint's balance of torques before the simulation.
class JudgedEquation {
 public:
  JudgedEquation(const SimulatedSearch& search, const RobotStudy& study, std::size_t joint,
                 EquationResult& equation)
      : search_(search), study_(study), joint_(joint), equation_(equation) {}

  void run() {
    const std::size_t before = equation_.added.size();
    reject();
    for (const SimulatedEffect& each : search_.found) {
      if (each.joint == joint_) settle(each);
    }
    set_attitude();
    const bool is_other = equation_.added.size() != before || is_settled_;
    if (!is_other) return;
    equation_.verdict = verdict_of(equation_, true);
    // The balance of torques sees what the simulation does not need.
    if (equation_.added.empty() && !equation_.is_noise_before)
      equation_.verdict = Verdict::kCannotTell;
  }

 private:
  bool is_found(const std::string& effect) const {
    return std::any_of(search_.found.begin(), search_.found.end(),
                       [&](const SimulatedEffect& each) {
                         return each.joint == joint_ &&
                                (each.effect.kind->name == effect || is_in(each.rivals, effect));
                       });
  }

  bool has_found() const {
    return std::any_of(search_.found.begin(), search_.found.end(),
                       [&](const SimulatedEffect& each) { return each.joint == joint_; });
  }

  /// Why the simulation does not need a name; empty where it does, or cannot say: that it follows
  /// no better with a law says little as long as it does not follow by another.
  std::string objection(const NamedEffect& named) const {
    if (!has_found() || is_found(named.effect)) return "";
    if (const FittedValue* plain = plain_value(study_, joint_, named.effect)) {
      const double moved = std::abs(plain->value - plain->stated);
      if (moved > kMoved * plain->standard_error) return "";
      return fmt::format(
          "simulated under its own loop, the robot follows its log with {} {:.3g} ± {:.1g}, as "
          "stated ({:.3g})",
          plain->which.name, plain->value, plain->standard_error, plain->stated);
    }
    const bool is_offset = named.family == EffectFamily::kLog && named.effect == "torque_offset";
    const bool is_tried =
        named.family == EffectFamily::kActuator && is_in(search_.tried[joint_], named.effect);
    if (!is_offset && !is_tried) return "";
    return "simulated under its own loop, the robot follows its log as well without it";
  }

  void reject() {
    std::vector<NamedEffect> kept;
    for (NamedEffect& each : equation_.added) {
      std::string reason = objection(each);
      if (reason.empty()) {
        kept.push_back(std::move(each));
        continue;
      }
      drop_groups_of(each.effect);
      equation_.rejected.push_back({each.effect, std::move(reason)});
    }
    equation_.added = std::move(kept);
  }

  void drop_groups_of(const std::string& effect) {
    std::erase_if(equation_.confounded, [&](const Confounded& group) {
      return !group.effects.empty() && group.effects.front() == effect;
    });
  }

  void settle(const SimulatedEffect& found) {
    const std::string name(found.effect.kind->name);
    std::erase_if(equation_.confounded, [&](const Confounded& group) {
      return !group.exact && is_in(group.effects, name);
    });
    std::erase_if(equation_.rejected, [&](const Rejection& each) { return each.effect == name; });
    const auto own = std::find_if(equation_.added.begin(), equation_.added.end(),
                                  [&](const NamedEffect& each) { return each.effect == name; });
    is_settled_ = true;
    if (own != equation_.added.end()) {
      own->doubt.clear();
      own->is_refuted = false;
      own->evidence += (own->evidence.empty() ? "" : " ") + evidence_of(found);
    } else if (!actuator::is_wave_of_friction(name)) {  // which stands for any slow rise and fall
      NamedEffect named;
      named.effect = name;
      named.parameters = parameters_of(found);
      named.holdout_rms_before = named.holdout_rms_after = equation_.after.holdout_rms;
      named.evidence = evidence_of(found);
      equation_.added.push_back(std::move(named));
    }
    if (found.rivals.empty()) return;
    Confounded group;
    group.effects = {name};
    for (const std::string& each : found.rivals) {
      if (!is_in(group.effects, each)) group.effects.push_back(each);
    }
    group.separated_by = "motion on which their simulations differ by more than the noise";
    if (group.effects.size() > 1) equation_.confounded.push_back(std::move(group));
  }

  /// How the base hung is one for all joints.
  void set_attitude() {
    for (Correction& each : equation_.corrected) {
      for (const FittedValue& value : study_.fit.values) {
        const bool is_of_base = value.which.of == Of::kRoll || value.which.of == Of::kPitch;
        if (!is_of_base || each.pointer != "/load/" + value.which.name) continue;
        each.value = value.value;
        each.standard_error = value.standard_error;
      }
    }
  }

  const SimulatedSearch& search_;
  const RobotStudy& study_;
  std::size_t joint_;
  EquationResult& equation_;
  bool is_settled_ = false;
};

void add_of(const std::vector<NamedEffect>& all, const actuator::Actuator& stated,
            std::vector<actuator::Effect>& named) {
  for (const NamedEffect& each : all) {
    const bool is_plain =
        std::any_of(std::begin(kPlain), std::end(kPlain),
                    [&](const PlainNumber& plain) { return each.effect == plain.kind->name; });
    if (each.family != EffectFamily::kActuator || is_plain) continue;
    const actuator::Effect effect = with_effects(stated, {each}).effects.back();
    const bool is_there =
        std::any_of(named.begin(), named.end(),
                    [&](const actuator::Effect& other) { return other.kind == effect.kind; });
    if (!is_there) named.push_back(effect);
  }
}

}  // namespace

NamedByJoint named_by_equations(const std::vector<EquationResult>& equations,
                                const std::vector<std::string>& joints, const RobotModel& stated) {
  NamedByJoint named(joints.size());
  for (const EquationResult& equation : equations) {
    const auto joint = static_cast<std::size_t>(
        std::find(joints.begin(), joints.end(), equation.joint) - joints.begin());
    if (joint == joints.size()) continue;
    add_of(equation.added, stated.drives[joint], named[joint]);
    for (const ModelWithinNoise& model : equation.models)
      add_of(model.effects, stated.drives[joint], named[joint]);
  }
  return named;
}

void judge_names(const SimulatedSearch& search, const RobotStudy& study,
                 const std::vector<std::string>& joints, std::vector<EquationResult>& equations) {
  if (search.tried.empty()) return;
  std::map<std::string, bool> is_judged;  // one equation of each joint: its balance of torques
  for (EquationResult& equation : equations) {
    const auto joint = static_cast<std::size_t>(
        std::find(joints.begin(), joints.end(), equation.joint) - joints.begin());
    const bool is_torque = equation.unit == "Nm" && !is_judged[equation.joint];
    if (joint == joints.size() || !is_torque || search.tried[joint].empty()) continue;
    is_judged[equation.joint] = true;
    JudgedEquation(search, study, joint, equation).run();
  }
}

}  // namespace torquewright::identification
