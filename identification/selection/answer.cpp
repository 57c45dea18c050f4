// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "actuator/effects/library.hpp"
#include "identification/findings/confusions.hpp"
#include "identification/findings/doubts.hpp"
#include "identification/findings/undetermined.hpp"
#include "identification/findings/verdict.hpp"
#include "identification/findings/written.hpp"
#include "identification/selection/asked.hpp"
#include "identification/selection/errors.hpp"
#include "identification/selection/instant.hpp"
#include "identification/selection/judgement.hpp"
#include "identification/selection/line_traces.hpp"
#include "identification/selection/models_within_noise.hpp"
#include "identification/selection/named.hpp"
#include "identification/selection/one_level.hpp"
#include "identification/selection/other_models.hpp"
#include "identification/selection/position_curve.hpp"
#include "identification/selection/run_results.hpp"
#include "identification/selection/same_rig.hpp"
#include "identification/selection/search.hpp"
#include "identification/selection/wave_share.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kLeastTrainingBlocks = 6;  ///< In training, to say anything.
constexpr double kAgreeing = 0.25;  ///< Of a change, that two equations may differ by and agree.

std::vector<ResidualStructure> structure_left(const Rows& rows, const Eigen::VectorXd& residual) {
  std::vector<ResidualTrace> traces;
  std::size_t block = 0;
  Eigen::Index row = 0;
  for (std::size_t s = 0; s < rows.signals().size(); ++s) {
    const Eigen::Index end = row + static_cast<Eigen::Index>(rows.samples()[s].size());
    std::size_t sample = 0;
    for (; block < rows.blocks().size() && rows.blocks()[block].begin < end; ++block) {
      const Rows::Block& each = rows.blocks()[block];
      if (!each.is_held_out()) {
        if (traces.empty() || traces.back().signals != &rows.signals()[s] ||
            traces.back().fold != each.fold) {
          traces.emplace_back();
          traces.back().signals = &rows.signals()[s];
          traces.back().fold = each.fold;
        }
        for (Eigen::Index k = 0; k < each.count; ++k) {
          traces.back().index.push_back(rows.samples()[s][sample + static_cast<std::size_t>(k)]);
          traces.back().value.push_back(residual[each.begin + k]);
        }
      }
      sample += static_cast<std::size_t>(each.count);
    }
    row = end;
  }
  return residual_structures(traces);
}

std::string evidence_for(const Comparison& gain, double share) {
  return fmt::format(
      "It removes {:.0f} % of the squared error where it was not fitted, which is {:.1f} standard "
      "errors; it helps in {} of {} parts.",
      100.0 * std::clamp(share, 0.0, 1.0), gain.t, gain.parts_better, gain.parts);
}

std::string undetermined_words(const std::vector<std::string>& parameters) {
  if (parameters.empty()) return "";
  return fmt::format(
      " The log says nothing of {}: it is less than its own error, and a refined document has 0.",
      io::listed(parameters));
}

/// Of a law whose own constant is an offset: the sum of both is all that any log holds.
std::string constant_words(const std::string& effect) {
  const actuator::EffectKind* kind = actuator::find_effect(effect);
  if (kind == nullptr || kind->acts != actuator::Acts::kOutputTorque) return "";
  const auto& ends = kind->tends_to;
  if (std::find(ends.begin(), ends.end(), "torque_offset") == ends.end()) return "";
  return " No log tells what of its constant torque is an offset of a sensor or friction that "
         "differs by direction: the neutral angle is that of all three together.";
}

/// Stated effects that a member takes the place of, and the one of its own kind.
std::string stated_parts_of(const EffectCandidate& member, const actuator::Actuator& stated) {
  std::string list;
  for (const actuator::Effect& each : stated.effects) {
    const bool is_part = std::find(member.contains.begin(), member.contains.end(),
                                   each.kind->name) != member.contains.end();
    const bool is_same = each.kind->name == member.effect && member.order == 0.0;
    if (is_part || is_same) list += (list.empty() ? "" : ", ") + std::string(each.kind->name);
  }
  return list;
}

/// EffectSet by what they gain, the strongest first.
std::vector<std::size_t> by_gain(const Found& found) {
  std::vector<std::size_t> order(found.best.members.size());
  for (std::size_t m = 0; m < order.size(); ++m) order[m] = m;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return found.gains[a].gain > found.gains[b].gain;
  });
  return order;
}

Left left_in(const Rows& rows, const ModelFit& fit, bool held_out) {
  Left left;
  for (std::size_t b = 0; b < rows.blocks().size(); ++b) {
    if (rows.blocks()[b].is_held_out() != held_out) continue;
    left.squares += std::max(0.0, fit.unseen[b]);
    left.noise += fit.sums[b].noise;
  }
  return left;
}

