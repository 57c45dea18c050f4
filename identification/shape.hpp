// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "identification/balance.hpp"
#include "identification/dictionary.hpp"

namespace torquewright::identification {

/// A parameter that an effect's law depends on in a curved way: found by a search, where the
/// regression knows a grid only.
struct ShapeParameter {
  std::string name;  ///< As in the contract; for presliding the length coulomb over stiffness.
  double lowest = 0.0;
  double highest = 0.0;
  double start = 0.0;
  /// Over which its derivative is taken, relative. Wide where single events move the residual.
  double difference_step = 1e-3;
};

/// The shape of one effect in one log, empty where its law is linear in all its parameters. `start`
/// comes from the variant's grid values.
std::vector<ShapeParameter> shape_parameters(const Variant& variant,
                                             const std::vector<double>& weights,
                                             const Extent& extent);

/// What the effect adds at that shape: per unit of its coefficient, or, where there is none left
/// (saturation, lag), all of it.
Column shaped_column(const std::shared_ptr<const Balance>& balance, const std::string& effect,
                     const std::vector<double>& shape);

/// True where the shape says everything, so that nothing linear remains.
bool is_all_shape(const std::string& effect);

}  // namespace torquewright::identification
