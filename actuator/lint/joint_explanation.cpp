// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/joint_explanation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace torquewright::actuator::lint {
namespace {

/// More than two readings at once explain nearly any sheet.
constexpr std::size_t kMostReadings = 2;
constexpr std::size_t kMostCulprits = 3;
constexpr double kSameNumber = 1e-12;
/// What a reading may leave beyond rounding. The nearest two, a torque constant per dc ampere and
/// per peak ampere with six steps, are 3/pi apart; within half of that no ratio is met by both.
constexpr double kReadingShare = 0.0225;

/// A document in some readings, and what these leave to be explained.
struct Candidate {
  Interpretation reading;
  std::vector<std::string> sentences;
  std::size_t next_kind = 0;  ///< Of those before, at most one was taken.
};

/// Explanations that a check has of its own (a load, losses, a round number): one that does. None
/// beside a reading of the same numbers: with both, half of all ratios would be explained.
std::optional<std::string> own_explanation(const Check& check, const Actuator& document,
                                           const Pair& pair, const Actuator& as_it_stands) {
  const double before = pair_of(check, as_stated(as_it_stands)).value_or(pair).expected.value;
  if (std::abs(pair.expected.value - before) > kSameNumber * std::abs(before)) return std::nullopt;
  for (const Explanation& one : own_explanations(check, document, pair.stated, pair.expected)) {
    if (one.fit != Agreement::kExcludes) return fmt::format("{}: {}", check.rule, one.sentence);
  }
  return std::nullopt;
}

bool is_nearly_met(const Check& check, const Pair& pair) {
  RoundedInterval wide = pair.expected;
  wide.low *= 1.0 - kReadingShare;
  wide.high *= 1.0 + kReadingShare;
  return is_met(check.demand, pair.stated, wide);
}

/// The checks that a reading leaves to be explained. What contradicts as stated has to agree nearly
/// within its rounding: within a catalogue's 10 % some reading meets nearly any ratio.
std::vector<const Check*> left_by(const Interpretation& reading,
                                  const std::vector<const Check*>& contradicting) {
  std::vector<const Check*> left = contradicted(reading);
  for (const Check* check : contradicting) {
    const std::optional<Pair> pair = pair_of(*check, reading);
    if (!pair || is_nearly_met(*check, *pair)) continue;
    if (std::find(left.begin(), left.end(), check) == left.end()) left.push_back(check);
  }
  return left;
}

/// The readings, and one explanation more for each check that still contradicts and has one;
/// nothing where one of them has none.
std::optional<std::vector<std::string>> explained(const Candidate& candidate,
                                                  const Actuator& as_it_stands,
                                                  const std::vector<const Check*>& contradicting) {
  std::vector<std::string> sentences = candidate.sentences;
  for (const Check* check : left_by(candidate.reading, contradicting)) {
    const auto own = own_explanation(*check, candidate.reading.document,
                                     pair_of(*check, candidate.reading).value(), as_it_stands);
    if (!own) return std::nullopt;
    sentences.push_back(*own);
  }
  return sentences;
}

/// One kind of reading each: of every number, then those that the contradicting checks add.
std::vector<Interpreter> kinds_of_readings(const Interpretation& own) {
  std::vector<Interpreter> kinds{convention_interpretations,    measure_interpretations,
                                 speed_measure_interpretations, ampere_interpretations,
                                 ohm_interpretations,           side_interpretations,
                                 loss_interpretations};
  for (const Check* check : contradicted(own)) {
    for (const Interpreter kind : check->interpreters) {
      // These two combine convention and measure, which are counted apart here.
      if (kind == speed_interpretations || kind == emf_interpretations) continue;
      if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
    }
  }
  return kinds;
}

std::vector<Candidate> with_one_more(const std::vector<Candidate>& candidates,
                                     const std::vector<Interpreter>& kinds) {
  std::vector<Candidate> more;
  for (const Candidate& candidate : candidates) {
    for (std::size_t kind = candidate.next_kind; kind < kinds.size(); ++kind) {
      for (Interpretation& reading : kinds[kind](candidate.reading)) {
        Candidate next{std::move(reading), candidate.sentences, kind + 1};
        next.sentences.push_back(next.reading.sentence);
        more.push_back(std::move(next));
      }
    }
  }
  return more;
}

std::vector<std::string> fewest_readings(const Actuator& document) {
  const Interpretation own = as_stated(document);
  const std::vector<const Check*> contradicting = contradicted(own);
  const std::vector<Interpreter> kinds = kinds_of_readings(own);
  std::vector<Candidate> candidates{{own, {}, 0}};
  std::vector<std::string> fewest;
  for (std::size_t size = 0;; ++size) {
    for (const Candidate& candidate : candidates) {
      const auto sentences = explained(candidate, document, contradicting);
      if (sentences && (fewest.empty() || sentences->size() < fewest.size())) fewest = *sentences;
    }
    const bool is_least = !fewest.empty() && fewest.size() <= size + 1;
    if (is_least || size == kMostReadings) return fewest;
    candidates = with_one_more(candidates, kinds);
  }
}

bool is_numeral(const std::string& pointer) {
  for (const char* word : {"convention", "modulation", "field_weakening", "file", "effects"}) {
    if (pointer.ends_with(word)) return false;
  }
  return true;
}

std::vector<std::string> numerals_of(const Comparison& comparison) {
  std::vector<std::string> numerals =
      united(comparison.stated.pointers, comparison.expected.pointers);
  std::erase_if(numerals, [](const std::string& pointer) { return !is_numeral(pointer); });
  return numerals;
}

bool contains(const std::vector<std::string>& list, const std::string& entry) {
  return std::find(list.begin(), list.end(), entry) != list.end();
}

/// Which numerals stand in contradictions, and how often what agrees confirms each.
struct Suspicions {
  std::vector<std::vector<std::string>> contradictions;
  std::map<std::string, int> confirmed;
};

Suspicions suspicions_of(std::span<const Comparison> comparisons) {
  Suspicions all;
  for (const Comparison& comparison : comparisons) {
    const std::vector<std::string> numerals = numerals_of(comparison);
    if (!comparison.is_tolerated && comparison.weight == Weight::kContradiction) {
      all.contradictions.push_back(numerals);
    } else if (comparison.demand == Demand::kEqual) {
      for (const std::string& numeral : numerals) ++all.confirmed[numeral];
    }
  }
  return all;
}

bool spoil_everything(const Numerals& numerals, const Suspicions& all) {
  return std::all_of(all.contradictions.begin(), all.contradictions.end(), [&](const auto& one) {
    return std::any_of(numerals.begin(), numerals.end(),
                       [&](const std::string& numeral) { return contains(one, numeral); });
  });
}

/// A numeral that agrees elsewhere too would have to be wrong as often by chance.
int improbability(const Numerals& numerals, const Suspicions& all) {
  int sum = 0;
  for (const std::string& numeral : numerals) {
    const auto place = all.confirmed.find(numeral);
    sum += 1 + (place == all.confirmed.end() ? 0 : place->second);
  }
  return sum;
}

std::vector<Numerals> culprits_of(std::span<const Comparison> comparisons) {
  const Suspicions all = suspicions_of(comparisons);
  Numerals suspects;
  for (const Numerals& one : all.contradictions) suspects = united(suspects, one);
  std::vector<Numerals> sets{{}}, culprits;
  int least = 0;
  for (std::size_t size = 1; size <= kMostCulprits; ++size) {
    std::vector<Numerals> larger;
    for (const Numerals& set : sets) {
      const auto after = set.empty()
                             ? suspects.begin()
                             : std::next(std::find(suspects.begin(), suspects.end(), set.back()));
      for (auto suspect = after; suspect != suspects.end(); ++suspect) {
        Numerals& more = larger.emplace_back(set);
        more.push_back(*suspect);
        if (!spoil_everything(more, all)) continue;
        const int cost = improbability(more, all);
        if (culprits.empty() || cost < least) {
          culprits.clear();
          least = cost;
        }
        if (cost == least) culprits.push_back(more);
      }
    }
    sets = std::move(larger);
  }
  return culprits;
}

}  // namespace

