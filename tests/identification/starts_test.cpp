// SPDX-License-Identifier: Apache-2.0
#include "identification/replay/starts.hpp"

#include <gtest/gtest.h>

namespace torquewright::identification {
namespace {

TEST(Starts, SayWhereTheyAgree) {
  EXPECT_EQ(sentence_of({3, 2, {{"exponent", 0.02}, {"saturation_current_A", 1.5}}}),
            " Sought from 3 starts, of which 2 agree (exponent within 0.02, saturation_current_A "
            "within 1.5).");
}

TEST(Starts, OneAloneAgreesWithNothing) {
  EXPECT_EQ(sentence_of({3, 1, {{"exponent", 0.0}}}),
            " Sought from 3 starts, of which 1 found the best value.");
}

}  // namespace
}  // namespace torquewright::identification
