// SPDX-License-Identifier: Apache-2.0
#include "identification/equation_fit.hpp"

#include <algorithm>
#include <cmath>

#include "identification/residual_traces.hpp"

namespace torquewright::identification {
namespace {

constexpr double kNoise = 2.5;          ///< Times the floor in squares: noise.
constexpr double kAtFloor = 1.25;       ///< As good as the floor itself.
constexpr double kHeldOutFloors = 2.0;  ///< Rms of noise, at most, in runs that no fit saw.

}  // namespace

EquationFit::EquationFit(const Log& log, Equation equation, const SignalSource& source)
    : equation_(std::move(equation)),
      source_(source),
      gram_(build_gram(source, true, equation_.dictionary, equation_.target, band_)),
      folds_(make_folds(log, gram_)),
      fitter_(gram_, equation_.dictionary, folds_.of_block, equation_.always) {}

std::size_t EquationFit::training_blocks() const {
  return static_cast<std::size_t>(
      std::count_if(folds_.of_block.begin(), folds_.of_block.end(),
                    [](std::size_t fold) { return fold != Fitter::kNoFold; }));
}

void EquationFit::drop_undetermined() {
  std::vector<Coefficient> kept;
  std::vector<Correction> corrections;
  for (std::size_t k = 0; k < equation_.always.size(); ++k) {
    kept.push_back(equation_.always[k]);
    const Fitter trial(gram_, equation_.dictionary, folds_.of_block, kept);
    if (!trial.fit({}).is_valid) {
      kept.pop_back();
      continue;
    }
    if (k < equation_.corrections.size()) corrections.push_back(equation_.corrections[k]);
  }
  equation_.always = kept;
  equation_.corrections = corrections;
  fitter_.set_always(kept);
}

bool EquationFit::is_excited(std::size_t variant) const {
  const Variant& asked = equation_.dictionary.variants[variant];
  if (asked.scales_friction) return true;
  for (const Coefficient& coefficient : asked.coefficients) {
    for (const auto& term : coefficient.terms) {
      if (!gram_.is_usable[term.column]) return false;
    }
  }
  return true;
}

std::vector<std::size_t> EquationFit::excited_variants() const {
  std::vector<std::size_t> excited;
  for (std::size_t v = 0; v < equation_.dictionary.variants.size(); ++v) {
    if (is_excited(v)) excited.push_back(v);
  }
  return excited;
}

Errors EquationFit::errors(const Fit& fit) const {
  const double noise = fitter_.noise_loss(fit);
  const auto rms = [&](bool held_out) {
    const double samples = fitter_.samples(held_out);
    if (samples == 0.0) return 0.0;
    return std::sqrt(std::max(0.0, fitter_.loss_on(fit, held_out) / samples + noise)) *
           std::abs(equation_.unit_per_target);
  };
  return {rms(false), rms(true)};
}

double EquationFit::noise_floor_rms(const Fit& fit) const {
  return std::sqrt(fitter_.noise_loss(fit)) * std::abs(equation_.unit_per_target);
}

double EquationFit::floor_loss(const Fit& fit) const {
  return fitter_.noise_loss(fit) * fitter_.samples(false);
}

std::vector<ResidualStructure> EquationFit::structure(const Fit& fit) const {
  return residual_structures(residual_traces(equation_, fit, source_.rows(), folds_, band_));
}

bool EquationFit::is_noise(const Fit& fit, const std::vector<ResidualStructure>& structure) const {
  if (errors(fit).holdout_rms > kHeldOutFloors * noise_floor_rms(fit)) return false;
  // At the floor itself coordinates share the channels' noise: tables say nothing there.
  const double floor = floor_loss(fit);
  if (fit.loss + floor <= kAtFloor * floor) return true;
  if (fit.loss + floor > kNoise * floor) return false;
  return std::none_of(structure.begin(), structure.end(),
                      [](const ResidualStructure& each) { return is_significant(each); });
}

}  // namespace torquewright::identification
