// SPDX-License-Identifier: Apache-2.0
#include "identification/equation_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "identification/confident_search.hpp"
#include "identification/confounded_groups.hpp"
#include "identification/correction.hpp"
#include "identification/equation_fit.hpp"
#include "identification/one_rig.hpp"
#include "identification/refinement.hpp"
#include "identification/starts.hpp"
#include "identification/trials.hpp"
#include "identification/verdict.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kLeastBlocks = 6;  ///< In training, to say anything.

/// Why nothing can be said of an equation; empty, and a valid empty model, if something can.
std::string obstacle(EquationFit& fit, Fit& empty) {
  const std::size_t training = fit.training_blocks();
  if (training < kLeastBlocks) {
    return fmt::format("{} blocks of {:g} s can be fitted; {} are needed: a longer log", training,
                       fit.band().block_s, kLeastBlocks);
  }
  empty = fit.fitter().fit({});
  if (empty.is_valid) return "";
  fit.drop_undetermined();
  empty = fit.fitter().fit({});
  return empty.is_valid ? ""
                        : "the values that are called uncertain are not determined by this log";
}

std::string evidence_of(const Gain& gain) {
  return fmt::format(
      "It removes {:.0f} % of the squared error where it was not fitted, {:.1f} standard errors; "
      "it helps in {} of {} parts.",
      100.0 * std::min(1.0, gain.share), gain.t, gain.folds_better, gain.folds);
}

/// Members are in the order of their gain; an effect of several takes the last one's place.
void name_effects(const EquationFit& fit, const Selection& selection, EquationResult& result) {
  if (selection.model.members.empty()) return;
  Errors last = fit.errors(selection.empty);
  std::vector<Named> named = fit.equation().name(selection.model);
  std::stable_sort(named.begin(), named.end(), [](const Named& a, const Named& b) {
    return a.members.back() < b.members.back();
  });
  for (Named& each : named) {
    NamedEffect& effect = each.effect;
    const Errors after = fit.errors(selection.path[each.members.back()]);
    effect.gain = selection.gains[each.members.front()];
    effect.holdout_rms_before = last.holdout_rms;
    effect.holdout_rms_after = after.holdout_rms;
    effect.evidence = evidence_of(effect.gain);
    last = after;
    result.added.push_back(std::move(effect));
  }
}

void add_groups(const Bench& bench, const std::vector<Signals>& signals, const Selection& selection,
                EquationResult& result) {
  const auto add = [&](std::optional<Confounded> group) {
    if (group) result.confounded.push_back(*std::move(group));
  };
  for (const Group& group : selection.groups) add(alike_in_log(bench, group));
  for (const NamedEffect& effect : result.added) {
    add(alike_on_rig(bench, effect.effect));
    add(alike_when_fast(bench, signals, effect.effect));
  }
}

/// True if the log moves a variant's columns, whatever is fitted beside them.
bool is_moved(const EquationFit& fit, const Fit& model, std::size_t v) {
  if (!fit.is_excited(v)) return false;
  const Variant& variant = fit.equation().dictionary.variants[v];
  if (variant.scales_friction || variant.coefficients.size() != 1) return true;
  if (std::find(model.members.begin(), model.members.end(), v) != model.members.end()) return true;
  return fit.fitter().is_determined(plus_one(model.members, v));
}

/// Effects none of whose variants is moved, by name.
std::vector<std::string> not_excited(const EquationFit& fit, const Fit& model) {
  const std::vector<Variant>& variants = fit.equation().dictionary.variants;
  std::set<std::string> seen, silent;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    (is_moved(fit, model, v) ? seen : silent).insert(variants[v].effect);
  }
  std::vector<std::string> effects;
  for (const std::string& effect : silent) {
    if (seen.count(effect) == 0) effects.push_back(effect);
  }
  return effects;
}

/// Errors and structure with the model's effects in it.
void describe_after(const EquationFit& fit, const Selection& selection, EquationResult& result) {
  const Fit& model = selection.model;
  const bool is_empty = model.members.empty();
  result.after = fit.errors(model);
  result.noise_floor_rms = fit.noise_floor_rms(model);
  result.structure_after = is_empty ? result.structure_before : fit.structure(model);
  result.is_noise_before = is_empty && fit.is_noise(selection.empty, result.structure_before);
  result.is_noise_after = fit.is_noise(model, result.structure_after);
}

