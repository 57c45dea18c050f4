// SPDX-License-Identifier: Apache-2.0
// What each other interpretation makes of a number. Oracle: the conversions of a sinusoidal machine
// of flux linkage times pole pairs k: Kt = sqrt(3) k, 1.5 k, 1.5 sqrt(2) k per dc, peak and rms
// ampere; Ke = sqrt(3) k, k, sqrt(3/2) k, sqrt(1/2) k line peak, phase peak, line rms, phase rms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "tests/actuator/lint/sample.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr double kRoundOff = 1e-12;

void expect_interpretation(const Finding& finding, const std::string& sentence, double expected) {
  const Explanation one = explanation(finding, sentence);
  ASSERT_TRUE(one.expected);
  EXPECT_NEAR(one.expected->value, expected, kRoundOff * expected) << sentence;
}

TEST(EmfInterpretations, CoverTwelvePairsOfConstants) {
  Actuator document = sample();
  document.motor.back_emf_constant_V_s_rad = 0.9;
  const auto emf = finding(document, "back-emf-constant");
  ASSERT_TRUE(emf);
  const std::map<std::string, double> kTorque{
      {"dc", std::sqrt(3.0)}, {"peak", 1.5}, {"rms", 1.5 * std::sqrt(2.0)}};
  const std::map<std::string, double> kEmf{{"line-to-line peak", std::sqrt(3.0)},
                                           {"phase peak", 1.0},
                                           {"line-to-line rms", std::sqrt(1.5)},
                                           {"phase rms", std::sqrt(0.5)}};
  for (const auto& [ampere, torque] : kTorque) {
    for (const auto& [measure, volts] : kEmf) {
      if (ampere == "dc" && measure == "line-to-line peak") continue;  // the document's own
      expect_interpretation(*emf,
                            "torque constant per " + ampere + " ampere, back-EMF as " + measure,
                            0.125 / torque * volts);
    }
  }
}

TEST(SpeedInterpretations, UseTheStatedBackEmfWhereThereIsOne) {
  Actuator document = sample();
  document.motor.torque_constant_convention = CurrentConvention::kPeakPhase;
  document.motor.back_emf_constant_V_s_rad = 0.0833;
  document.datasheet->no_load_speed_rad_s = 29;
  const auto speed = finding(document, "no-load-speed");
  ASSERT_TRUE(speed);
  EXPECT_NEAR(speed->expected.value, 24 / std::sqrt(3.0) / 0.833, 1e-12 * 20);
  expect_interpretation(*speed, "back-EMF constant as line-to-line peak", 24 / 0.833);
  EXPECT_EQ(explanation(*speed, "back-EMF constant as line-to-line peak").fit, Agreement::kFits);
}

TEST(StallInterpretations, ExchangeTerminalsAmperesAndLimits) {
  Actuator document = sample();
  document.datasheet->stall_current_A = 40;
  const auto stall = finding(document, "stall-current");
  ASSERT_TRUE(stall);
  expect_interpretation(*stall, "resistance of one phase", 48);
  expect_interpretation(*stall, "current in peak amperes, torque constant per dc ampere",
                        96 * 2 / std::sqrt(3.0));
  expect_interpretation(*stall, "stall at the drive's peak current", 40);
  EXPECT_EQ(explanation(*stall, "stall at the drive's peak current").fit, Agreement::kFits);
}

TEST(TorqueInterpretations, ExchangeSidesLossesAndAmperes) {
  Actuator document = sample();
  document.datasheet->peak_torque_Nm = 5;
  const auto torque = finding(document, "peak-torque");
  ASSERT_TRUE(torque);
  expect_interpretation(*torque, "data sheet at the motor", 5);
  expect_interpretation(*torque, "without the gears' losses", 50);
  expect_interpretation(*torque, "current in rms amperes, torque constant per dc ampere",
                        47.5 * std::sqrt(2.0) * std::sqrt(3.0) / 2.0);
}

TEST(TorqueInterpretations, AllowForLossesUpToAShare) {
  Actuator document = sample();
  document.datasheet->peak_torque_Nm = 40;  // 47.5 less 15.8 %: saturation and tolerance
  EXPECT_EQ(finding(document, "peak-torque")->severity, Severity::kNote);
  document.datasheet->peak_torque_Nm = 33;  // 47.5 less 30.5 %; 33.5 of 47.06: 28.8 % at least
  const auto torque = finding(document, "peak-torque");
  ASSERT_TRUE(torque);
  EXPECT_EQ(torque->severity, Severity::kWarning);
  ASSERT_FALSE(torque->explanations.empty());
  const Explanation& losses = torque->explanations.back();
  EXPECT_NE(losses.sentence.find("take 30.5 % ("), std::string::npos) << losses.sentence;
  document.datasheet->peak_torque_Nm = 32;  // 32.5 of 47.06: 30.9 % at least
  EXPECT_EQ(finding(document, "peak-torque")->severity, Severity::kViolation);
}

TEST(PowerInterpretations, TellShaftFromBus) {
  Actuator document = sample();
  document.datasheet->peak_power_W = 961;
  const auto power = finding(document, "peak-power");
  ASSERT_TRUE(power);
  expect_interpretation(*power, "power drawn from the bus, not at the shaft", 24 * 40);
}

TEST(InertiaInterpretations, TellRotorFromJoint) {
  Actuator document = sample();
  document.datasheet->reflected_inertia_kg_m2 = 0.0045;
  const auto inertia = finding(document, "reflected-inertia");
  ASSERT_TRUE(inertia);
  expect_interpretation(*inertia, "the rotor's own inertia, not carried to the joint", 0.00045);
  expect_interpretation(*inertia, "carried over by the ratio instead of its square", 0.0045);
}

