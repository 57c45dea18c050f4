// SPDX-License-Identifier: Apache-2.0
// Oracle: the policy itself, beside the header compiled by another compiler as C99, C89's
// declarations and warnings on, and as C++.
#include "hopper/policy/c_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>

#include "tests/hopper/policy/sample_policies.hpp"

namespace torquewright::hopper {
namespace {

namespace fs = std::filesystem;

constexpr Eigen::Index kHeaderViews = 50;

constexpr const char* kMain = R"(
#include <stdio.h>
#include "policy.h"
int main(void) {
  float seen[POLICY_INPUTS], action[POLICY_OUTPUTS], target[POLICY_OUTPUTS];
  long period;
  for (period = 0;; ++period) {
    int i;
    for (i = 0; i < POLICY_INPUTS; ++i) {
      if (scanf("%f", &seen[i]) != 1) return 0;
    }
    policy_action(seen, action);
    policy_target(action, PERIOD target);
    for (i = 0; i < POLICY_OUTPUTS; ++i) printf("%.9g %.9g\n", action[i], target[i]);
  }
}
)";

/// Of numbers above 1 as a share.
double difference(double found, double expected) {
  return std::abs(found - expected) / std::max(1.0, std::abs(expected));
}

/// Greatest difference between what the compiled header and the policy say of observations.
double greatest_difference(const PolicyDocument& document, const std::string& compile) {
  const fs::path folder = fs::path(testing::TempDir()) / "policy_header";
  fs::create_directories(folder);
  std::ofstream(folder / "policy.h") << c_source_of(document, {"a \\", "line\nbreak"});
  std::ofstream(folder / "main.c") << kMain;
  const Eigen::MatrixXd views = test::sample_observations(document, kHeaderViews);
  std::ofstream(folder / "in") << std::setprecision(9) << views.transpose() << "\n";
  const bool goes_by_time = !document.outputs[0].course.empty();
  const std::string command = "cd " + folder.string() + " && " + compile +
                              (goes_by_time ? " '-DPERIOD=period,'" : " -DPERIOD=") +
                              " -o policy -lm && ./policy < in > out";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::ifstream out(folder / "out");
  learning::PolicyEvaluation policy(document.policy);
  double greatest = 0.0;
  for (Eigen::Index period = 0; period < views.cols(); ++period) {
    const Eigen::VectorXd action = policy.action(views.col(period));
    const Eigen::VectorXd target = test::target_of(document, action, period);
    for (Eigen::Index i = 0; i < action.size(); ++i) {
      double found_action = 1e9;
      double found_target = 1e9;
      out >> found_action >> found_target;
      greatest = std::max(
          {greatest, difference(found_action, action(i)), difference(found_target, target(i))});
    }
  }
  return greatest;
}

// Floats in sums of up to 16 numbers.
constexpr double kHeaderTolerance = 1e-6;

TEST(PolicyHeader, SaysInCWhatThePolicySays) {
  for (const PolicyDocument& document : test::sample_policies()) {
    EXPECT_LT(greatest_difference(
                  document, TORQUEWRIGHT_CC " -std=c99 -O1 -Wall -Wextra -Werror -pedantic main.c"),
              kHeaderTolerance);
  }
}

TEST(PolicyHeader, GoesByACourseOfTargets) {
  PolicyDocument document = test::sample_policies()[4];
  document.outputs[0].course = {0.5, -1.0, 2.0};
  document.outputs[1].course = {0.1};
  EXPECT_LT(greatest_difference(
                document, TORQUEWRIGHT_CC " -std=c99 -O1 -Wall -Wextra -Werror -pedantic main.c"),
            kHeaderTolerance);
}

TEST(PolicyHeader, SaysInCxxWhatThePolicySays) {
  EXPECT_LT(greatest_difference(test::sample_policies()[7], TORQUEWRIGHT_CXX
                                " -std=c++11 -O1 -Wall -Wextra -Werror -pedantic -x c++ main.c"),
            kHeaderTolerance);
}

}  // namespace
}  // namespace torquewright::hopper
