// SPDX-License-Identifier: Apache-2.0
#include "identification/recordings/joint_state_reader.hpp"

#include <fmt/format.h>

#include "identification/recordings/cdr.hpp"
#include "identification/recordings/joint_state_json.hpp"

namespace torquewright::identification {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

std::string read_cdr(std::string_view bytes, JointState& state) {
  Cdr cdr(bytes);
  if (!cdr.is_known()) {
    return fmt::format("is written as CDR's form {}, and 0, 1, 6 and 7 are read", cdr.form());
  }
  const auto seconds = static_cast<std::int32_t>(cdr.whole_number());
  state.stamp_ns = seconds * kSecond_ns + cdr.whole_number();
  cdr.text();  // the frame
  cdr.texts(state.names);
  cdr.numbers(state.position);
  cdr.numbers(state.velocity);
  cdr.numbers(state.effort);
  return cdr.is_short() ? "ends before its joint states do" : "";
}

std::string unequal(const JointState& state, const char* what, const std::vector<double>& values) {
  if (values.empty() || values.size() == state.names.size()) return "";
  return fmt::format("has {} names and {} {}", state.names.size(), values.size(), what);
}

}  // namespace

bool is_joint_state(std::string_view type) {
  return type == "sensor_msgs/msg/JointState" || type == "sensor_msgs/JointState" ||
         type == "JointState";
}

std::string read_joint_state(std::string_view encoding, std::string_view bytes, JointState& state) {
  std::string wrong;
  if (encoding == "cdr") {
    wrong = read_cdr(bytes, state);
  } else if (encoding == "json") {
    wrong = read_json_joint_state(bytes, state);
  } else {
    return fmt::format("is encoded as \"{}\", which is not read; cdr and json are", encoding);
  }
  if (wrong.empty()) wrong = unequal(state, "positions", state.position);
  if (wrong.empty()) wrong = unequal(state, "velocities", state.velocity);
  if (wrong.empty()) wrong = unequal(state, "efforts", state.effort);
  return wrong;
}

}  // namespace torquewright::identification
