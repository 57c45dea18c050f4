// SPDX-License-Identifier: Apache-2.0
// Cogging, ripple, and friction by position: harmonics of an angle.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/effects/families.hpp"

namespace torquewright::identification {
namespace {

/// What is faster, in samples' share of a period, would fold back into the band.
constexpr double kMostTurnsPerSample = 0.35;

enum class Angle { kMotor, kOutput };

/// Sine and cosine of an angle's multiple, times what `scale` says.
std::vector<Coefficient> wave(DictionaryBuilder& builder, const std::string& name, double order,
                              Angle angle, const PerSample& scale) {
  std::vector<Coefficient> coefficients;
  for (const double phase : {0.0, std::numbers::pi / 2.0}) {
    const std::size_t column =
        builder.add(name, [order, angle, phase, scale](const Signals& signals, std::size_t i) {
          const actuator::Instant& at = signals.at[i];
          const double angle_rad =
              angle == Angle::kMotor ? at.motor_angle_rad : at.output_angle_rad;
          return std::sin(order * angle_rad + phase) * scale(signals, i);
        });
    coefficients.push_back(one(column, -kInfinity, kInfinity));
  }
  return coefficients;
}

/// Without what comes near half the sampling rate. `ratio`: the angle's turns per output turn.
PerSample below_folding(double order, double ratio, PerSample scale) {
  return [order, ratio, scale = std::move(scale)](const Signals& signals, std::size_t i) {
    const double turns_Hz =
        std::abs(order * ratio * signals.at[i].speed_rad_s) / (2.0 * std::numbers::pi);
    const bool folds = signals.step_s > 0.0 && turns_Hz * signals.step_s > kMostTurnsPerSample;
    return folds ? 0.0 : scale(signals, i);
  };
}

/// Behind a whole ratio N, cogging of order k is a ripple of order k N: it has the former's name.
bool is_cogging_too(const DictionaryBuilder& builder, double order) {
  const double ratio = std::abs(builder.bench().actuator().transmission.ratio);
  if (ratio != std::floor(ratio)) return false;
  const std::vector<double>& motor = builder.orders().motor;
  return std::any_of(motor.begin(), motor.end(),
                     [&](double each) { return each * ratio == order; });
}

void add_cogging(DictionaryBuilder& builder, double order) {
  const double ratio = builder.bench().actuator().transmission.ratio;
  const auto gain = [balance = builder.balance()](const Signals& signals, std::size_t i) {
    return balance->gain(signals, i);
  };
  Variant& added = builder.variant("cogging_torque", wave(builder, "cogging", order, Angle::kMotor,
                                                          below_folding(order, ratio, gain)));
  added.order = order;
  added.of_motor_angle = true;
}

/// Once per turn of the output is a centre of mass that is not where the rig says.
void add_ripple(DictionaryBuilder& builder, double order) {
  const auto unit = [](const Signals&, std::size_t) { return 1.0; };
  builder
      .variant(order == 1.0 ? "gravity_imbalance" : "gear_ripple",
               wave(builder, "ripple", order, Angle::kOutput, below_folding(order, 1.0, unit)),
               order == 1.0 ? EffectFamily::kRig : EffectFamily::kActuator)
      .order = order;
}

void add_ripple_of_load(DictionaryBuilder& builder, double order) {
  const auto load = [](const Signals& signals, std::size_t i) {
    return signals.at[i].load_torque_Nm;
  };
  Variant& added = builder.variant(
      "gear_ripple",
      wave(builder, "ripple of load", order, Angle::kOutput, below_folding(order, 1.0, load)));
  added.order = order;
  added.proportional = true;
}

void add_friction_by_position(DictionaryBuilder& builder, double order) {
  const auto friction = [balance = builder.balance()](const Signals& signals, std::size_t i) {
    return -balance->gain(signals, i) * signals.at[i].direction;
  };
  builder
      .variant("position_dependent_friction",
               wave(builder, "friction by position", order, Angle::kOutput,
                    below_folding(order, 1.0, friction)))
      .order = order;
}

/// What the document states of dry friction, whose mean tight spots cannot exceed.
double stated_dry_friction_Nm(const DictionaryBuilder& builder) {
  for (const actuator::Effect& stated : builder.bench().actuator().effects) {
    for (const char* name : {"stribeck_friction", "asymmetric_friction", "presliding_friction"}) {
      if (stated.kind->name == name) return kInfinity;
    }
  }
  return builder.stated("coulomb_friction");
}

}  // namespace

void add_waves(DictionaryBuilder& builder) {
  for (const double order : builder.orders().motor) add_cogging(builder, order);
  for (const double order : builder.orders().output) {
    if (!is_cogging_too(builder, order)) add_ripple(builder, order);
  }
  for (const double order : builder.orders().load) add_ripple_of_load(builder, order);
  builder.set_stated_dry_friction_Nm(stated_dry_friction_Nm(builder));
  for (const double order : builder.orders().friction) add_friction_by_position(builder, order);
}

}  // namespace torquewright::identification
