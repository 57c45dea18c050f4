// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/velocity_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace torquewright::actuator {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr double kFactorTolerance = 0.1;  // relative, for a factor to count as a known one

/// It goes with the position's slope but for a constant that stands out of their scatter.
bool has_offset(const VelocityAgreement& agreement) {
  return agreement.correlation_about_means() >= kAgreement &&
         is_plain_factor(agreement.factor_about_means()) &&
         std::abs(agreement.offset_rad_s()) > agreement.scatter_rad_s();
}

/// What a velocity that is not the rate of its position looks like.
std::string likely_cause(const VelocityAgreement& agreement) {
  if (has_offset(agreement)) {
    return fmt::format("it seems to be d(position)/dt and an offset of {:.4g} rad/s",
                       agreement.offset_rad_s());
  }
  const double factor = agreement.factor();
  if (agreement.correlation() >= kAgreement && !is_plain_factor(factor)) {
    return fmt::format("it is {:.4g} times d(position)/dt{}", factor, cause_of_factor(factor));
  }
  return "one of the columns may be dead, late or another joint's, or a position noisy";
}

}  // namespace

bool is_plain_factor(double factor) {
  return factor <= kPlainFactor && factor >= 1.0 / kPlainFactor;
}

std::string cause_of_factor(double factor) {
  constexpr double kTurn_rad = 2.0 * std::numbers::pi;
  struct Known {
    double factor;
    const char* cause;
  };
  static constexpr Known kKnown[] = {
      {kDegreesPerRadian,
       "; it seems to be in degrees, the position in rad; or the position is in rad and was taken "
       "for degrees"},
      {1.0 / kDegreesPerRadian,
       "; the position seems to be in degrees, or the velocity is in rad/s and was taken for "
       "deg/s"},
      {60.0 / kTurn_rad, "; it seems to be in revolutions per minute, the position in rad"},
      {1.0 / kTurn_rad, "; it seems to be in turns, the position in rad"},
      {kTurn_rad, "; the position seems to be in turns"},
      {-1.0, "; their signs differ"}};
  for (const Known& known : kKnown) {
    if (std::abs(factor / known.factor - 1.0) < kFactorTolerance) return known.cause;
  }
  return "";
}

std::string contradiction_sentence(const std::string& joint,
                                   const TravelContradiction& contradiction, double clock_origin_s,
                                   const VelocityAgreement& agreement) {
  return fmt::format(
      "the velocity of {0} is not the rate of its position: from t = {1:.6g} s to {2:.6g} s the "
      "position changes by {3:.4g} rad and the integral of the velocity by {4:.4g} rad; {5}. Mend "
      "the column that is wrong (--column states a unit and a factor), or take {0}'s velocity out "
      "of the file: then the slopes of the position are taken",
      joint, clock_origin_s + contradiction.from_s, clock_origin_s + contradiction.until_s,
      contradiction.position_change_rad, contradiction.velocity_integral_rad,
      likely_cause(agreement));
}

}  // namespace torquewright::actuator