void name_members(const ModelFitter& fitter, const Found& found, const SearchRules& rules,
                  EquationResult& result) {
  const Left seen = left_in(fitter.rows(), found.best, false);
  const Left held_out = left_in(fitter.rows(), found.best, true);
  Errors last = errors_over(fitter.equation(), fitter.rows(), found.empty.residual);
  EffectSet members;
  double before = std::max(1e-300, found.empty.unseen_loss);
  for (const std::size_t m : by_gain(found)) {
    members.push_back(found.best.members[m]);
    NamedEffect named = named_effect(found.best, m);
    const bool is_last = members.size() == found.best.members.size();
    Eigen::VectorXd start = found.best.coordinates.head(found.best.always);
    for (const EffectCandidate* each : members) {
      const auto place = std::find(found.best.members.begin(), found.best.members.end(), each);
      const auto own = static_cast<std::size_t>(place - found.best.members.begin());
      const auto count = static_cast<Eigen::Index>(each->parameters.size());
      Eigen::VectorXd longer(start.size() + count);
      longer << start, found.best.coordinates.segment(found.best.first_of(own), count);
      start = longer;
    }
    const ModelFit sub = is_last ? found.best : fitter.fit(members, start);
    const Errors after = errors_over(fitter.equation(), fitter.rows(), sub.residual);
    named.holdout_rms_before = last.holdout_rms;
    named.holdout_rms_after = after.holdout_rms;
    named.replaces = stated_parts_of(*found.best.members[m], fitter.equation().stated.actuator);
    named.evidence = evidence_for(found.gains[m], found.gains[m].gain / before) +
                     undetermined_words(undetermined_parameters(named)) +
                     constant_words(named.effect);
    named.doubt = doubt_beside(held_out, found.gains[m].held_out_gain, rules.unexplained_floors);
    if (named.doubt.empty())
      named.doubt = doubt_beside(seen, found.gains[m].gain, rules.unexplained_floors);
    last = after;
    const auto same = std::find_if(result.added.begin(), result.added.end(), [&](const auto& each) {
      return found.best.members[m]->order > 0.0 && is_wave_of(each, named);
    });
    if (same == result.added.end()) {
      result.added.push_back(std::move(named));
    } else {
      append_wave(*same, named);
      same->holdout_rms_after = named.holdout_rms_after;
    }
  }
}

void append_group(const Bench& bench, const std::string& named, std::vector<std::string> effects,
                  bool exact, EquationResult& result) {
  if (effects.size() < 2) return;
  Confounded group;
  group.separated_by = separated_by(bench, effects);
  if (exact) group.consequence = consequence(named, effects);
  group.effects = std::move(effects);
  group.exact = exact;
  result.confounded.push_back(std::move(group));
}

/// Whether what gravity takes beyond the rig's is mostly in phase with the rig's: then the load
/// itself may be another.
bool is_in_phase_with_load(const Bench& bench, const NamedEffect& named) {
  if (named.effect != "gravity_imbalance" || bench.load_side != LoadSide::kModel ||
      bench.rig->load.type != LoadType::kPendulum)
    return false;
  const double phase_rad = named.parameters.value("phase_rad", 0.0);
  return std::abs(std::cos(phase_rad)) > std::abs(std::sin(phase_rad));
}

/// Whether the winding's voltage, which no value of the load and no torque sensor enters, has the
/// same torque constant.
bool is_confirmed_constant(const ForwardEquation& equation, const NamedEffect& named) {
  const bool is_constant = actuator::stands_for(named.effect, actuator::StandsFor::kTorqueScale);
  if (!is_constant || !equation.constant_factor_by_voltage) return false;
  const double factor = named.parameters.value("factor", 1.0);
  return std::abs(factor - *equation.constant_factor_by_voltage) <
         kAgreeing * std::abs(factor - 1.0);
}

/// Effects that no log of such a rig tells from one that was named; itself alone if there are none.
std::vector<std::string> same_on_such_a_rig(const Bench& bench, const ForwardEquation& equation,
                                            const Found& found, const NamedEffect& named) {
  if (!equation.is_torque_balance || is_confirmed_constant(equation, named)) return {named.effect};
  if (is_in_phase_with_load(bench, named))
    return {named.effect, "load_mass_error", "load_length_error"};
  std::vector<std::string> exact = exact_identities(bench, named.effect);
  if (found.turned_one_way && !named.parameters.waves.empty())
    exact.emplace_back(actuator::first_wave(actuator::Acts::kDrag).name);
  return exact;
}

