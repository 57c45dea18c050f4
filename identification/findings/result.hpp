// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "identification/findings/found_parameters.hpp"
#include "identification/findings/residual_structure.hpp"
#include "identification/findings/spectral_lines.hpp"
#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Root mean squares of the residual, in the equation's unit and band.
struct Errors {
  double train_rms = 0.0;
  double holdout_rms = 0.0;
};

/// Points to draw in the order of time; a value that is not a number ends a line.
struct Curve {
  std::vector<double> time_s;  ///< Time; in a map without time the sample's number.
  std::vector<double> value;
};

/// An equation in one run, in its band.
struct RunResult {
  std::string run;
  bool is_held_out = false;
  bool is_map = false;  ///< The run is a map without time.
  double rms_before = 0.0, rms_after = 0.0;
  /// Measured and predicted values. A curve of many points is thinned to the least and the greatest
  /// of equal shares.
  Curve measured, stated, refined;
  Curve left_before, left_after;  ///< Measured less predicted, likewise.
};

/// What an effect is a property of: the actuator, the rig or the log.
enum class EffectFamily { kActuator, kRig, kLog };
std::string_view name_of(EffectFamily family);

/// An effect that earned its place.
struct NamedEffect {
  std::string effect;
  EffectFamily family = EffectFamily::kActuator;
  FoundParameters parameters;
  /// Held-out error of the model with the effects before this one.
  double holdout_rms_before = 0.0;
  double holdout_rms_after = 0.0;
  std::string replaces;  ///< Names of stated effects that it replaces: "a, b".
  std::string evidence;  ///< A sentence that says why it was added.
  /// Why it is not sure although no other effect competes with it; empty: no doubt.
  std::string doubt;
  bool is_refuted = false;  ///< The log itself speaks against it: that is the doubt.
};

/// A value that the rig calls uncertain, as it was fitted.
struct Correction {
  std::string pointer;
  double stated = 0.0;
  double value = 0.0;
  double standard_error = 0.0;
};

/// Why an effect was not added.
struct Rejection {
  std::string effect;
  std::string reason;
};

/// Effects that the log cannot tell apart.
struct Confounded {
  /// Names; in a group that is not exact the one that was added comes first.
  std::vector<std::string> effects;
  bool exact = false;  ///< They cannot be told apart by any excitation on such a rig.
  std::string separated_by;
  std::string consequence;  ///< What each reading would mean for the region.
};

/// A set of effects that the log cannot tell from the one that was taken.
struct ModelWithinNoise {
  std::vector<NamedEffect> effects;  ///< The effects, without their evidence.
  Errors errors;
  /// What would tell this model from the one that was taken; empty for that one.
  std::string decided_by;
};

/// Errors that a refined document with these effects is to leave.
struct Promise {
  std::vector<std::string> effects;
  Errors errors;
};

enum class Verdict { kExplained, kPartlyExplained, kUnexplained, kNothingMissing, kCannotTell };
std::string_view name_of(Verdict verdict);

/// What was found in one equation of one joint.
struct EquationResult {
  std::string joint;  ///< Name of the joint; empty unless the rig is a serial arm.
  std::string quantity;
  std::string unit;
  double band_Hz = 0.0;
  double noise_floor_rms = 0.0;
  Errors before, after;
  Errors with_certain;  ///< Errors with only what is certain of the actuator.
  Promise promise;      ///< What a refined document leaves.
  std::vector<NamedEffect> added;
  std::vector<Correction> corrected;
  std::vector<Rejection> rejected;
  std::vector<Confounded> confounded;
  std::vector<std::string> not_excited;
  std::vector<ResidualStructure> structure_before, structure_after;
  std::vector<RunResult> runs;  ///< The runs; empty for an equation that is simulated in windows.
  std::vector<ModelWithinNoise> models;  ///< The model that was taken, then those that are as good.
  /// Lines in the spectrum of the residual, up to half the log's rate.
  std::vector<SpectralLine> lines;
  /// The stated model leaves noise alone: there is nothing to explain.
  bool is_noise_before = false;
  bool is_noise_after = false;
  bool has_tentative = false;  ///< An effect helps, but no name is sure.
  std::string not_one_rig;     ///< Why the runs do not belong to one rig; empty if they do.
  std::string unusable;        ///< Why nothing could be said; empty if something could.
  Verdict verdict = Verdict::kCannotTell;
};

/// Returns the named effects that no other may stand for and that nothing speaks against.
std::vector<const NamedEffect*> certain_of(const EquationResult& result);

/// Whether no other effect, of the actuator, the rig or the log, may stand in the place of one that
/// was named, in this log or in any of such a rig, and nothing speaks against it. Others that mean
/// the same for the region are only other names.
bool is_certain(const EquationResult& result, const std::string& effect);

}  // namespace torquewright::identification
