// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/gear_words.hpp"

#include <fmt/format.h>

namespace torquewright::report {
namespace {

constexpr double kNotable = 1e-3;  // of the load: less changes no digit of it

std::string impact_words(const hopper::WindowLoad& joint) {
  const double impact_Nm = joint.mean - joint.without_impulses;
  if (!(impact_Nm > kNotable * joint.mean)) return "";
  return fmt::format(", {:.4g} Nm of it an impact's, added by size", impact_Nm);
}

}  // namespace

std::string gear_words(const hopper::TransmissionLoad& load, const std::string& time) {
  return fmt::format(
      "{:.4g} Nm at the joint, {:.4g} Nm at the motor pass them over {:g} ms (from t = {} s){}{}",
      load.joint.mean, load.motor.mean, 1e3 * load.window_s, time, impact_words(load.joint),
      load.limit ? fmt::format(": {}", actuator::name_of(load.verdict)) : "");
}

}  // namespace torquewright::report