/// One of those, or what contains one of them and says no more by being as good.
bool says_the_same(const EffectCandidate& rival, const std::vector<std::string>& exact) {
  return std::any_of(exact.begin(), exact.end(), [&](const std::string& effect) {
    return rival.effect == effect ||
           std::find(rival.tends_to.begin(), rival.tends_to.end(), effect) != rival.tends_to.end();
  });
}

/// Exact groups, and what stands in the place of a member in rivals that do without it.
void append_groups(const Bench& bench, const ForwardEquation& equation, const Found& found,
                   const std::vector<Whole>& wholes, EquationResult& result) {
  for (const NamedEffect& named : result.added) {
    const std::vector<std::string> exact = same_on_such_a_rig(bench, equation, found, named);
    append_group(bench, named.effect, exact, true, result);
    std::vector<std::string> others = {named.effect};
    for (const ModelFit& rival : found.rivals) {
      if (rival.holds(named.effect)) continue;
      for (const EffectCandidate* each : rival.members) {
        const bool is_known = std::find(others.begin(), others.end(), each->effect) != others.end();
        if (!found.best.holds(each->effect) && !is_known && !says_the_same(*each, exact)) {
          others.push_back(each->effect);
        }
      }
    }
    for (const Whole& whole : wholes) {
      const bool is_known =
          std::find(others.begin(), others.end(), whole.law->effect) != others.end();
      if (whole.part == named.effect && !is_known && !says_the_same(*whole.law, exact))
        others.push_back(whole.law->effect);
    }
    append_group(bench, named.effect, others, false, result);
  }
}

/// What the model leaves with some of its members alone, by their names.
Errors errors_with(const ModelFitter& fitter, const ModelFit& best,
                   const std::vector<std::string>& names) {
  const PartOfModel part = part_of(best, [&](const EffectCandidate& member) {
    return std::find(names.begin(), names.end(), member.effect) != names.end();
  });
  return errors_over(fitter.equation(), fitter.rows(),
                     fitter.residual(part.members, part.coordinates));
}

std::vector<std::string> certain_of_actuator(const EquationResult& result) {
  std::vector<std::string> names;
  for (const NamedEffect* each : certain_of(result)) {
    if (each->family == EffectFamily::kActuator) names.push_back(each->effect);
  }
  return names;
}

Promise promise_of(const ModelFitter& fitter, const ModelFit& best, const EquationResult& result) {
  Promise promise;
  for (const NamedEffect* each : written_of(result)) promise.effects.push_back(each->effect);
  promise.errors = errors_with(fitter, best, promise.effects);
  return promise;
}

std::string reason_of(const Comparison& gain, const SearchRules& rules) {
  if (gain.gain <= 0.0) return "it raises the error where it was not fitted";
  if (gain.change_rms <= rules.least_change) {
    return fmt::format(
        "it lowers the error where it was not fitted by {:.1f} standard errors, and changes the "
        "prediction by {:.3g} rms (in its unit), which is less than the {:.3g} of the tolerance",
        gain.t, gain.change_rms, rules.least_change);
  }
  return fmt::format(
      "it lowers the error where it was not fitted by {:.1f} standard errors, and changes the "
      "prediction by {:.3g} rms (in its unit); another effect explains as much, or chance would",
      gain.t, gain.change_rms);
}

std::string reason_of(const Unsteadiness& by) {
  return fmt::format(
      "it has no one value over {}: fitted apart in each quarter of it, it takes {:.0f} % of the "
      "squares that are left",
      by.coordinate, 100.0 * by.share);
}

/// What does nothing by itself is no less excited for it.
bool acts_beside_another(const std::string& effect) {
  const actuator::EffectKind* kind = actuator::find_effect(effect);
  return kind != nullptr && kind->in_train == actuator::TrainPart::kHysteresis;
}

void describe_refused(const Judgement& judged, const Found& found, const SearchRules& rules,
                      EquationResult& result) {
  std::set<std::string> seen;
  for (const Wanderer& each : judged.wanderers) {
    if (seen.insert(each.candidate->effect).second) {
      result.rejected.push_back({each.candidate->effect, reason_of(each.by)});
    }
  }
  for (const Refusal& each : found.refused) {
    if (seen.insert(each.candidate->effect).second) {
      result.rejected.push_back({each.candidate->effect, reason_of(each.gain, rules)});
    }
  }
  for (const EffectCandidate* each : found.silent) {
    if (acts_beside_another(each->effect)) continue;
    if (std::find(result.not_excited.begin(), result.not_excited.end(), each->effect) ==
        result.not_excited.end()) {
      result.not_excited.push_back(each->effect);
    }
  }
}

