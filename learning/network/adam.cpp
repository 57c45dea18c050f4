// SPDX-License-Identifier: Apache-2.0
#include "learning/network/adam.hpp"

#include <cmath>

namespace torquewright::learning {
namespace {

constexpr double kMeanDecay = 0.9;
constexpr double kSquareDecay = 0.999;
constexpr double kSmall = 1e-8;

}  // namespace

template <typename Scalar>
void Adam<Scalar>::step(const Vector& gradient, double rate, Vector& parameters) {
  ++steps;
  const auto count = static_cast<double>(steps);
  const auto old_mean = static_cast<Scalar>(kMeanDecay);
  const auto old_square = static_cast<Scalar>(kSquareDecay);
  mean = old_mean * mean + (Scalar(1) - old_mean) * gradient;
  square = old_square * square + (Scalar(1) - old_square) * gradient.cwiseAbs2();
  const auto mean_rate = static_cast<Scalar>(rate / (1.0 - std::pow(kMeanDecay, count)));
  const auto square_share = static_cast<Scalar>(1.0 / (1.0 - std::pow(kSquareDecay, count)));
  parameters.array() -= mean_rate * mean.array() /
                        ((square_share * square.array()).sqrt() + static_cast<Scalar>(kSmall));
}

template struct Adam<float>;
template struct Adam<double>;

}  // namespace torquewright::learning
