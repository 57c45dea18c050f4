// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "actuator/check/check.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/actuator/check/simple_actuator.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator::check_test {

/// A motion of joint k, checked against one actuator.
class Checked {
 public:
  explicit Checked(Actuator actuator = test::simple_actuator()) : actuator_(std::move(actuator)) {
    request_.drives = {{"k", &actuator_, {}}};
  }
  CheckRequest& request() { return request_; }

  CheckReport report(const std::string& text) {
    request_.trajectory = folder_.write("m.csv", text);
    return check(request_);
  }
  std::string refusal(const std::string& text) {
    return test::refusal([&] { report(text); }, folder_.path());
  }

 private:
  test::ScratchFolder folder_;
  Actuator actuator_;
  CheckRequest request_;
};

/// Of time, over one second.
using Function = double (*)(double);

inline std::string motion(int intervals, Function position, Function velocity, Function torque) {
  std::string text = "time_s";
  if (position != nullptr) text += ",k_position_rad";
  if (velocity != nullptr) text += ",k_velocity_rad_s";
  if (torque != nullptr) text += ",k_torque_Nm";
  for (int i = 0; i <= intervals; ++i) {
    const double t = static_cast<double>(i) / intervals;
    text += fmt::format("\n{}", t);
    for (const Function function : {position, velocity, torque}) {
      if (function != nullptr) text += fmt::format(",{}", function(t));
    }
  }
  return text + "\n";
}

inline bool has_finding(const CheckReport& report, const std::string& rule, Severity severity) {
  for (const Finding& finding : report.findings) {
    if (finding.rule == rule && finding.severity == severity) return true;
  }
  return false;
}

}  // namespace torquewright::actuator::check_test
