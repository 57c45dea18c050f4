// SPDX-License-Identifier: Apache-2.0
// Oracle: what the words mean. A value within its own error says nothing where 0 is nothing.
#include "identification/findings/undetermined.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace torquewright::identification {
namespace {

NamedEffect load_friction(double driving, double its_error, double driven, double its_error_too) {
  NamedEffect named;
  named.effect = "load_dependent_friction";
  named.parameters.numbers = {{"driving_coefficient", driving, its_error},
                              {"backdriving_coefficient", driven, its_error_too}};
  return named;
}

TEST(UndeterminedParameters, AreThoseWithinTheirOwnError) {
  EXPECT_EQ(undetermined_parameters(load_friction(0.087, 0.0002, 0.18, 0.91)),
            std::vector<std::string>{"backdriving_coefficient"});
  EXPECT_TRUE(undetermined_parameters(load_friction(0.087, 0.0002, 0.18, 0.01)).empty());
  const NamedEffect written = with_what_is_determined(load_friction(0.087, 0.0002, 0.18, 0.91));
  EXPECT_EQ(written.parameters.value("driving_coefficient", NAN), 0.087);
  EXPECT_EQ(written.parameters.value("backdriving_coefficient", NAN), 0.0);
}

// A factor of the torque constant is 1 without the effect; what has no error was not fitted.
TEST(UndeterminedParameters, AreNoneWhereZeroIsSomething) {
  NamedEffect constant;
  constant.effect = "torque_constant_error";
  constant.parameters.numbers = {{"factor", 0.9, 2.0}};
  EXPECT_TRUE(undetermined_parameters(constant).empty());
  const NamedEffect without_error = load_friction(0.087, 0.0002, 0.18, NAN);
  EXPECT_TRUE(undetermined_parameters(without_error).empty());
}

}  // namespace
}  // namespace torquewright::identification
