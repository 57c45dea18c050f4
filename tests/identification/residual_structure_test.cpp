// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/residual_structure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace torquewright::identification::residual_structure_test {
namespace {

constexpr std::size_t kRuns = 4, kSamples = 1500;
constexpr double kStep_s = 0.01;

/// Runs that swing slowly, with a temperature that rises; the residual by a law of the instant.
struct Swings {
  std::vector<Signals> signals{kRuns};
  std::vector<ResidualTrace> traces;

  explicit Swings(const std::function<double(const actuator::Instant&, double)>& law) {
    std::mt19937_64 random(9);
    std::normal_distribution<double> noise;
    for (std::size_t r = 0; r < kRuns; ++r) {
      Signals& run = signals[r];
      run.step_s = kStep_s;
      ResidualTrace trace{&run, {}, {}, r};
      for (std::size_t i = 0; i < kSamples; ++i) {
        const double t = kStep_s * static_cast<double>(i);
        const double rate = 1.3 + 0.2 * static_cast<double>(r);
        actuator::Instant at;
        at.output_angle_rad = std::sin(rate * t);
        at.motor_angle_rad = 10.0 * at.output_angle_rad;
        at.speed_rad_s = rate * std::cos(rate * t);
        at.acceleration_rad_s2 = -rate * rate * std::sin(rate * t);
        at.direction = at.speed_rad_s > 0.0 ? 1.0 : -1.0;
        at.current_A = std::sin(3.1 * t + static_cast<double>(r));
        at.load_torque_Nm = at.current_A;
        at.winding_temperature_K = 300.0 + t;
        run.at.push_back(at);
        run.time_s.push_back(t);
        trace.index.push_back(i);
        trace.value.push_back(law(at, noise(random)));
      }
      traces.push_back(std::move(trace));
    }
  }
};

const ResidualStructure& of(const std::vector<ResidualStructure>& found,
                            const std::string& coordinate, bool times_direction) {
  return *std::find_if(found.begin(), found.end(), [&](const ResidualStructure& each) {
    return each.coordinate == coordinate && each.times_direction == times_direction;
  });
}

// Oracle: closed form. A residual of two levels +-a over the current and noise of variance s^2
// leaves s^2 of a^2 + s^2. The bins hold equally many rows and their middle edge is the median, 0
// up to the sampling of the sine, so that hardly a row lies in a bin of both signs: 0.03 for those
// rows and the table's own error (16 levels from 4500 rows).
TEST(Structures, ShareIsTheVarianceThatVariesWithTheCoordinate) {
  const double a = 1.0, s = 0.7;
  const Swings swings([&](const actuator::Instant& at, double noise) {
    return (at.current_A > 0.0 ? a : -a) + s * noise;
  });
  const auto found = residual_structures(swings.traces);
  const ResidualStructure& current = of(found, "motor_current_A", false);
  EXPECT_NEAR(current.share, a * a / (a * a + s * s), 0.03);
  EXPECT_TRUE(is_significant(current));
  EXPECT_NEAR(current.level.front(), -a, 5.0 * s / std::sqrt(kRuns * kSamples / 16.0));
  EXPECT_NEAR(current.level.back(), a, 5.0 * s / std::sqrt(kRuns * kSamples / 16.0));
}

// Oracle: closed form. A friction of 2 at a share p of the angles changes sign with the direction:
// nothing along the angle itself; along the angle times the direction 4 p of 4 p + s^2, less what
// the one bin of 16 that holds both levels cannot follow, at most 4 / 4 / 16. The noise's own
// square is known to sqrt(2/6000), 0.001 of all: four times that.
TEST(Structures, FrictionLikeIsSeenTimesTheDirectionOnly) {
  const double s = 0.3;
  const auto is_tight = [](const actuator::Instant& at) { return at.output_angle_rad > 0.3; };
  const Swings swings([&](const actuator::Instant& at, double noise) {
    return -at.direction * (is_tight(at) ? 2.0 : 0.0) + s * noise;
  });
  double tight_square = 0.0;
  for (const Signals& run : swings.signals) {
    tight_square += 4.0 *
                    static_cast<double>(std::count_if(run.at.begin(), run.at.end(), is_tight)) /
                    static_cast<double>(kRuns * kSamples);
  }
  const auto found = residual_structures(swings.traces);
  const double all = tight_square + s * s;
  const double share = of(found, "output_position_rad", true).share;
  EXPECT_LE(share, tight_square / all + 0.004);
  EXPECT_GE(share, (tight_square - 1.0 / 16.0) / all - 0.004);
  EXPECT_LT(of(found, "output_position_rad", false).share, 0.05);
}

// White noise: by construction of the test (39 shifts) a coordinate of 22 is called significant
// with a probability of no more than 0.05 even if its share came to 5 %; of 6000 rows it does not.
TEST(Structures, OfNoiseAreNotSignificant) {
  const Swings swings([](const actuator::Instant&, double noise) { return noise; });
  for (const ResidualStructure& each : residual_structures(swings.traces)) {
    EXPECT_FALSE(is_significant(each)) << each.coordinate << " " << each.share;
  }
}

// What differs from run to run only is no structure along anything that all runs share: the share
// is of runs that were left out.
TEST(Structures, AConstantOfOneRunIsNoStructure) {
  Swings swings([](const actuator::Instant&, double noise) { return 0.1 * noise; });
  for (double& value : swings.traces[0].value) value += 1.0;
  for (const char* name : {"output_position_rad", "motor_current_A", "output_velocity_rad_s"}) {
    EXPECT_FALSE(is_significant(of(residual_structures(swings.traces), name, false))) << name;
  }
}

}  // namespace
}  // namespace torquewright::identification::residual_structure_test
