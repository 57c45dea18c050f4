// SPDX-License-Identifier: Apache-2.0
#include "src/options/push_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "io/faults/refusal.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::cli {
namespace {

constexpr const char* kForm =
    "a push is N_S@TIME, X,Y,Z@TIME or BODY:X,Y,Z@TIME, in N s and s, as 30@0.2 or thigh:0,0,5@1";
// A ton at 10 m/s: more than that is a mistyped unit.
constexpr double kGreatest_N_s = 1e4;

[[noreturn]] void refuse_push(const std::string& text, const std::string& why) {
  io::refuse("--push " + text, why);
}

std::optional<double> number_of(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(number)) return std::nullopt;
  return number;
}

double number_in(const std::string& text, const std::string& number) {
  const std::optional<double> read = number_of(number);
  if (!read) refuse_push(text, fmt::format("\"{}\" is no number; {}", number, kForm));
  return *read;
}

Eigen::Vector3d impulse_in(const std::string& text, const std::string& numbers) {
  std::vector<double> read;
  std::size_t from = 0;
  while (true) {
    const std::size_t comma = numbers.find(',', from);
    read.push_back(number_in(text, numbers.substr(from, comma - from)));
    if (comma == std::string::npos) break;
    from = comma + 1;
  }
  if (read.size() != 1 && read.size() != 3) refuse_push(text, kForm);
  read.resize(3, 0.0);
  const Eigen::Vector3d impulse_N_s(read[0], read[1], read[2]);
  const double size_N_s = impulse_N_s.norm();
  if (!(size_N_s > 0.0)) refuse_push(text, "pushes with nothing: an impulse is above 0 N s");
  if (size_N_s > kGreatest_N_s) {
    refuse_push(text, fmt::format("is {:g} N s, where at most {:g} N s is a push", size_N_s,
                                  kGreatest_N_s));
  }
  return impulse_N_s;
}

std::size_t body_in(const std::string& text, const std::string& name, const hopper::Robot& robot) {
  std::vector<std::string> known;
  for (const dynamics::Body& body : robot.tree.bodies) known.push_back(body.name);
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  const auto near = io::nearest(name, known);
  refuse_push(text, fmt::format("{} has no body \"{}\"{}", robot.name, name,
                                near ? fmt::format("; did you mean \"{}\"?", *near)
                                     : fmt::format("; there are {}", io::listed(known))));
}

hopper::Push read_push(const std::string& text, const hopper::Robot& robot) {
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos) refuse_push(text, kForm);
  const std::size_t colon = text.substr(0, at).rfind(':');
  hopper::Push push;
  if (colon != std::string::npos) push.body = body_in(text, text.substr(0, colon), robot);
  push.body_name = robot.tree.bodies[push.body].name;
  const std::size_t numbers = colon == std::string::npos ? 0 : colon + 1;
  push.impulse_N_s = impulse_in(text, text.substr(numbers, at - numbers));
  push.time_s = number_in(text, text.substr(at + 1));
  return push;
}

}  // namespace

std::vector<hopper::Push> read_pushes(const std::vector<std::string>& texts,
                                      const hopper::Robot& robot, const hopper::Motion& motion,
                                      double stand_s) {
  const double begin_s = motion.times_s.front(), end_s = motion.times_s.back() + stand_s;
  std::vector<hopper::Push> pushes;
  for (const std::string& text : texts) {
    const hopper::Push& push = pushes.emplace_back(read_push(text, robot));
    if (!(push.time_s >= begin_s && push.time_s < end_s)) {
      refuse_push(text, fmt::format("is at t = {:g} s, and the run lasts from {:g} to {:g} s "
                                    "(the motion and --stand {:g} s)",
                                    push.time_s, begin_s, end_s, stand_s));
    }
    if (robot.tree.base == dynamics::BaseKind::kPlanar && push.impulse_N_s.y() != 0.0) {
      refuse_push(
          text, fmt::format("pushes sideways, and {} moves in the plane y = 0 alone", robot.name));
    }
  }
  return pushes;
}

}  // namespace torquewright::cli