/// True if the log shows another law as well in the place of this one.
bool is_ambiguous(const EquationResult& result, const std::string& effect) {
  return std::any_of(result.confounded.begin(), result.confounded.end(), [&](const auto& group) {
    return !group.exact &&
           std::find(group.effects.begin(), group.effects.end(), effect) != group.effects.end();
  });
}

/// Where the search for a member's curve ended; without a spread if it has none.
Starts starts_of(const RefinedModel& fine, std::size_t member) {
  Starts starts{fine.starts, fine.agreeing, {}};
  for (const ShapeEstimate& shape : fine.shapes) {
    if (shape.member == member) starts.spread.emplace_back(shape.name, shape.spread);
  }
  return starts;
}

/// Curved parameters between the grid's values; the figures are then of that model.
void refine(const Bench& bench, const Log& log, const EquationFit& fit, const Fit& model,
            EquationResult& result) {
  const Folds& folds = fit.folds();
  auto fine =
      refined(bench, fit.equation(), model, fit.source(), folds.of_run, folds.of_block, fit.band());
  if (!fine || result.added.empty()) return;
  // A log that cannot tell the law does not show its curve: no error is claimed for that.
  for (ShapeEstimate& shape : fine->shapes) {
    if (is_ambiguous(result, fine->dictionary.variants[shape.member].effect)) {
      shape.standard_error = INFINITY;
    }
  }
  Equation equation = fit.equation();
  equation.dictionary = fine->dictionary;
  equation.target = fine->target;
  const EquationFit after(log, std::move(equation), fit.source());
  result.after = after.errors(fine->fit);
  result.noise_floor_rms = after.noise_floor_rms(fine->fit);
  result.structure_after = after.structure(fine->fit);
  result.is_noise_after = after.is_noise(fine->fit, result.structure_after);
  for (const Named& named : refined_names(*fine, fit.equation().always.size(), Balance(bench))) {
    for (NamedEffect& effect : result.added) {
      if (effect.effect != named.effect.effect) continue;
      effect.parameters = named.effect.parameters;
      effect.standard_error = named.effect.standard_error;
      const Starts starts = starts_of(*fine, named.members.front());
      if (!starts.spread.empty()) effect.evidence += sentence_of(starts);
    }
  }
  result.added.back().holdout_rms_after = result.after.holdout_rms;
}

/// Runs of one name are one, whether or not they were fitted.
std::string rig_objection(const Log& log, const EquationFit& fit, const Fit& model) {
  std::vector<std::string> names;
  std::vector<std::size_t> of_block;
  for (const Block& block : fit.fitter().gram().blocks) {
    const std::string& name = log.runs.head(block.run).name;
    const auto known = std::find(names.begin(), names.end(), name);
    of_block.push_back(static_cast<std::size_t>(known - names.begin()));
    if (known == names.end()) names.push_back(name);
  }
  return not_one_rig(fit.fitter(), model, fit.equation(), of_block, names);
}

}  // namespace

EquationResult analyse_equation(const Bench& bench, const Log& log, Equation equation,
                                const SignalSource& source, const AnalysisOptions& options) {
  EquationFit fit(log, std::move(equation), source);
  EquationResult result;
  result.quantity = fit.equation().quantity;
  result.unit = fit.equation().unit;
  result.band_Hz = fit.band().cutoff_Hz;
  ConfidentSelection found;
  Selection& selection = found.selection;
  result.unusable = obstacle(fit, selection.empty);
  if (!result.unusable.empty()) return result;
  result.before = fit.errors(selection.empty);
  result.structure_before = fit.structure(selection.empty);
  selection.model = selection.empty;
  if (options.select) found = confident_search(fit, result.structure_before, options.settled);
  result.has_tentative = found.has_tentative;
  describe_after(fit, selection, result);
  name_effects(fit, selection, result);
  add_groups(bench, source.rows(), selection, result);
  refine(bench, log, fit, selection.model, result);
  for (std::size_t k = 0; k < fit.equation().corrections.size() && options.select; ++k) {
    const auto index = static_cast<Eigen::Index>(k);
    const double variance = selection.model.covariance(index, index);
    result.corrected.push_back(corrected(fit.equation(), k, selection.model.values[index],
                                         std::sqrt(std::max(0.0, variance))));
  }
  result.rejected = selection.rejected;
  result.not_excited = not_excited(fit, selection.model);
  result.not_one_rig = rig_objection(log, fit, selection.model);
  result.verdict = verdict_of(result, options.select);
  return result;
}

}  // namespace torquewright::identification
