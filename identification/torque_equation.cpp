// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <memory>

#include "actuator/region/torque_at.hpp"
#include "dynamics/serial_arm.hpp"
#include "identification/equation.hpp"
#include "identification/load_model.hpp"
#include "identification/uncertain.hpp"

namespace torquewright::identification {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kMostInverse = 0.97;  ///< A constant 30 times the stated one, and no more.
constexpr const char* kTorqueConstant = "/motor/torque_constant_Nm_A";
constexpr const char* kResistance = "/motor/resistance_ohm";

/// A bench of its own documents, in which a value can be changed.
struct OwnBench {
  Rig rig;
  std::vector<actuator::Actuator> actuators;
  Bench bench;

  explicit OwnBench(const Bench& other) : rig(*other.rig), bench(other) {
    for (const actuator::Actuator* each : other.actuators) actuators.push_back(*each);
    bench.rig = &rig;
    bench.actuators.clear();
    for (const actuator::Actuator& each : actuators) bench.actuators.push_back(&each);
  }
  double* value(const std::string& pointer) {
    return value_at(pointer, rig, actuators[bench.joint]);
  }
};

/// What one unit more of an uncertain value does to the residual, by a difference. The load's side
/// is its model's derivative; what the actuator states enters the balance itself.
class Sensitivity {
 public:
  Sensitivity(const Bench& bench, std::string pointer)
      : stated_(std::make_shared<OwnBench>(bench)),
        moved_(std::make_shared<OwnBench>(bench)),
        pointer_(std::move(pointer)) {
    double* value = moved_->value(pointer_);
    step_ = 1e-4 * std::max(std::abs(*value), 1e-6);
    *value += step_;
  }

  void operator()(const Signals& signals, std::vector<double>& out) const {
    const Balance stated(stated_->bench), moved(moved_->bench);
    if (is_of_load(pointer_)) return load_column(signals, stated, out);
    for (std::size_t i = 0; i < signals.size(); ++i) {
      out[i] = -(moved.residual_Nm(signals, i) - stated.residual_Nm(signals, i)) / step_;
    }
  }

 private:
  /// Residual = measured or needed load less ...: the load's side counts before the mesh.
  void load_column(const Signals& signals, const Balance& balance, std::vector<double>& out) const {
    Signals there = signals;
    const std::size_t joint = stated_->bench.joint;
    const std::vector<double> before = model_load_Nm(stated_->rig, joint, signals);
    const std::vector<double> after = model_load_Nm(moved_->rig, joint, signals);
    for (std::size_t i = 0; i < signals.size(); ++i) {
      const double change = (after[i] - before[i]) / step_;
      // The model takes more: the residual, needed less motor, would have been larger by that.
      there.load_side_Nm[i] = signals.load_side_Nm[i] + change;
      out[i] = -(balance.residual_Nm(there, i) - balance.residual_Nm(signals, i));
    }
  }

  std::shared_ptr<OwnBench> stated_, moved_;
  std::string pointer_;
  double step_ = 0.0;
};

/// Where the motor's side is the target, its residual holds the inverse of the torque constant.
bool is_inverse_of(const std::string& pointer, const Balance& balance) {
  return pointer == kTorqueConstant && !balance.is_sensor();
}

}  // namespace

Equation torque_equation(const Bench& bench, const Extent& extent, const Orders& orders) {
  const auto balance = std::make_shared<Balance>(bench);
  Equation equation;
  equation.quantity = name_of(balance->quantity());
  equation.unit = unit_of(balance->quantity());
  if (balance->quantity() == Quantity::kWindingVoltage) equation.unit = "V";
  equation.unit_per_target = balance->unit_per_Nm();
  equation.target = [bench](const Signals& signals) { return torque_residual(bench, signals); };
  equation.dictionary = torque_dictionary(bench, extent, orders);
  equation.target_is_motor_side = !balance->is_sensor();
  equation.is_free_load =
      bench.load_side == LoadSide::kModel && bench.rig->load.type == LoadType::kFree;
  OwnBench documents(bench);
  for (const std::string& pointer : bench.rig->uncertain) {
    double* value = documents.value(pointer);
    if (value == nullptr) continue;
    const bool is_model_load = bench.load_side == LoadSide::kModel;
    if (is_of_load(pointer) && !is_model_load) continue;
    if (pointer == kResistance && bench.drive != Drive::kVoltage) continue;
    Column column{pointer, nullptr};
    if (pointer == kTorqueConstant || (pointer == kResistance && is_model_load)) {
      // Its derivative holds the measured current: what the load needs stands in its place.
      const double stated = *value;
      const bool is_resistance = pointer == kResistance;
      column.fill = [balance, stated, is_resistance](const Signals& signals,
                                                     std::vector<double>& out) {
        for (std::size_t i = 0; i < out.size(); ++i) {
          const double slope_Nm = is_resistance
                                      ? -balance->gain(signals, i) * balance->driven_Nm(signals, i)
                                      : balance->of_torque_constant_Nm(signals, i);
          out[i] = slope_Nm / stated;
        }
      };
    } else {
      column.fill = Sensitivity(bench, pointer);
    }
    equation.dictionary.columns.push_back(std::move(column));
    // No mass, inertia, constant or ratio changes its sign.
    const double most_down =
        *value > 0.0 && !is_inverse_of(pointer, *balance) ? -*value : -kUnlimited;
    // A motor-side residual holds the stated over the true constant: the change is bounded above.
    const double most_up = is_inverse_of(pointer, *balance) ? kMostInverse * *value
                           : *value < 0.0                   ? -*value
                                                            : kUnlimited;
    equation.always.push_back(
        {{{equation.dictionary.columns.size() - 1, 1.0}}, most_down, most_up});
    equation.corrections.push_back({pointer, *value, *value, 0.0});
  }
  // A value that is fitted anyway stands for the effect of the same meaning.
  const auto is_uncertain = [&](const char* pointer) {
    for (const Correction& each : equation.corrections) {
      if (each.pointer == pointer) return true;
    }
    return false;
  };
  std::erase_if(equation.dictionary.variants, [&](const Variant& variant) {
    if (variant.effect == "torque_constant_error") return is_uncertain(kTorqueConstant);
    // Driving less back-driving load friction is the load itself: beside an open torque constant
    // the sum of the two coefficients is all that a log can hold, and half of it stands for each.
    const bool is_one_way = variant.effect == "load_dependent_friction" &&
                            variant.shape != std::vector<std::vector<double>>{{1.0}};
    if (is_one_way && is_uncertain(kTorqueConstant)) return true;
    if (variant.effect == "reflected_inertia") {
      return is_uncertain("/motor/rotor_inertia_kg_m2") || is_uncertain("/load/inertia_kg_m2");
    }
    return false;
  });
  equation.name = [balance, variants = equation.dictionary.variants](const Fit& fit) {
    Dictionary only;
    only.variants = variants;
    return named_effects(fit, only, count_always(fit, variants), *balance);
  };
  return equation;
}

}  // namespace torquewright::identification
