// SPDX-License-Identifier: Apache-2.0
// Oracle: integrals of straight lines by hand.
#include "hopper/demand/running_integral.hpp"

#include <gtest/gtest.h>

namespace torquewright::hopper {
namespace {

TEST(RunningIntegral, IsExactForStraightLinesBetweenUnevenSamples) {
  const std::vector<double> times_s{0, 1, 3};
  Eigen::MatrixXd signals(2, 3);
  signals << 0, 2, 2, 1, 1, -1;
  const RunningIntegral integral(times_s, signals);
  // First: 2t up to 1, then 2. Second: 1 up to 1, then 1 - (t - 1).
  EXPECT_DOUBLE_EQ(integral.over(0, 0.5)[0], 0.25);
  EXPECT_DOUBLE_EQ(integral.over(0, 2.0)[0], 1.0 + 2.0);
  EXPECT_DOUBLE_EQ(integral.over(0, 2.0)[1], 1.0 + 0.5);
  EXPECT_DOUBLE_EQ(integral.over(1, 1.0)[1], 0.5);
  EXPECT_DOUBLE_EQ(integral.over(1, 9.0)[1], 0.0);  // ends with the samples
}

TEST(RunningIntegral, CountsAnImpulseInEveryWindowThatHoldsIt) {
  const std::vector<double> times_s{0, 1, 1, 2};  // an impact at 1 has two rows
  const Eigen::MatrixXd signals = Eigen::MatrixXd::Zero(1, 4);
  RunningIntegral integral(times_s, signals);
  integral.add_impulse(2, Eigen::VectorXd::Constant(1, 5.0));
  EXPECT_EQ(integral.over(0, 0.9)[0], 0.0);
  EXPECT_EQ(integral.over(0, 1.0)[0], 5.0);
  EXPECT_EQ(integral.over(1, 0.1)[0], 5.0);
  EXPECT_EQ(integral.over(2, 0.1)[0], 5.0);
  EXPECT_EQ(integral.over(3, 0.1)[0], 0.0);
}

}  // namespace
}  // namespace torquewright::hopper