// By hand: 100 J is 0.045, at most 0.0455; the rest of 0.06 may be the gears', of 0.12 it would be
// more than the rotor's own, and of 0.03 there is none.
TEST(InertiaInterpretations, LeaveTheGearsAsMuchAsTheRotor) {
  Actuator document = sample();
  const char* kGears = "inertia of the gears beyond what is stated, of";
  const auto offers = [&](double stated_kg_m2) {
    document.datasheet->reflected_inertia_kg_m2 = stated_kg_m2;
    const Finding inertia = finding(document, "reflected-inertia").value();
    return std::any_of(inertia.explanations.begin(), inertia.explanations.end(),
                       [&](const Explanation& one) { return one.sentence == kGears; });
  };
  EXPECT_FALSE(offers(0.03));
  EXPECT_FALSE(offers(0.12));
  EXPECT_TRUE(offers(0.06));
  expect_interpretation(finding(document, "reflected-inertia").value(), kGears, 0.015);
}

TEST(ChargeInterpretations, FindTheStateOfChargeOfTheBus) {
  Actuator document = sample();
  document.battery = Battery{};
  document.battery->series_cells = 16;
  document.battery->cell_open_circuit = {{0.0, 3.0}, {0.5, 3.6}, {1.0, 4.2}};
  document.drive.bus_voltage_V = 57.6;
  const auto voltage = finding(document, "bus-voltage");
  ASSERT_TRUE(voltage);
  expect_interpretation(*voltage, "the battery at a state of charge of 0.5", 57.6);
  expect_interpretation(*voltage, "the battery at a state of charge of 0", 48);
  EXPECT_EQ(voltage->severity, Severity::kWarning);
}

TEST(ChargeInterpretations, NameTheCellVoltageThatTheBusWouldBe) {
  Actuator document = sample();
  document.battery = Battery{};
  document.battery->cell_open_circuit = {{1.0, 4.2}};
  document.battery->series_cells = 6;
  EXPECT_EQ(finding(document, "bus-voltage")->severity, Severity::kWarning);  // 4 V
  document.battery->series_cells = 9;                                         // 2.67 V
  EXPECT_EQ(finding(document, "bus-voltage")->severity, Severity::kWarning);
  document.battery->series_cells = 10;  // 2.4 V
  EXPECT_EQ(finding(document, "bus-voltage")->severity, Severity::kViolation);
}

TEST(Explanations, CallALowSpeedLoadedDownToHalf) {
  Actuator document = sample();  // 19.2 rad/s, from 19.1235
  document.datasheet->no_load_speed_rad_s = 9.52;
  const char* kLoaded = "a loaded or capped speed, not the no-load speed";
  const auto half = finding(document, "no-load-speed");
  ASSERT_TRUE(half);
  EXPECT_NE(half->explanations.front().sentence, kLoaded);
  document.datasheet->no_load_speed_rad_s = 9.57;
  EXPECT_EQ(finding(document, "no-load-speed")->explanations.front().sentence, kLoaded);
}

// A document without field weakening excludes it; with it, what it can do is counted already.
TEST(Explanations, NeverOfferFieldWeakening) {
  Actuator document = sample();
  document.datasheet->no_load_speed_rad_s = 110;
  for (const bool field_weakening : {false, true}) {
    document.drive.field_weakening = field_weakening;
    document.motor.inductance_d_H = 0.000125;
    const Finding speed = finding(document, "no-load-speed").value();
    EXPECT_TRUE(std::none_of(speed.explanations.begin(), speed.explanations.end(),
                             [](const Explanation& one) {
                               return one.sentence.find("weakening") != std::string::npos;
                             }));
  }
}

// A no-load current that takes the whole voltage leaves no speed: a finding, no share of anything.
TEST(Explanations, StandANoLoadCurrentBeyondStall) {
  Actuator document = sample();
  document.datasheet->no_load_current_A = 120;
  document.datasheet->no_load_speed_rad_s = 19;
  const auto speed = finding(document, "no-load-speed");
  ASSERT_TRUE(speed);
  EXPECT_EQ(speed->sentence.find("nan"), std::string::npos);
  EXPECT_EQ(speed->sentence.find("rounding allowed for"), std::string::npos) << speed->sentence;
}

// A field that can be weakened to nothing sets no upper end, whichever ampere the torque constant
// counts; the lower ends differ, so that each reading is another. By hand: 24 / (sqrt(3) Ke 10)
// with Ke = Kt sqrt(2) / 3 per rms ampere.
TEST(Interpretations, ThatShareOneEndAreStillTwo) {
  Actuator document = sample();
  document.motor.inductance_d_H = 0.000125;
  document.drive.field_weakening = true;
  document.drive.peak_current_A = 60;
  document.datasheet->no_load_speed_rad_s = 12;
  expect_interpretation(finding(document, "no-load-speed").value(),
                        "torque constant per rms ampere, svpwm modulation",
                        24 / std::sqrt(3.0) / (1.25 * std::sqrt(2.0) / 3.0));
}

TEST(Interpretations, NeverTouchTheDocumentsOwnNumbers) {
  const Actuator document = sample();
  for (const Interpreter interpret :
       {speed_interpretations, emf_interpretations, ampere_interpretations, ohm_interpretations,
        side_interpretations}) {
    for (const Interpretation& interpretation : interpret(as_stated(document))) {
      EXPECT_EQ(interpretation.document.motor.torque_constant_Nm_A,
                document.motor.torque_constant_Nm_A);
      EXPECT_EQ(interpretation.document.motor.resistance_ohm, document.motor.resistance_ohm);
      EXPECT_FALSE(interpretation.sentence.empty());
    }
  }
}

}  // namespace
}  // namespace torquewright::actuator::lint
