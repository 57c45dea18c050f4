// SPDX-License-Identifier: Apache-2.0
// Oracle: the equations' own verdicts, from which the sentence has to follow.
#include "src/report/identification/identification_verdict.hpp"

#include <gtest/gtest.h>

namespace torquewright::report {
namespace {

using namespace identification;

EquationResult equation(const char* quantity, Verdict verdict,
                        const std::vector<std::string>& added = {},
                        const std::vector<std::string>& not_told_apart = {}) {
  EquationResult result;
  result.quantity = quantity;
  result.unit = "Nm";
  result.verdict = verdict;
  for (const std::string& name : added) {
    result.added.emplace_back();
    result.added.back().effect = name;
  }
  if (!not_told_apart.empty()) result.confounded.push_back({not_told_apart, false, "", ""});
  return result;
}

EquationResult varying_with(EquationResult result, const char* coordinate) {
  result.structure_after.push_back({coordinate, false, 0.5, 0.01, {}, {}});
  return result;
}

Identification identification_of(Verdict verdict, std::vector<EquationResult> equations) {
  Identification found;
  found.verdict = verdict;
  found.equations = std::move(equations);
  return found;
}

TEST(VerdictSentence, NamesWhatIsCertainAndKeepsWhatIsNotToldApart) {
  const Identification found = identification_of(
      Verdict::kPartlyExplained,
      {equation("output_torque_Nm", Verdict::kCannotTell, {"a", "b"}, {"b", "c"}),
       varying_with(equation("winding_voltage_V", Verdict::kPartlyExplained, {"d"}), "time_s")});
  EXPECT_EQ(
      verdict_sentence(found, true),
      "Missing from the model: a, d. The log cannot tell b and c apart. That is not all: what "
      "is left of winding_voltage_V varies most with time_s (50 % of its square).");
}

TEST(VerdictSentence, SaysWhatIsCertainBesideWhatIsNotToldApart) {
  const Identification found = identification_of(
      Verdict::kCannotTell,
      {equation("output_torque_Nm", Verdict::kCannotTell, {"a", "b"}, {"b", "c"})});
  EXPECT_EQ(verdict_sentence(found, true),
            "Missing from the model: a. The log cannot tell b and c apart.");
}

TEST(VerdictSentence, NamesTheRunThatDoesNotFitTheOthers) {
  EquationResult equation_of_runs = equation("motor_current_A", Verdict::kUnexplained, {}, {});
  equation_of_runs.unit = "A";
  equation_of_runs.noise_floor_rms = 0.02;
  for (const double rms_A : {0.03, 0.02, 1.3}) {
    RunResult& run = equation_of_runs.runs.emplace_back();
    run.run = rms_A > 1.0 ? "run3" : "another";
    run.rms_after = rms_A;
  }
  const auto sentence = [&] {
    return verdict_sentence(identification_of(Verdict::kUnexplained, {equation_of_runs}), true);
  };
  EXPECT_NE(sentence().find("It is run3 alone: 1.3 A are left in it, in any other run 0.03 A"),
            std::string::npos)
      << sentence();
  equation_of_runs.runs[0].rms_after = 1.0;
  EXPECT_EQ(sentence().find("alone"), std::string::npos);
}

// What is left of an equation that is explained is noise: it is not what is left.
TEST(VerdictSentence, SpeaksOfTheEquationThatIsOpen) {
  const Identification found = identification_of(
      Verdict::kPartlyExplained,
      {varying_with(equation("output_torque_Nm", Verdict::kExplained, {"a"}), "motor_current_A"),
       varying_with(equation("winding_voltage_V", Verdict::kUnexplained), "time_s")});
  EXPECT_EQ(verdict_sentence(found, true),
            "Missing from the model: a; that is not all: what is left of winding_voltage_V varies "
            "most with time_s (50 % of its square).");
}

TEST(VerdictSentence, SaysWhichEquationTheLogCannotTell) {
  Identification found = identification_of(
      Verdict::kCannotTell, {equation("output_torque_Nm", Verdict::kExplained, {"a"}),
                             equation("winding_voltage_V", Verdict::kCannotTell)});
  found.equations[1].unusable = "too short";
  EXPECT_EQ(verdict_sentence(found, true),
            "Missing from the model: a. The log cannot tell of winding_voltage_V: too short.");
}

TEST(VerdictSentence, BlamesNotTheLibraryForWhatWasNotAsked) {
  Identification found = identification_of(
      Verdict::kUnexplained,
      {varying_with(equation("output_torque_Nm", Verdict::kUnexplained), "time_s")});
  EXPECT_NE(verdict_sentence(found, true).find("no effect of the library explains"),
            std::string::npos);
  EXPECT_EQ(not_asked_sentence(found), "");
  found.not_asked = {"a", "b"};
  EXPECT_NE(verdict_sentence(found, true).find("no effect that was asked explains"),
            std::string::npos);
  EXPECT_EQ(not_asked_sentence(found), "Not asked: a, b.");
}

// What varies with nothing that the model knows may be a sensor's noise: no model is wrong for it.
TEST(VerdictSentence, CallsNoModelWrongForWhatGoesWithNothing) {
  const Identification found = identification_of(
      Verdict::kUnexplained, {equation("output_torque_Nm", Verdict::kUnexplained)});
  const std::string said = verdict_sentence(found, true);
  EXPECT_EQ(said.find("wrong"), std::string::npos);
  EXPECT_NE(said.find("noise of a sensor that is not white"), std::string::npos);
}

TEST(VerdictSentence, SaysWhatNoLogOfSuchARigTellsAndWhatIsInDoubt) {
  EquationResult torque = equation("output_torque_Nm", Verdict::kCannotTell, {"a", "b", "c", "e"});
  torque.confounded.push_back({{"b", "d"}, true, "", "another"});
  torque.added[2].doubt = torque.added[3].doubt = "it raises the error";
  EXPECT_EQ(
      verdict_sentence(identification_of(Verdict::kCannotTell, {torque}), true),
      "Missing from the model: a. No log of such a rig tells b and d apart. Not sure of c, e: it "
      "raises the error.");
}

TEST(VerdictSentence, TellsOfALineOfTheData) {
  Identification found = identification_of(
      Verdict::kNothingMissing, {equation("output_torque_Nm", Verdict::kNothingMissing)});
  SpectralLine line;
  line.frequency_Hz = 16.85;
  line.amplitude = 0.12;
  line.keeps_to = LineKeepsTo::kMotion;
  found.equations[0].lines = {line};
  const std::string noise = verdict_sentence(found, true);
  found.equations[0].lines[0].keeps_to = LineKeepsTo::kTime;
  EXPECT_EQ(verdict_sentence(found, true),
            noise + " A line stands in the data at 16.85 Hz, 0.12 Nm.");
}

}  // namespace
}  // namespace torquewright::report
