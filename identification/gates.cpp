// SPDX-License-Identifier: Apache-2.0
#include "identification/gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

constexpr double kLeastExplained = 0.6;  ///< Share of what is explainable.
constexpr double kNoiseLevel = 2.5;      ///< Times the floor: nothing is left.
constexpr double kTableAhead = 0.03;     ///< By which a table may explain more than the names do.
constexpr double kNearlyNoise = 0.5;  ///< Loss over the floor below which the rest says nothing.
constexpr double kConfirmed = 0.04;   ///< Share of the held-out error that a name takes away.
constexpr double kMostLeftAlongOwn = 0.3;
constexpr double kMostLeftAlongPair = 0.15;  ///< Of two laws of the torque constant together.
constexpr double kMostLeftOfOwn = 0.15;  ///< What is left along it over what the name takes away.
constexpr double kAmplitudeGain = 0.15;  ///< A name whose amplitude varies wins more than this.
constexpr double kMostScatter = 0.3;     ///< Of a parameter between runs, beyond its error.
constexpr double kScatterErrors = 3.0;
constexpr std::size_t kFewestOfASpot = 4;  ///< Waves of friction that are multiples of one.
constexpr double kExcited = 0.03;  ///< A run excites a column with this of the best run's power.

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

/// Whether a member whose amplitude varies with something would explain much more.
std::string varying_amplitude(const Fitter& fitter, const Fit& model, std::size_t member,
                              const SignalSource& source, const Target& target,
                              const BandOptions& band) {
  const Dictionary& dictionary = fitter.dictionary();
  Dictionary small;
  std::vector<Coefficient> base;
  const auto add = [&](Column column) {
    small.columns.push_back(std::move(column));
    return small.columns.size() - 1;
  };
  for (std::size_t m = 0; m < model.members.size(); ++m) {
    const std::size_t first = model.first_of_member(dictionary, m, fitter.always_count());
    const std::size_t count = dictionary.variants[model.members[m]].coefficients.size();
    for (std::size_t j = 0; j < count; ++j) {
      base.push_back(
          {{{add(contribution(model, dictionary, first + j, 1, nullptr)), 1.0}}, -1e300, 1e300});
    }
  }
  for (std::size_t j = 0; j < fitter.always_count(); ++j) {
    base.push_back({{{add(contribution(model, dictionary, j, 1, nullptr)), 1.0}}, -1e300, 1e300});
  }
  const std::size_t first = model.first_of_member(dictionary, member, fitter.always_count());
  const std::size_t count = dictionary.variants[model.members[member]].coefficients.size();
  for (const Modulation& modulation : kModulations) {
    const std::size_t column = add(contribution(model, dictionary, first, count, modulation.value));
    Variant variant;
    variant.effect = modulation.name;
    variant.coefficients = {{{{column, 1.0}}, -1e300, 1e300}};
    small.variants.push_back(variant);
  }
  const Gram gram = build_gram(source, false, small, target, band);
  if (gram.blocks.size() != fitter.folds().size()) return "";
  const Fitter modulated(gram, small, fitter.folds(), base);
  const Fit plain = modulated.fit({});
  if (!plain.is_valid) return "";
  for (std::size_t v = 0; v < small.variants.size(); ++v) {
    const Fit with = modulated.fit({v});
    if (!with.is_valid) continue;
    const Gain gain = gain_of(modulated, plain, with);
    if (gain.share > kAmplitudeGain && gain.t > 3.0) {
      return fmt::format(
          "its size varies with {}: letting it do so removes another {:.0f} % of what is left, so "
          "the log shows something else than this effect",
          small.variants[v].effect, 100.0 * gain.share);
    }
  }
  return "";
}

/// Runs that no fit has seen have the last word.
std::string not_confirmed(const Fitter& fitter, const Fit& model, std::size_t member) {
  if (fitter.samples(true) == 0.0) return "";
  Members members = model.members;
  members.erase(members.begin() + static_cast<std::ptrdiff_t>(member));
  const Fit without = fitter.fit_unlimited(members);
  if (!without.is_valid) return "";
  const double before = fitter.loss_on(without, true), after = fitter.loss_on(model, true);
  if (before - after > kConfirmed * before) return "";
  return fmt::format(
      "in the runs held out from everything it changes the squared error by {:+.0f} % only",
      100.0 * (after - before) / before);
}

/// Once others are gone it may gain nothing any more.
std::string no_longer_earned(const Fitter& fitter, const Fit& model, std::size_t member) {
  Members members = model.members;
  members.erase(members.begin() + static_cast<std::ptrdiff_t>(member));
  const Fit without = fitter.fit_unlimited(members);
  if (!without.is_valid) return "";
  const AcceptanceRules rules = rules_for(fitter.dictionary(), members, model.members);
  return objection(model, gain_of(fitter, without, model, rules), rules);
}

