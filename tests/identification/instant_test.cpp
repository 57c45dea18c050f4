// SPDX-License-Identifier: Apache-2.0
// A sensor that is late by less than half a step of the log, beside an effect that is much larger
// than what that changes. Oracle: the law and the lateness of the closed form that made the log.
#include <gtest/gtest.h>

#include "identification/answer/analysis.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::instant_test {
namespace {

using made::Made;
using made::MadeBench;
using made::sign;

constexpr double kLate_s = 0.0017;  ///< Of a step of 5 ms.
constexpr double kErrors = 4.0;     ///< Standard errors.

EquationResult torque_of(const std::function<double(const Made&)>& law) {
  const MadeBench made;
  return analyse(made.rig, made.log(law, 0.01, kLate_s), 0, {&made.actuator}, {}).front();
}

void expect_value(const NamedEffect& named, const char* name, double true_value) {
  EXPECT_NEAR(named.parameters[name].get<double>(), true_value,
              kErrors * named.standard_error[name].get<double>())
      << name;
}

TEST(Instant, IsAskedAgainBesideALawThatHidIt) {
  const EquationResult result = torque_of([](const Made& at) { return -0.8 * at.speed_rad_s; });
  EXPECT_EQ(result.verdict, Verdict::kExplained);
  ASSERT_EQ(result.added.size(), 1U);
  EXPECT_EQ(result.added[0].effect, "viscous_friction");
  expect_value(result.added[0], "viscous_Nm_s_rad", 0.8);
}

}  // namespace
}  // namespace torquewright::identification::instant_test