std::vector<std::string> names_of_runs(const Log& log) {
  std::vector<std::string> names;
  for (std::size_t run = 0; run < log.runs.size(); ++run) names.push_back(log.runs.head(run).name);
  return names;
}

/// Of all uncertain values: one that every run has otherwise is not determined by all of them.
std::string disagreement_as_stated(const ForwardEquation& stated, const Rows& rows,
                                   const HeldSignals& held, const Log& log) {
  const ModelFitter fitter(stated, rows, held.replica);
  return runs_that_disagree(stated, rows, fitter.fit({}, fitter.always_start()),
                            names_of_runs(log));
}

}  // namespace

EquationResult answer(const Bench& bench, const Log& log, const ForwardEquation& stated,
                      const HeldSignals& held, const std::vector<std::size_t>& fold_of_run,
                      const AnalysisOptions& options) {
  EquationResult result;
  SearchRules rules;
  rules.least_change = options.tolerance * stated.used;
  rules.asks = [&options](const std::string& effect) { return options.asks(effect); };
  rules.before_each_fit = options.before_each_fit;
  const ForwardEquation equation = with_what_is_determined(stated, held, fold_of_run);
  result.quantity = equation.quantity;
  result.unit = equation.unit;
  const auto band = options.band_Hz.find({bench.rig->joints[bench.joint], equation.quantity});
  const Rows rows(held.rows, fold_of_run,
                  {band != options.band_Hz.end()
                       ? band->second
                       : telling_band_Hz(with_instants(equation, 0), held, fold_of_run)});
  result.band_Hz = rows.options().cutoff_Hz;
  if (rows.training_blocks() < kLeastTrainingBlocks) {
    result.unusable =
        fmt::format("{} blocks of samples can be fitted, and {} are needed: {}",
                    rows.training_blocks(), kLeastTrainingBlocks, what_would_help(held.rows));
    return result;
  }
  const auto asked = searched(equation, rows, held.replica, rules, options.select);
  const ModelFitter& fitter = asked->fitter;
  Search& search = asked->search;
  Found& found = asked->found;
  result.before = errors_over(equation, rows, found.empty.residual);
  result.structure_before = structure_left(rows, found.empty.residual);
  const Judgement judged = judge(fitter, search, found, result.structure_before);
  result.is_noise_before = judged.is_noise_before;
  result.has_tentative = judged.has_tentative;
  const ModelFit& kept = found.best;
  result.after = errors_over(equation, rows, kept.residual);
  result.noise_floor_rms = noise_floor(fitter, kept) * std::abs(equation.unit_per_residual);
  result.structure_after =
      kept.members.empty() ? result.structure_before : structure_left(rows, kept.residual);
  result.is_noise_after = leaves_noise(search, fitter, kept, result.structure_after);
  name_members(fitter, found, rules, result);
  append_groups(bench, equation, found, search.wholes(kept), result);
  cover_other_models(search.as_good_as(kept), kept, result);
  cover_other_models(search.with_what_is_too_small(kept), kept, result);
  append_doubts(result);
  doubt_what_goes_along(rules.unexplained_floors, result);
  doubt_one_level(rows, result);
  doubt_what_fails_held_out(rules.unexplained_floors, result);
  if (!result.is_noise_after) doubt_laws_of_position(fitter, kept, result);
  if (equation.is_torque_balance) doubt_waves_hardly_seen(fitter, kept, result);
  describe_refused(judged, found, rules, result);
  result.runs = run_results(equation, rows, found.empty.residual, kept.residual);
  if (options.select) result.models = models_within_noise(bench, fitter, found);
  result.lines = spectral_lines(
      line_traces(equation, fitter.hypothesis(kept.members, kept.coordinates), held));
  result.with_certain = errors_with(fitter, kept, certain_of_actuator(result));
  doubt_what_does_harm(result);
  result.with_certain = errors_with(fitter, kept, certain_of_actuator(result));
  for (std::size_t k = 0; k < equation.pointers.size() && options.select; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    result.corrected.push_back({equation.pointers[k], equation.always_start[k], kept.coordinates[i],
                                std::sqrt(std::max(0.0, kept.covariance(i, i)))});
  }
  result.not_one_rig = runs_that_disagree(equation, rows, kept, names_of_runs(log));
  if (result.not_one_rig.empty() && kept.members.empty())
    result.not_one_rig = disagreement_as_stated(stated, rows, held, log);
  result.verdict = verdict_of(result, options.select);
  result.promise = promise_of(fitter, kept, result);
  return result;
}

}  // namespace torquewright::identification
