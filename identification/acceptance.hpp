// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/model.hpp"

namespace torquewright::identification {

/// What an addition has to show on data that were left out of its fit.
/// docs/derivations/identification.md section 4; the numbers lie on plateaus (ibid.).
struct AcceptanceRules {
  double least_t = 3.0;
  double least_gain = 0.08;       ///< Share of the loss that it removes.
  double least_harmonic = 0.03;   ///< The same of a further harmonic of an effect that is there.
  double least_run_errors = 1.5;  ///< Gain in a run, in its standard errors, for it to count.
  double least_run_share = 0.4;   ///< Of the runs in which it has to count; two at least.
  double worse_run_errors = 1.0;  ///< A run is worse if the loss grows by more than this ...
  double worse_run_share = 0.02;  ///< ... and by more than this share.
};

/// The rules for what `with` has beyond `without`. A further harmonic of an effect adds no name and
/// shares the others' cause: of its gain less is asked, of chance the same.
AcceptanceRules rules_for(const Dictionary& dictionary, const Members& without, const Members& with,
                          AcceptanceRules rules = {});

/// How much better `with` is than `without`, where both were left out of the fit.
struct Gain {
  double loss = 0.0;   ///< Reduction; negative: it got worse.
  double share = 0.0;  ///< Of the loss without.
  double error = 0.0;  ///< Standard error of the reduction, autocorrelation respected.
  double t = 0.0;
  std::size_t folds_better = 0;
  std::size_t folds_worse = 0;
  std::size_t folds = 0;
};
Gain gain_of(const Fitter& fitter, const Fit& without, const Fit& with,
             const AcceptanceRules& rules = {});

/// Empty if the addition is accepted; else why not, a sentence for a person.
std::string objection(const Fit& with, const Gain& gain, const AcceptanceRules& rules = {});

}  // namespace torquewright::identification