/// The coordinates along which a law would be wrong if it were the wrong law.
std::vector<std::string> own_coordinates(const std::string& effect) {
  if (effect == "torque_constant_error" || effect == "torque_constant_saturation" ||
      effect == "load_dependent_friction") {
    return {"load_torque_Nm", "motor_current_A"};
  }
  if (effect == "viscous_friction" || effect == "quadratic_drag") return {"output_velocity_rad_s"};
  if (effect == "gear_ripple" || effect == "gravity_imbalance" ||
      effect == "position_dependent_friction") {
    return {"output_position_rad"};
  }
  if (effect == "cogging_torque") return {"motor_position_rad"};
  return {};
}

/// Two of them together can follow a dead zone of the current's sensor.
bool is_of_torque_constant(const std::string& effect) {
  return effect == "torque_constant_error" || effect == "torque_constant_saturation";
}

bool has_pair_of_torque_constant(const Fitter& fitter, const Fit& model) {
  const auto count = std::count_if(
      model.members.begin(), model.members.end(), [&](std::size_t member) {
        return is_of_torque_constant(fitter.dictionary().variants[member].effect);
      });
  return count > 1;
}

/// Many waves on one fundamental are a spot, which the law of a few orders is not.
std::string is_a_spot(const Fitter& fitter, const Fit& model, std::size_t member) {
  const Dictionary& dictionary = fitter.dictionary();
  const std::string effect = "position_dependent_friction";
  if (dictionary.variants[model.members[member]].effect != effect) return "";
  std::vector<double> orders;
  for (const std::size_t each : model.members) {
    if (dictionary.variants[each].effect == effect) orders.push_back(dictionary.variants[each].order);
  }
  const double lowest = *std::min_element(orders.begin(), orders.end());
  const bool is_comb = std::all_of(orders.begin(), orders.end(), [&](double order) {
    return std::abs(order / lowest - std::round(order / lowest)) < 1e-6;
  });
  if (orders.size() < kFewestOfASpot || !is_comb) return "";
  return fmt::format(
      "its {} waves are multiples of order {:g}: friction of one spot, not of an order",
      orders.size(), lowest);
}

/// What the member takes away; at least nothing.
double own_gain(const Fitter& fitter, const Fit& model, std::size_t member) {
  Members members = model.members;
  members.erase(members.begin() + static_cast<std::ptrdiff_t>(member));
  const Fit without = fitter.fit_unlimited(members);
  return without.is_valid ? std::max(0.0, without.loss - model.loss) : 0.0;
}

std::string left_along_own(const Fitter& fitter, const Fit& model, std::size_t member,
                           const std::vector<Structure>& left) {
  const std::string& effect = fitter.dictionary().variants[model.members[member]].effect;
  const std::vector<std::string> own = own_coordinates(effect);
  const bool is_pair = is_of_torque_constant(effect) && has_pair_of_torque_constant(fitter, model);
  const double most = is_pair ? kMostLeftAlongPair : kMostLeftAlongOwn;
  for (const Structure& each : left) {
    if (std::find(own.begin(), own.end(), each.coordinate) == own.end()) continue;
    if (each.share < most || !is_significant(each)) continue;
    // A law that took nearly all of what varies along its coordinate is not the wrong one: what
    // something else leaves may vary there too.
    const bool is_cleared =
        each.share * model.loss < kMostLeftOfOwn * own_gain(fitter, model, member);
    if (is_cleared && !is_of_torque_constant(effect)) continue;
    return fmt::format("{:.0f} % of what is left varies with {}, which it should have explained",
                       100.0 * each.share, each.coordinate);
  }
  return "";
}

/// Fits in each fold alone: parameters that wander are no law.
std::string scatter(const Fitter& fitter, const Fit& model, std::size_t member) {
  const Dictionary& dictionary = fitter.dictionary();
  const Variant& variant = dictionary.variants[model.members[member]];
  if (variant.is_temperature_effect) return "";
  const std::size_t first = model.first_of_member(dictionary, member, fitter.always_count());
  const std::size_t folds = fitter.fold_count();
  std::size_t excited = 0, off = 0;
  std::vector<double> powers(folds, 0.0);
  for (std::size_t f = 0; f < folds; ++f) {
    for (std::size_t b = 0; b < fitter.folds().size(); ++b) {
      if (fitter.folds()[b] != f) continue;
      for (std::size_t j = first; j < first + variant.coefficients.size(); ++j) {
        for (const auto& term : model.coefficients[j].terms) {
          const auto c = static_cast<Eigen::Index>(term.column);
          powers[f] += fitter.gram().blocks[b].product(c, c) * term.weight * term.weight;
        }
      }
    }
  }
  const double strongest = *std::max_element(powers.begin(), powers.end());
  for (std::size_t f = 0; f < folds; ++f) {
    if (powers[f] < kExcited * strongest) continue;
    ++excited;
    // The whole fit with everything else held: the member's own coefficients from this fold only.
    std::vector<std::size_t> alone = fitter.folds();
    for (std::size_t& fold : alone) fold = fold == f ? 0 : Fitter::kNoFold;
    const Fitter one(fitter.gram(), dictionary, alone, fitter.always());
    const auto own = one.fit_whole(model.members);
    if (!own) continue;
    for (std::size_t j = first; j < first + variant.coefficients.size(); ++j) {
      const auto index = static_cast<Eigen::Index>(j);
      const double whole = model.values[index];
      const double error = std::sqrt(std::max(0.0, own->covariance(index, index)));
      const double scale = variant.order > 0.0
                               ? std::hypot(model.values[static_cast<Eigen::Index>(first)],
                                            model.values[static_cast<Eigen::Index>(first + 1)])
                               : std::abs(whole);
      if (std::abs(own->values[index] - whole) > kMostScatter * scale &&
          std::abs(own->values[index] - whole) > kScatterErrors * error) {
        ++off;
        break;
      }
    }
  }
  if (2 * off > excited && excited > 1) {
    return fmt::format("its parameters differ from run to run ({} of {})", off, excited);
  }
  if (member > 0 && excited < 2) return "only one run excites it";
  return "";
}

