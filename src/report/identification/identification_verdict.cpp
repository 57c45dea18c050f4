// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/identification_verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "identification/answer/report_spec.hpp"
#include "src/report/identification/identification_words.hpp"

namespace torquewright::report {
namespace {

using namespace identification;

/// Of those that no other may stand for; the joint's name behind it on a serial arm.
std::vector<std::string> certain_names(const Identification& found) {
  std::vector<std::string> names;
  for (const EquationResult& equation : found.equations) {
    for (const NamedEffect* effect : certain_of(equation)) {
      std::string name = effect->effect;
      if (!equation.joint.empty()) name += " (" + equation.joint + ")";
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

/// Whether its verdict says that something is left which is not noise.
bool is_open(const EquationResult& equation) {
  return equation.verdict == Verdict::kUnexplained || equation.verdict == Verdict::kPartlyExplained;
}

/// Of the first equation that is not explained.
std::string along(const Identification& found) {
  const auto open = std::find_if(found.equations.begin(), found.equations.end(), is_open);
  if (open == found.equations.end()) return "what is left is more than noise";
  const std::string where =
      found.equations.size() == 1 ? std::string() : " of " + name_of_equation(*open);
  const auto left = significant_of(open->structure_after);
  if (left.empty()) {
    return fmt::format(
        "what is left{} is more than noise, but varies with no coordinate that was "
        "tried",
        where);
  }
  return fmt::format("what is left{} varies most with {} ({:.0f} % of its square)", where,
                     name_of_coordinate(left.front()), 100.0 * left.front().share);
}

/// Whether what is left of each equation that is open varies with no coordinate, as noise that is
/// not white does: then nothing says that the model is wrong.
bool goes_with_nothing(const Identification& found) {
  return std::all_of(found.equations.begin(), found.equations.end(), [](const auto& each) {
    return !is_open(each) || significant_of(each.structure_after).empty();
  });
}

/// Names, and why they are not sure, where no other is named for them.
struct Doubt {
  std::vector<std::string> names;
  std::string why;
};
std::vector<Doubt> doubts(const Identification& found) {
  std::vector<Doubt> all;
  for (const EquationResult& equation : found.equations) {
    for (const NamedEffect& each : equation.added) {
      if (each.doubt.empty()) continue;
      auto same = std::find_if(all.begin(), all.end(),
                               [&](const Doubt& other) { return other.why == each.doubt; });
      if (same == all.end()) same = all.insert(all.end(), {{}, each.doubt});
      if (std::find(same->names.begin(), same->names.end(), each.effect) == same->names.end())
        same->names.push_back(each.effect);
    }
  }
  return all;
}

/// A sentence for each group of which the log does not say which it is, and for each doubt.
std::vector<std::string> undecided(const Identification& found) {
  std::vector<std::string> sentences;
  const auto add = [&](std::string sentence) {
    if (std::find(sentences.begin(), sentences.end(), sentence) == sentences.end())
      sentences.push_back(std::move(sentence));
  };
  for (const EquationResult& equation : found.equations) {
    for (const Confounded& group : equation.confounded) {
      if (group.exact && group.consequence.empty()) continue;  // names of one thing
      add(fmt::format("{} {} apart.",
                      group.exact ? "No log of such a rig tells" : "The log cannot tell",
                      fmt::join(group.effects, " and ")));
    }
  }
  for (const auto& [names, doubt] : doubts(found)) {
    add(fmt::format("Not sure of {}: {}.", fmt::join(names, ", "), doubt));
  }
  return sentences;
}

/// What every equation's verdict comes to, but for noise and for what was not asked.
std::string doubt_sentence(const Identification& found) {
  for (const DataFinding& finding : found.findings) {
    if (finding.weight == Weight::kError) return "The data cannot tell. " + finding.sentence;
  }
  std::vector<std::string> sentences = undecided(found);
  for (const EquationResult& equation : found.equations) {
    if (equation.unusable.empty()) continue;
    const std::string where =
        found.equations.size() == 1 ? std::string() : " of " + name_of_equation(equation);
    sentences.push_back(fmt::format("The log cannot tell{}: {}.", where, equation.unusable));
  }
  if (sentences.empty())
    return "The log cannot tell: its channels allow no equation to be compared.";
  const std::vector<std::string> names = certain_names(found);
  if (!names.empty()) {
    sentences.insert(sentences.begin(),
                     fmt::format("Missing from the model: {}.", fmt::join(names, ", ")));
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

/// What is certain, what is not told apart, and what is left.
std::string partly_sentence(const Identification& found) {
  const std::vector<std::string> names = certain_names(found), open = undecided(found);
  const std::string missing = fmt::format("Missing from the model: {}", fmt::join(names, ", "));
  if (open.empty()) return fmt::format("{}; that is not all: {}.", missing, along(found));
  return fmt::format("{}{} That is not all: {}.", names.empty() ? std::string() : missing + ". ",
                     fmt::join(open, " "), along(found));
}

std::string explained_sentence(const Identification& found) {
  const std::vector<std::string> names = certain_names(found), open = undecided(found);
  const char* with = !open.empty() ? "what is named" : names.size() == 1 ? "it" : "them";
  std::string sentence;
  if (!names.empty())
    sentence = fmt::format("Missing from the model: {}. ", fmt::join(names, ", "));
  if (!open.empty()) sentence += fmt::format("{} ", fmt::join(open, " "));
  return sentence + fmt::format("With {} what is left is noise.", with);
}

std::string sentence_of_verdict(const Identification& found, bool select) {
  switch (found.verdict) {
    case Verdict::kNothingMissing:
      return "The error is noise: nothing is missing that this log could show.";
    case Verdict::kCannotTell:
      return doubt_sentence(found);
    case Verdict::kExplained:
      return explained_sentence(found);
    case Verdict::kPartlyExplained:
      return partly_sentence(found);
    case Verdict::kUnexplained:
      break;
  }
  if (!select) return "There is something to explain: " + along(found) + ".";
  if (goes_with_nothing(found)) {
    return fmt::format(
        "More is left than white noise of the channels, and it goes with nothing that the model "
        "knows: noise of a sensor that is not white, or an effect that is not {}.",
        found.not_asked.empty() ? "in the library" : "among those that were asked");
  }
  return fmt::format("The model is wrong, and no effect {} explains how: {}.",
                     found.not_asked.empty() ? "of the library" : "that was asked", along(found));
}

constexpr double kApart = 5.0;  ///< Times what the next run, or noise, has left.

/// Of a run in which more is left than in any other.
std::string run_sentence(const Identification& found) {
  for (const EquationResult& equation : found.equations) {
    std::vector<RunResult> runs = equation.runs;
    if (!is_open(equation) || runs.size() < 3) continue;
    std::sort(runs.begin(), runs.end(),
              [](const RunResult& a, const RunResult& b) { return a.rms_after > b.rms_after; });
    const double next = std::max(runs[1].rms_after, equation.noise_floor_rms);
    if (!(runs[0].rms_after > kApart * next)) continue;
    return fmt::format(
        " It is {} alone: {:.3g} {} are left in it, in any other run {:.3g} {} at most. See "
        "whether its load, its actuator or something on the rig was another.",
        runs[0].run, runs[0].rms_after, equation.unit, runs[1].rms_after, equation.unit);
  }
  return "";
}

/// Of the clearest line that is the data's own.
std::string line_sentence(const Identification& found) {
  for (const EquationResult& equation : found.equations) {
    for (const SpectralLine& line : equation.lines) {
      if (!is_of_the_data(line)) continue;
      return fmt::format(" A line stands in the data at {:.4g} Hz, {:.3g} {}.", line.frequency_Hz,
                         line.amplitude, equation.unit);
    }
  }
  return "";
}

}  // namespace

std::string verdict_sentence(const Identification& found, bool select) {
  return sentence_of_verdict(found, select) + run_sentence(found) + line_sentence(found);
}

std::string not_asked_sentence(const Identification& found) {
  if (found.not_asked.empty()) return "";
  return fmt::format("Not asked: {}.", fmt::join(found.not_asked, ", "));
}

}  // namespace torquewright::report
