// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "actuator/effects/library.hpp"
#include "identification/balance.hpp"
#include "identification/dictionary.hpp"

namespace torquewright::identification {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A column's value at one sample, in Nm of the residual per unit of its coefficient.
using PerSample = std::function<double(const Signals&, std::size_t)>;

/// What a family of effects needs to write its columns and variants into a dictionary. Families are
/// asked in the order of their list; a later one may use the columns of an earlier one.
class DictionaryBuilder {
 public:
  DictionaryBuilder(const Bench& bench, const Extent& extent, const Orders& orders);

  const Bench& bench() const { return bench_; }
  const Extent& extent() const { return extent_; }
  const Orders& orders() const { return orders_; }
  const std::shared_ptr<Balance>& balance() const { return balance_; }

  /// Each adds one column and returns its index: of a value per sample; of a whole stretch at once;
  /// of an effect's law (a torque before the mesh) as it enters the residual; of drag, whose level
  /// may follow temperature, with its product with T - T0 beside it where the log has one.
  std::size_t add(std::string name, PerSample value);
  std::size_t add_stretch(std::string name,
                          std::function<void(const Signals&, std::vector<double>&)> fill);
  std::size_t add_law(const std::string& name, actuator::Effect effect);
  std::size_t add_drag(const std::string& name, const actuator::Effect& effect);

  /// Adds a variant; the reference stands until the next one is added.
  Variant& variant(const std::string& effect, std::vector<Coefficient> coefficients,
                   EffectFamily family = EffectFamily::kActuator);

  /// A parameter of an effect that the document states; 0 where it does not.
  double stated(std::string_view name, std::size_t parameter = 0) const;

  /// Coulomb friction's column, which others take the place of.
  std::size_t coulomb = 0;
  /// Column of the drag that the document states times T - T0.
  void set_nominal_drag_warmed(std::size_t column) { dictionary_.nominal_drag_warmed = column; }

  void set_stated_dry_friction_Nm(double level_Nm) {
    dictionary_.stated_dry_friction_Nm = level_Nm;
  }

  Dictionary take() { return std::move(dictionary_); }

 private:
  std::shared_ptr<Balance> balance_;
  Bench bench_;
  Extent extent_;
  Orders orders_;
  Dictionary dictionary_;
};

/// A coefficient of one column between limits.
Coefficient one(std::size_t column, double lowest, double highest);

/// A coefficient of one column that may not make less than nothing of what is stated, up to a slack
/// for the fit's own error.
Coefficient beyond(std::size_t column, double stated);

/// What a fit may take away of a stated value: all of it and its own error.
Coefficient takes_away(std::size_t column, double stated);

/// An effect of the actuator's library with these parameters, in the library's order and units.
actuator::Effect effect_with(std::string_view name, std::vector<double> values);

/// `count` values (at least 2) from `from` to `to`, both positive, in equal ratios.
std::vector<double> geometric(double from, double to, int count);

}  // namespace torquewright::identification