/// Of the whole model: it has to explain most of what is explainable.
std::string too_little(const Fit& empty, const Fit& model, double floor_loss) {
  const double explainable = empty.loss - floor_loss;
  const double explained = empty.loss - model.loss;
  if (explained >= kLeastExplained * explainable || model.loss <= kNoiseLevel * floor_loss) {
    return "";
  }
  return fmt::format(
      "with it only {:.0f} % of what noise does not explain is gone; a name asks for {:.0f} %",
      100.0 * explained / explainable, 100.0 * kLeastExplained);
}

/// Of the whole model: the right laws know more than their values over any one coordinate. Where
/// the target is part of a coordinate, its table explains it by itself and says nothing.
std::string table_knows_more(const EquationFit& fit, const Selection& selection,
                             const std::vector<Structure>& before) {
  const Equation& equation = fit.equation();
  const double explained = 1.0 - selection.model.loss / selection.empty.loss;
  for (const Structure& each : before) {
    if (each.coordinate == equation.quantity) continue;
    if (each.coordinate == "motor_current_A" && equation.target_is_motor_side) continue;
    if (each.share < explained + kTableAhead || !is_significant(each)) continue;
    return fmt::format(
        "with it {:.0f} % of the squared error is gone, and a table over {}{} alone takes {:.0f} %: "
        "so it is something else that varies with that",
        100.0 * explained, each.coordinate, each.times_direction ? " x direction" : "",
        100.0 * each.share);
  }
  return "";
}

/// Of the whole model: members that need one another may together be no better than none.
std::string not_confirmed_together(const EquationFit& fit, const Selection& selection) {
  const Fitter& fitter = fit.fitter();
  const double samples = fitter.samples(true);
  if (samples == 0.0) return "";
  const double before = fitter.loss_on(selection.empty, true);
  const double after = fitter.loss_on(selection.model, true);
  if (after <= kNoiseLevel * fitter.noise_loss(selection.model) * samples) return "";
  if (before - after > kConfirmed * before) return "";
  return fmt::format(
      "in the runs held out from everything all names together change the squared error by "
      "{:+.0f} %",
      100.0 * (after - before) / before);
}

std::string doubt_of_all(const EquationFit& fit, const Selection& selection,
                         const std::vector<Structure>& before) {
  std::string doubt =
      too_little(selection.empty, selection.model, fit.floor_loss(selection.model));
  if (doubt.empty()) doubt = table_knows_more(fit, selection, before);
  if (doubt.empty()) doubt = not_confirmed_together(fit, selection);
  return doubt;
}

std::string doubt_of_one(const EquationFit& fit, const Fit& model, std::size_t member,
                         const std::vector<Structure>& left) {
  const Fitter& fitter = fit.fitter();
  std::string doubt = not_confirmed(fitter, model, member);
  if (doubt.empty()) doubt = no_longer_earned(fitter, model, member);
  if (doubt.empty()) doubt = scatter(fitter, model, member);
  if (doubt.empty()) doubt = is_a_spot(fitter, model, member);
  if (!doubt.empty() || model.loss <= kNearlyNoise * fit.floor_loss(model)) return doubt;
  doubt = left_along_own(fitter, model, member, left);
  if (!doubt.empty()) return doubt;
  return varying_amplitude(fitter, model, member, fit.source(), fit.equation().target, fit.band());
}

}  // namespace

std::vector<std::string> doubts(const EquationFit& fit, const Selection& selection,
                                const std::vector<Structure>& before) {
  const Fit& model = selection.model;
  if (model.members.empty()) return {};
  const std::string of_all = doubt_of_all(fit, selection, before);
  std::vector<std::string> of_member(model.members.size(), of_all);
  if (!of_all.empty()) return of_member;
  const std::vector<Structure> left = fit.structure(model);
  for (std::size_t m = 0; m < of_member.size(); ++m) {
    of_member[m] = doubt_of_one(fit, model, m, left);
  }
  return of_member;
}

}  // namespace torquewright::identification
