// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/equation.hpp"
#include "identification/folds.hpp"
#include "identification/result.hpp"
#include "identification/signal_source.hpp"

namespace torquewright::identification {

/// One equation over one log: its Gram, its folds, and what can be asked of a fit to them. Keeps a
/// reference to the source, and references within itself: it does not move.
class EquationFit {
 public:
  EquationFit(const Log& log, Equation equation, const SignalSource& source);
  EquationFit(const EquationFit&) = delete;
  EquationFit& operator=(const EquationFit&) = delete;

  const Equation& equation() const { return equation_; }
  const Fitter& fitter() const { return fitter_; }
  const BandOptions& band() const { return band_; }
  const SignalSource& source() const { return source_; }
  const Folds& folds() const { return folds_; }

  /// Blocks that may be fitted.
  std::size_t training_blocks() const;

  /// Uncertain values that this log cannot tell stay as stated.
  void drop_undetermined();

  /// Enough of a variant's power is its own and not noise.
  bool is_excited(std::size_t variant) const;
  std::vector<std::size_t> excited_variants() const;

  /// Of a valid fit, in the equation's unit: errors with the noise in them, and the noise alone.
  Errors errors(const Fit& fit) const;
  double noise_floor_rms(const Fit& fit) const;

  /// The noise as a loss over the blocks that may be fitted: in the target's unit, squared, summed.
  double floor_loss(const Fit& fit) const;

  /// What a valid fit leaves along each coordinate.
  std::vector<ResidualStructure> structure(const Fit& fit) const;

  /// True if nothing but noise is left.
  bool is_noise(const Fit& fit, const std::vector<ResidualStructure>& structure) const;

 private:
  Equation equation_;
  const SignalSource& source_;
  BandOptions band_;
  Gram gram_;
  Folds folds_;
  Fitter fitter_;
};

}  // namespace torquewright::identification
