// SPDX-License-Identifier: Apache-2.0
#include "identification/effects/dictionary_builder.hpp"

#include <cmath>
#include <utility>

namespace torquewright::identification {
namespace {

/// A fit may undercut what is stated by its own error.
constexpr double kStatedSlack = 1.2;

}  // namespace

DictionaryBuilder::DictionaryBuilder(const Bench& bench, const Extent& extent, const Orders& orders)
    : balance_(std::make_shared<Balance>(bench)), bench_(bench), extent_(extent), orders_(orders) {}

std::size_t DictionaryBuilder::add(std::string name, PerSample value) {
  return add_stretch(std::move(name),
                     [value = std::move(value)](const Signals& signals, std::vector<double>& out) {
                       for (std::size_t i = 0; i < signals.size(); ++i) out[i] = value(signals, i);
                     });
}

std::size_t DictionaryBuilder::add_stretch(
    std::string name, std::function<void(const Signals&, std::vector<double>&)> fill) {
  dictionary_.columns.push_back({std::move(name), std::move(fill)});
  return dictionary_.columns.size() - 1;
}

std::size_t DictionaryBuilder::add_law(const std::string& name, actuator::Effect effect) {
  return add(name, [balance = balance_, effect = std::move(effect)](const Signals& signals,
                                                                    std::size_t i) {
    return balance->gain(signals, i) * effect.kind->law(effect, signals.at[i]);
  });
}

std::size_t DictionaryBuilder::add_drag(const std::string& name, const actuator::Effect& effect) {
  const std::size_t column = add_law(name, effect);
  if (!bench_.has_temperature) return column;
  const auto value = [balance = balance_, effect](const Signals& signals, std::size_t i) {
    const actuator::Instant& at = signals.at[i];
    return balance->gain(signals, i) * effect.kind->law(effect, at) *
           (at.winding_temperature_K - at.reference_temperature_K);
  };
  dictionary_.warmed.emplace_back(column, add(name + " times T", value));
  return column;
}

Variant& DictionaryBuilder::variant(const std::string& effect,
                                    std::vector<Coefficient> coefficients, EffectFamily family) {
  Variant added;
  added.effect = effect;
  added.family = family;
  added.coefficients = std::move(coefficients);
  dictionary_.variants.push_back(std::move(added));
  return dictionary_.variants.back();
}

double DictionaryBuilder::stated(std::string_view name, std::size_t parameter) const {
  double sum = 0.0;
  for (const actuator::Effect& effect : bench_.actuator().effects) {
    if (effect.kind->name == name) sum += effect.values[parameter];
  }
  return sum;
}

Coefficient one(std::size_t column, double lowest, double highest) {
  return {{{column, 1.0}}, lowest, highest};
}

Coefficient beyond(std::size_t column, double stated) {
  return one(column, stated > 0.0 ? -kStatedSlack * stated : 0.0, kInfinity);
}

Coefficient takes_away(std::size_t column, double stated) {
  return one(column, -kStatedSlack * stated, 0.0);
}

actuator::Effect effect_with(std::string_view name, std::vector<double> values) {
  actuator::Effect effect = actuator::neutral(*actuator::find_effect(name));
  effect.values = std::move(values);
  return effect;
}

std::vector<double> geometric(double from, double to, int count) {
  std::vector<double> grid;
  for (int k = 0; k < count; ++k) {
    grid.push_back(from * std::pow(to / from, static_cast<double>(k) / (count - 1)));
  }
  return grid;
}

}  // namespace torquewright::identification
