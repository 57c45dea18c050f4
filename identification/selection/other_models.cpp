// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/other_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/selection/named.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

constexpr double kErrors = 2.0;  ///< Of a difference, beyond which it is not the noise's.

/// Whether two models' values differ by more than noise makes of them. Both are fitted to the same
/// noise: where the one of more freedom has a larger error, the difference's variance is that of
/// the one less that of the other (Hausman, Econometrica 46, 1978).
bool differ(const FoundNumber& own, const FoundNumber& other) {
  const double own2 = own.standard_error * own.standard_error;
  const double other2 = other.standard_error * other.standard_error;
  const double error = std::max(std::sqrt(std::abs(other2 - own2)), own.standard_error);
  return std::abs(other.value - own.value) > kErrors * error;
}

std::vector<std::string> not_in(const ModelFit& best, const ModelFit& other) {
  std::vector<std::string> effects;
  for (const EffectCandidate* each : other.members) {
    if (!best.holds(each->effect)) effects.push_back(each->effect);
  }
  return effects;
}

/// The value farthest from what was found, and where it comes from.
struct Farthest {
  double distance = 0.0;
  const FoundNumber* number = nullptr;
  const ModelFit* model = nullptr;
};

/// An effect in the other models.
struct Reading {
  const ModelFit* model;
  NamedEffect effect;
};

Farthest farthest_of(const FoundNumber& own, const std::vector<Reading>& readings) {
  Farthest farthest;
  for (const Reading& each : readings) {
    const FoundNumber* other = each.effect.parameters.find(own.name);
    if (other == nullptr || !(other->standard_error > 0.0) || !differ(own, *other)) continue;
    const double distance = std::abs(other->value - own.value);
    if (distance > farthest.distance) farthest = {distance, other, each.model};
  }
  return farthest;
}

std::vector<Reading> readings_of(const NamedEffect& named,
                                 const std::vector<const ModelFit*>& models, const ModelFit& best) {
  std::vector<Reading> readings;
  for (const ModelFit* model : models) {
    if (not_in(best, *model).empty()) continue;
    for (std::size_t m = 0; m < model->members.size(); ++m) {
      if (model->members[m]->effect == named.effect)
        readings.push_back({model, named_effect(*model, m)});
    }
  }
  return readings;
}

}  // namespace

void cover_other_models(const std::vector<const ModelFit*>& models, const ModelFit& best,
                        EquationResult& result) {
  for (NamedEffect& named : result.added) {
    if (!named.parameters.waves.empty()) continue;
    const std::vector<Reading> readings = readings_of(named, models, best);
    for (FoundNumber& own : named.parameters.numbers) {
      if (!(own.standard_error > 0.0)) continue;
      const Farthest farthest = farthest_of(own, readings);
      if (farthest.model == nullptr) continue;
      named.evidence += fmt::format(
          " Its {} is {:.4g} with {}, which the log does not rule out: the error covers both.",
          own.name, farthest.number->value, io::listed(not_in(best, *farthest.model)));
      own.standard_error = std::hypot(own.standard_error, farthest.distance);
    }
  }
}

}  // namespace torquewright::identification
