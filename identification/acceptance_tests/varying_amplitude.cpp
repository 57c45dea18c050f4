// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "identification/acceptance_tests/acceptance_test.hpp"

namespace torquewright::identification {
namespace {

constexpr double kAmplitudeGain = 0.15;  ///< A name whose amplitude varies wins more than this,
constexpr double kAmplitudeT = 3.0;      ///< beyond so many errors of it.

struct Modulation {
  const char* name;
  double (*value)(const Signals&, std::size_t);
};

const Modulation kModulations[] = {
    {"output_velocity_rad_s",
     [](const Signals& s, std::size_t i) { return std::abs(s.at[i].speed_rad_s); }},
    {"load_torque_Nm",
     [](const Signals& s, std::size_t i) { return std::abs(s.at[i].load_torque_Nm); }},
    {"winding_temperature_K",
     [](const Signals& s, std::size_t i) {
       return s.at[i].winding_temperature_K - s.at[i].reference_temperature_K;
     }},
    {"time_s", [](const Signals& s, std::size_t i) { return s.time_s[i]; }},
    {"the current's sign",
     [](const Signals& s, std::size_t i) { return s.at[i].current_A > 0.0 ? 1.0 : -1.0; }},
};

/// What a member adds, as one column at its fitted values.
Column contribution(const Fit& fit, const Dictionary& dictionary, std::size_t first,
                    std::size_t count, double (*modulation)(const Signals&, std::size_t)) {
  return {"", [&fit, &dictionary, first, count, modulation](const Signals& signals,
                                                            std::vector<double>& out) {
            std::fill(out.begin(), out.end(), 0.0);
            std::vector<double> part(out.size());
            for (std::size_t j = first; j < first + count; ++j) {
              for (const auto& term : fit.coefficients[j].terms) {
                dictionary.columns[term.column].fill(signals, part);
                const double weight = term.weight * fit.values[static_cast<Eigen::Index>(j)];
                for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight * part[i];
              }
            }
            if (modulation == nullptr) return;
            for (std::size_t i = 0; i < out.size(); ++i) out[i] *= modulation(signals, i);
          }};
}

/// The model's coefficients one by one as they were fitted, as what is always there; and a member's
/// contribution times each modulation, as what may be added.
struct Modulated {
  Dictionary dictionary;
  std::vector<Coefficient> always;

  Modulated(const Fitter& fitter, const Fit& model, std::size_t member) {
    const Dictionary& whole = fitter.dictionary();
    for (std::size_t j = 0; j < model.coefficients.size(); ++j) {
      always.push_back(open(contribution(model, whole, j, 1, nullptr)));
    }
    const std::size_t first = model.first_of_member(whole, member, fitter.always_count());
    const std::size_t count = whole.variants[model.members[member]].coefficients.size();
    for (const Modulation& modulation : kModulations) {
      Variant variant;
      variant.effect = modulation.name;
      variant.coefficients = {open(contribution(model, whole, first, count, modulation.value))};
      dictionary.variants.push_back(variant);
    }
  }

 private:
  Coefficient open(Column column) {
    dictionary.columns.push_back(std::move(column));
    return {{{dictionary.columns.size() - 1, 1.0}}, -1e300, 1e300};
  }
};

}  // namespace

std::string varying_amplitude(const EquationFit& fit, const Fit& model, std::size_t member,
                              const std::vector<ResidualStructure>& /*left*/) {
  if (is_nearly_noise(fit, model)) return "";
  const Fitter& fitter = fit.fitter();
  const Modulated modulated(fitter, model, member);
  const Gram gram =
      build_gram(fit.source(), false, modulated.dictionary, fit.equation().target, fit.band());
  if (gram.blocks.size() != fitter.folds().size()) return "";
  const Fitter trial(gram, modulated.dictionary, fitter.folds(), modulated.always);
  const Fit plain = trial.fit({});
  if (!plain.is_valid) return "";
  for (std::size_t v = 0; v < modulated.dictionary.variants.size(); ++v) {
    const Fit with = trial.fit({v});
    if (!with.is_valid) continue;
    const Gain gain = gain_of(trial, plain, with);
    if (gain.share > kAmplitudeGain && gain.t > kAmplitudeT) {
      return fmt::format(
          "its size varies with {}: letting it do so removes another {:.0f} % of what is left, so "
          "the log shows something else than this effect",
          modulated.dictionary.variants[v].effect, 100.0 * gain.share);
    }
  }
  return "";
}

}  // namespace torquewright::identification
