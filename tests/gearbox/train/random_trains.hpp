// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>

#include "gearbox/train/power_flow.hpp"

namespace torquewright::gearbox::test {

/// A 3K train by its basic ratios and the efficiencies of its meshes.
struct RandomTrain {
  double ratio_1, ratio_2;
  ThreeKMeshEfficiencies<double> mesh;
};

/// Trains of any power flow. |1 - I2| stays above 1e-3: a rounding grows a thousandfold at most.
class RandomTrains {
 public:
  explicit RandomTrains(unsigned seed) : random_(seed) {}

  RandomTrain next() {
    const double ratio_1 = std::uniform_real_distribution<double>(0.5, 9.0)(random_);
    double ratio_2 = 1.0;
    while (std::abs(ratio_2 - 1.0) < 1e-3) {
      ratio_2 = std::uniform_real_distribution<double>(0.2, 1.8)(random_);
    }
    return {ratio_1, ratio_2, {efficiency(), efficiency(), efficiency()}};
  }

 private:
  double efficiency() { return std::uniform_real_distribution<double>(0.9, 0.9999)(random_); }

  std::mt19937 random_;
};

}  // namespace torquewright::gearbox::test
