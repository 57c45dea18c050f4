// SPDX-License-Identifier: Apache-2.0
// Oracle: half a unit of the last decimal against a tenth of the number, by hand.
#include "actuator/lint/few_digits.hpp"

#include <gtest/gtest.h>

#include "actuator/motor/actuator.hpp"
#include "tests/actuator/lint/sample.hpp"

namespace torquewright::actuator::lint {
namespace {

std::vector<Finding> notes_on(double torque_constant_Nm_A) {
  Actuator document = sample();
  document.motor.torque_constant_Nm_A = torque_constant_Nm_A;
  return few_digits(document);
}

// 0.5 is 0.45 to 0.55, a tenth of it exactly; 0.4 is 0.35 to 0.45, an eighth of it.
TEST(FewDigits, AreSaidWhereTheyLeaveMoreThanATenthOpen) {
  EXPECT_EQ(few_digits(sample()).size(), 0u);
  EXPECT_EQ(notes_on(0.6).size(), 0u);
  ASSERT_EQ(notes_on(0.4).size(), 1u);
  const Finding note = notes_on(0.4).front();
  EXPECT_EQ(note.severity, Severity::kNote);
  EXPECT_EQ(note.rule, "few-digits");
  // With a zero more it would be 0.395 to 0.405: 1.25 %.
  EXPECT_EQ(
      note.sentence,
      "/motor/torque_constant_Nm_A says 0.4 (0.35 to 0.45) Nm/A: its decimals leave so much "
      "open that little can contradict it; if a zero more was printed, state {\"value\": 0.4, "
      "\"tolerance\": 0.0125}.");
}

TEST(FewDigits, AreNotSaidOfWhatSaysItsToleranceOrIsAssumed) {
  Actuator document = sample();
  document.motor.torque_constant_Nm_A = 1.0;
  EXPECT_EQ(few_digits(document).size(), 1u);
  Actuator tolerant = document;
  tolerant.statements.push_back(
      {"/motor/torque_constant_Nm_A", 1.0, std::nullopt, std::nullopt, 0.05, {}});
  EXPECT_EQ(few_digits(tolerant).size(), 0u);
  for (const char* assumed : {"/motor/torque_constant_Nm_A", "/motor"}) {
    document.assumed = {assumed};
    EXPECT_EQ(few_digits(document).size(), 0u) << assumed;
  }
}

}  // namespace
}  // namespace torquewright::actuator::lint
