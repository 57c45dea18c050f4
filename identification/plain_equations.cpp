// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "actuator/effects/library.hpp"
#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/winding.hpp"
#include "identification/equation.hpp"
#include "identification/signal.hpp"
#include "identification/uncertain.hpp"

namespace torquewright::identification {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// Adds columns and variants to an equation whose members' coefficients are parameters themselves.
class PlainBuilder {
 public:
  PlainBuilder(std::string quantity, std::string unit, Target target) {
    equation_.quantity = std::move(quantity);
    equation_.unit = std::move(unit);
    equation_.target = std::move(target);
  }

  std::size_t add(std::string name, std::function<double(const Signals&, std::size_t)> value) {
    equation_.dictionary.columns.push_back(
        {std::move(name),
         [value = std::move(value)](const Signals& signals, std::vector<double>& out) {
           for (std::size_t i = 0; i < out.size(); ++i) out[i] = value(signals, i);
         }});
    return equation_.dictionary.columns.size() - 1;
  }

  /// `parameters`: what the coefficients are, and how they follow from them.
  void variant(std::string effect, EffectFamily family, const std::vector<std::size_t>& columns,
               double lowest, double highest) {
    Variant added;
    added.effect = std::move(effect);
    added.family = family;
    for (const std::size_t column : columns)
      added.coefficients.push_back({{{column, 1.0}}, lowest, highest});
    equation_.dictionary.variants.push_back(std::move(added));
  }

  void always(std::size_t column) {
    equation_.always.push_back({{{column, 1.0}}, -kUnlimited, kUnlimited});
  }

  using Naming = std::function<void(const Variant&, const Eigen::VectorXd& values,
                                    const Eigen::VectorXd& errors, NamedEffect&)>;
  Equation build(Naming naming) {
    equation_.name = [naming = std::move(naming),
                      variants = equation_.dictionary.variants](const Fit& fit) {
      Dictionary only;
      only.variants = variants;
      const std::size_t always = count_always(fit, variants);
      std::vector<Named> all;
      for (std::size_t m = 0; m < fit.members.size(); ++m) {
        const Variant& variant = variants[fit.members[m]];
        const auto first = static_cast<Eigen::Index>(fit.first_of_member(only, m, always));
        const auto count = static_cast<Eigen::Index>(variant.coefficients.size());
        Named named;
        named.members = {m};
        named.effect.effect = variant.effect;
        named.effect.family = variant.family;
        named.effect.parameters = nlohmann::ordered_json::object();
        named.effect.standard_error = nlohmann::ordered_json::object();
        const Eigen::VectorXd values = fit.values.segment(first, count);
        const Eigen::VectorXd errors =
            fit.covariance.diagonal().segment(first, count).cwiseMax(0.0).cwiseSqrt();
        naming(variant, values, errors, named.effect);
        all.push_back(std::move(named));
      }
      return all;
    };
    return std::move(equation_);
  }

