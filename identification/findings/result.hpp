// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "identification/findings/residual_structure.hpp"
#include "identification/findings/spectral_lines.hpp"
#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Root mean squares, in the equation's unit, in its band.
struct Errors {
  double train_rms = 0.0;
  double holdout_rms = 0.0;
};

/// Points to draw, in the order of time; a value that is not a number ends a line.
struct Curve {
  std::vector<double> time_s;  ///< Of a map without time: the sample.
  std::vector<double> value;
};

/// An equation in one run, in its band.
struct RunResult {
  std::string run;
  bool is_held_out = false;
  bool is_map = false;  ///< Without time.
  double rms_before = 0.0, rms_after = 0.0;
  /// Of many points the least and the greatest of equal shares of them, where they stand.
  Curve measured, stated, refined;
};

/// Whose property an effect is.
enum class EffectFamily { kActuator, kRig, kLog };
std::string_view name_of(EffectFamily family);

/// An effect that earned its place.
struct NamedEffect {
  std::string effect;
  EffectFamily family = EffectFamily::kActuator;
  nlohmann::ordered_json parameters;
  nlohmann::ordered_json standard_error;  ///< By the same keys.
  double holdout_rms_before = 0.0;        ///< Of the model with the effects before it.
  double holdout_rms_after = 0.0;
  std::string replaces;     ///< Stated effects that it takes the place of: "a, b".
  std::string evidence;     ///< A sentence.
  std::string doubt;        ///< Why it is not sure though no other is named for it; empty: nothing.
  bool is_refuted = false;  ///< The doubt is what the log itself says against it.
};

/// A value that the rig calls uncertain, as fitted.
struct Correction {
  std::string pointer;
  double stated = 0.0;
  double value = 0.0;
  double standard_error = 0.0;
};

/// Why an effect did not come in.
struct Rejection {
  std::string effect;
  std::string reason;
};

/// Effects that the log cannot tell apart.
struct Confounded {
  std::vector<std::string> effects;  ///< Of a group that is not exact the one that was added first.
  bool exact = false;                ///< Whatever the excitation on such a rig.
  std::string separated_by;
  std::string consequence;  ///< For the region, of each reading.
};

/// A set of effects that the log cannot tell from the one that was taken.
struct ModelWithinNoise {
  std::vector<NamedEffect> effects;  ///< Without evidence.
  Errors errors;
  std::string decided_by;  ///< What would tell it from the one that was taken; of that one: empty.
};

enum class Verdict { kExplained, kPartlyExplained, kUnexplained, kNothingMissing, kCannotTell };
std::string_view name_of(Verdict verdict);

/// What was found in one equation of one joint.
struct EquationResult {
  std::string joint;  ///< Empty unless a serial arm.
  std::string quantity;
  std::string unit;
  double band_Hz = 0.0;
  double noise_floor_rms = 0.0;
  Errors before, after;
  Errors with_certain;  ///< With what is certain of the actuator: what a refined document leaves.
  std::vector<NamedEffect> added;
  std::vector<Correction> corrected;
  std::vector<Rejection> rejected;
  std::vector<Confounded> confounded;
  std::vector<std::string> not_excited;
  std::vector<ResidualStructure> structure_before, structure_after;
  std::vector<RunResult> runs;           ///< None of what is simulated in windows.
  std::vector<ModelWithinNoise> models;  ///< The one that was taken, then those as good.
  std::vector<SpectralLine> lines;       ///< Of what is left, up to half the log's rate.
  bool is_noise_before = false;          ///< Nothing to explain.
  bool is_noise_after = false;
  bool has_tentative = false;  ///< Something helps, but no name is sure.
  std::string not_one_rig;     ///< Why the runs do not belong together; empty: they do.
  std::string unusable;        ///< Why nothing could be said; empty: something could.
  Verdict verdict = Verdict::kCannotTell;
};

/// Effects that were named, that no other may stand for, and that nothing speaks against.
std::vector<const NamedEffect*> certain_of(const EquationResult& result);

/// Whether no other effect, of the actuator, the rig or the log, may stand in the place of one that
/// was named, in this log or in any of such a rig, and nothing speaks against it. Others that mean
/// the same for the region are only other names.
bool is_certain(const EquationResult& result, const std::string& effect);

}  // namespace torquewright::identification
