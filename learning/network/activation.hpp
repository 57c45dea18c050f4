// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace torquewright::learning {

/// What stands behind a layer, entry by entry.
enum class ActivationKind {
  kIdentity,   ///< y = x
  kRelu,       ///< y = max(x, 0)
  kLeakyRelu,  ///< y = x above 0, alpha x below
  kElu,        ///< y = x above 0, alpha (exp(x) - 1) below
  kTanh,       ///< y = tanh(x)
};

struct Activation {
  ActivationKind kind = ActivationKind::kLeakyRelu;
  double alpha = 0.01;  ///< Of leaky ReLU (0.01 by custom) and ELU (1 by custom); others have none.

  friend bool operator==(const Activation&, const Activation&) = default;
};

/// The activation of that kind with its customary alpha.
Activation activation_of(ActivationKind kind);

/// Names in documents: identity, relu, leaky_relu, elu, tanh.
std::string_view name_of(ActivationKind kind);
std::optional<ActivationKind> activation_named(std::string_view name);

/// Value at x.
double value_of(const Activation& activation, double x);

}  // namespace torquewright::learning
