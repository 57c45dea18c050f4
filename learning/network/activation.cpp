// SPDX-License-Identifier: Apache-2.0
#include "learning/network/activation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace torquewright::learning {
namespace {

constexpr std::array<std::pair<std::string_view, ActivationKind>, 5> kNames{
    {{"identity", ActivationKind::kIdentity},
     {"relu", ActivationKind::kRelu},
     {"leaky_relu", ActivationKind::kLeakyRelu},
     {"elu", ActivationKind::kElu},
     {"tanh", ActivationKind::kTanh}}};

}  // namespace

Activation activation_of(ActivationKind kind) {
  if (kind == ActivationKind::kLeakyRelu) return {kind, 0.01};
  return {kind, kind == ActivationKind::kElu ? 1.0 : 0.0};
}

std::string_view name_of(ActivationKind kind) {
  const auto named = std::find_if(kNames.begin(), kNames.end(),
                                  [&](const auto& entry) { return entry.second == kind; });
  return named->first;
}

std::optional<ActivationKind> activation_named(std::string_view name) {
  for (const auto& [known, kind] : kNames) {
    if (known == name) return kind;
  }
  return std::nullopt;
}

double value_of(const Activation& activation, double x) {
  switch (activation.kind) {
    case ActivationKind::kIdentity:
      return x;
    case ActivationKind::kRelu:
      return std::max(x, 0.0);
    case ActivationKind::kLeakyRelu:
      return x > 0.0 ? x : activation.alpha * x;
    case ActivationKind::kElu:
      return x > 0.0 ? x : activation.alpha * std::expm1(x);
    case ActivationKind::kTanh:
      return std::tanh(x);
  }
  return x;
}

}  // namespace torquewright::learning