 private:
  Equation equation_;
};

void set(NamedEffect& effect, const char* name, double value, double error) {
  effect.parameters[name] = value;
  effect.standard_error[name] = error;
}

/// Torque that the gears carry, from the motor's side: twist follows it.
double carried_Nm(const Signals& signals, std::size_t i) { return signals.at[i].load_torque_Nm; }

Equation twist_equation(const Bench& /*bench*/) {
  PlainBuilder builder("motor_position_rad", "rad",
                       [](const Signals& signals) { return signals.twist_rad; });
  builder.always(
      builder.add("zero of the encoders", [](const Signals&, std::size_t) { return 1.0; }));
  const std::size_t spring = builder.add("carried torque", carried_Nm);
  const std::size_t side =
      builder.add("side of the teeth", [](const Signals& signals, std::size_t i) {
        const double torque = carried_Nm(signals, i);
        return torque > 0.0 ? 0.5 : torque < 0.0 ? -0.5 : 0.0;
      });
  const std::size_t speed = builder.add(
      "speed", [](const Signals& signals, std::size_t i) { return signals.at[i].speed_rad_s; });
  builder.variant("backlash", EffectFamily::kActuator, {side}, 0.0, kUnlimited);
  builder.variant("torsional_compliance", EffectFamily::kActuator, {spring}, 0.0, kUnlimited);
  builder.variant("channel_delay", EffectFamily::kLog, {speed}, -0.2, 0.2);
  return builder.build([](const Variant& variant, const Eigen::VectorXd& values,
                          const Eigen::VectorXd& errors, NamedEffect& named) {
    if (variant.effect == "backlash") return set(named, "gap_rad", values[0], errors[0]);
    if (variant.effect == "torsional_compliance") {
      const double stiffness = 1.0 / values[0];
      set(named, "stiffness_Nm_rad", stiffness, errors[0] * stiffness * stiffness);
      // Twist alone does not show it: as stated, none, and no error is claimed.
      named.parameters["damping_Nm_s_rad"] = 0.0;
      named.standard_error["damping_Nm_s_rad"] = nullptr;
      return;
    }
    // Twist = motor(t - d)/N - output(t) = -d speed: a late motor channel makes it negative.
    named.parameters["channel"] = values[0] < 0.0 ? "motor_position_rad" : "output_position_rad";
    set(named, "delay_s", std::abs(values[0]), errors[0]);
  });
}

/// V - R i - Ke N w.
Equation voltage_equation(const Bench& bench) {
  const actuator::Winding winding = actuator::winding_of(bench.actuator());
  const double ratio = bench.actuator().transmission.ratio;
  const auto back_emf = [winding, ratio](const Signals& signals, std::size_t i) {
    return winding.back_emf_V_s_rad * ratio * signals.at[i].speed_rad_s;
  };
  const actuator::Actuator& actuator = bench.actuator();
  PlainBuilder builder(
      "winding_voltage_V", "V", [winding, back_emf, &actuator](const Signals& signals) {
        std::vector<double> left(signals.size());
        for (std::size_t i = 0; i < left.size(); ++i) {
          left[i] =
              signals.voltage_V[i] - back_emf(signals, i) -
              actuator::resistance_ohm(actuator, winding, signals.at[i]) * signals.at[i].current_A;
        }
        return left;
      });
  const std::size_t constant = builder.add("back-EMF", back_emf);
  const std::size_t warm =
      builder.add("resistance times T", [winding](const Signals& signals, std::size_t i) {
        const actuator::Instant& at = signals.at[i];
        return winding.resistance_ohm * at.current_A *
               (at.winding_temperature_K - at.reference_temperature_K);
      });
  const std::size_t dead = builder.add("dead time", [](const Signals& signals, std::size_t i) {
    const double current = signals.at[i].current_A;
    return current > 0.0 ? 1.0 : current < 0.0 ? -1.0 : 0.0;
  });
  if (!bench.actuator().motor.back_emf_constant_V_s_rad) {
    builder.variant("torque_constant_error", EffectFamily::kActuator, {constant}, -0.7, 3.0);
  }
  if (bench.has_temperature) {
    builder.variant("winding_resistance_temperature", EffectFamily::kActuator, {warm}, -0.02, 0.02);
  }
  builder.variant("inverter_dead_time", EffectFamily::kActuator, {dead}, 0.0, kUnlimited);
  for (const std::string& pointer : bench.rig->uncertain) {
    if (pointer != "/motor/resistance_ohm") continue;
    builder.always(builder.add("resistance", [winding](const Signals& signals, std::size_t i) {
      return winding.resistance_ohm * signals.at[i].current_A;
    }));
  }
  // The effect's coefficient stands for copper's, not beside it.
  const double known_1_K = actuator::resistance_coefficient_1_K(actuator);
  return builder.build([known_1_K](const Variant& variant, const Eigen::VectorXd& values,
                                   const Eigen::VectorXd& errors, NamedEffect& named) {
    if (variant.effect == "torque_constant_error")
      return set(named, "factor", 1.0 + values[0], errors[0]);
    if (variant.effect == "inverter_dead_time")
      return set(named, "voltage_V", values[0], errors[0]);
    set(named, "coefficient_1_K", known_1_K + values[0], errors[0]);
  });
}

Equation bus_equation(const Bench& bench) {
  const double open_V = bench.actuator().drive.bus_voltage_V;
  PlainBuilder builder("bus_voltage_V", "V", [open_V](const Signals& signals) {
    std::vector<double> left(signals.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = signals.bus_V[i] - open_V;
    return left;
  });
  // What the supply has without load is known to its charge only.
  builder.always(builder.add("open circuit", [](const Signals&, std::size_t) { return 1.0; }));
  const std::size_t current = builder.add(
      "bus current", [](const Signals& signals, std::size_t i) { return -signals.bus_A[i]; });
  builder.variant("voltage_sag", EffectFamily::kActuator, {current}, 0.0, kUnlimited);
  return builder.build(
      [](const Variant&, const Eigen::VectorXd& values, const Eigen::VectorXd& errors,
         NamedEffect& named) { set(named, "resistance_ohm", values[0], errors[0]); });
}

/// Logged velocity against d(position)/dt.
Equation velocity_equation(const Bench& bench) {
  PlainBuilder builder(bench.is_linear ? "linear_velocity_m_s" : "output_velocity_rad_s",
                       bench.is_linear ? "m/s" : "rad/s", [](const Signals& signals) {
                         std::vector<double> left(signals.size());
                         for (std::size_t i = 0; i < left.size(); ++i) {
                           left[i] = signals.logged_velocity_rad_s[i] - signals.at[i].speed_rad_s;
                         }
                         return left;
                       });
  const std::size_t scale = builder.add(
      "speed", [](const Signals& signals, std::size_t i) { return signals.at[i].speed_rad_s; });
  const std::size_t late = builder.add("acceleration", [](const Signals& signals, std::size_t i) {
    return -signals.at[i].acceleration_rad_s2;
  });
  builder.variant("velocity_mismatch", EffectFamily::kLog, {scale, late}, -kUnlimited, kUnlimited);
  return builder.build([](const Variant&, const Eigen::VectorXd& values,
                          const Eigen::VectorXd& errors, NamedEffect& named) {
    const double factor = 1.0 + values[0];
    set(named, "scale", factor, errors[0]);
    set(named, "delay_s", values[1] / factor, errors[1] / std::abs(factor));
  });
}

bool has(const std::vector<Signals>& signals, std::vector<double> Signals::*channel) {
  return !signals.empty() && !(signals.front().*channel).empty();
}

}  // namespace

std::vector<Equation> plain_equations(const Bench& bench, const std::vector<Signals>& signals) {
  std::vector<Equation> equations;
  if (has(signals, &Signals::twist_rad)) equations.push_back(twist_equation(bench));
  const bool has_current = bench.drive == Drive::kCurrent;
  if (has_current && has(signals, &Signals::voltage_V))
    equations.push_back(voltage_equation(bench));
  if (has(signals, &Signals::bus_V) && has(signals, &Signals::bus_A)) {
    equations.push_back(bus_equation(bench));
  }
  const bool has_position = has(signals, &Signals::logged_velocity_rad_s);
  if (has_position) equations.push_back(velocity_equation(bench));
  return equations;
}

}  // namespace torquewright::identification