std::optional<Pair> pair_of(const Check& check, const Interpretation& interpretation) {
  const std::optional<RoundedInterval> stated = check.stated(interpretation.document);
  if (!stated) return std::nullopt;
  const std::optional<RoundedInterval> expected = check.expected(interpretation);
  if (!expected) return std::nullopt;
  return Pair{*stated, *expected};
}

bool is_tolerated(const Check& check, const Actuator& document, const Pair& pair) {
  if (check.tolerance == nullptr) return is_met(check.demand, pair.stated, pair.expected);
  const Tolerance tolerance = check.tolerance({document, pair.stated, pair.expected});
  RoundedInterval admitted = pair.expected;
  admitted.low *= tolerance.least;
  admitted.high *= tolerance.greatest;
  return is_met(check.demand, pair.stated, admitted);
}

std::vector<const Check*> contradicted(const Interpretation& interpretation) {
  std::vector<const Check*> checks;
  for (const Check* check : library()) {
    if (check->weight != Weight::kContradiction || check->stands_alone) continue;
    const std::optional<Pair> pair = pair_of(*check, interpretation);
    if (pair && !is_tolerated(*check, interpretation.document, *pair)) checks.push_back(check);
  }
  return checks;
}

JointExplanation explain(const Actuator& document, std::span<const Comparison> comparisons) {
  return {fewest_readings(document), culprits_of(comparisons)};
}

}  // namespace torquewright::actuator::lint
