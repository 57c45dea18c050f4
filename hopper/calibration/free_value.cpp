// SPDX-License-Identifier: Apache-2.0
#include "hopper/calibration/free_value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "hopper/calibration/documented_number_spec.hpp"
#include "io/documents/document.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper::calibration {
namespace {

using Kind = Knob::Kind;

constexpr const char* kOption = "--free";
constexpr double kPlace_m = 0.1;   // either side of a documented place
constexpr double kGreatest = 1e6;  // of a stated bound, in SI units

std::optional<std::size_t> body_named(const Robot& robot, const std::string& name) {
  const auto& bodies = robot.tree.bodies;
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const dynamics::Body& body) { return body.name == name; });
  if (found == bodies.end()) return std::nullopt;
  return static_cast<std::size_t>(found - bodies.begin());
}

std::optional<Knob> body_knob(const std::vector<std::string>& parts, std::size_t body) {
  const std::string& key = parts[2];
  if (parts.size() == 3) {
    if (key == "mass_kg") return Knob{Kind::kMass, body};
    if (key == "inertia_kg_m2") return Knob{Kind::kRoundInertia, body};
    return std::nullopt;
  }
  const std::string& last = parts[3];
  if (key == "center_of_mass_m") {
    return Knob{Kind::kCenterOfMass, body, 0, static_cast<Eigen::Index>(last[0] - '0')};
  }
  return Knob{Kind::kInertia, body, 0, static_cast<Eigen::Index>(last[0] - 'x'),
              static_cast<Eigen::Index>(last[1] - 'x')};
}

std::optional<Knob> posture_knob(const std::vector<std::string>& parts, const Robot& robot) {
  const auto& postures = robot.postures;
  const auto posture = std::find_if(postures.begin(), postures.end(),
                                    [&](const Posture& each) { return each.name == parts[1]; });
  const auto body = robot.find_joint(parts[2]);
  if (posture == postures.end() || !body) return std::nullopt;
  return Knob{Kind::kPosture, *body, static_cast<std::size_t>(posture - postures.begin())};
}

std::optional<Knob> knob_of(const DocumentedNumber& number, const Robot& robot) {
  const std::vector<std::string>& parts = number.parts;
  if (parts.size() == 3 && parts[0] == "postures") return posture_knob(parts, robot);
  if (number.owner.empty()) return std::nullopt;
  if (parts[0] == "bodies") {
    const auto body = body_named(robot, number.owner);
    return body ? body_knob(parts, *body) : std::nullopt;
  }
  const auto body = robot.find_joint(number.owner);
  if (!body || parts[2] != "position_m" || parts.size() != 4) return std::nullopt;
  return Knob{Kind::kJointPosition, *body, 0, static_cast<Eigen::Index>(parts[3][0] - '0')};
}

void add_pointer(const std::string& text, const io::Document& document, const Robot& robot,
                 FreeValue& value) {
  const DocumentedNumber number = documented_number(text, document, kOption);
  const auto knob = knob_of(number, robot);
  if (!knob) {
    io::refuse(kOption, fmt::format("{} does not bear on angular momentum (CAM) and velocity "
                                    "(CAV); masses, centres of mass, "
                                    "inertias, joint positions and postures do",
                                    text));
  }
  if (!value.knobs.empty() && number.value != value.documented) {
    io::refuse(kOption, fmt::format("{} is {} and {} is {}: only equal values move together",
                                    value.pointers.front(), value.documented, text, number.value));
  }
  value.documented = number.value;
  if (value.pointers.empty()) value.words = words_of(*knob, robot);
  value.pointers.push_back(text);
  value.knobs.push_back(*knob);
}

const dynamics::JointLimits& limits_of(const Knob& knob, const Robot& robot) {
  return robot.tree.bodies[knob.body].joint.limits;
}

/// Bounds where none are stated.
void set_plausible_bounds(const Robot& robot, FreeValue& value) {
  const Knob& knob = value.knobs.front();
  const double at = value.documented;
  if (knob.kind == Kind::kPosture) {
    const dynamics::JointLimits& limits = limits_of(knob, robot);
    value.lowest = std::isfinite(limits.position_min) ? limits.position_min : -std::numbers::pi;
    value.highest = std::isfinite(limits.position_max) ? limits.position_max : std::numbers::pi;
  } else if (knob.kind == Kind::kCenterOfMass || knob.kind == Kind::kJointPosition) {
    value.lowest = at - kPlace_m;
    value.highest = at + kPlace_m;
  } else if (knob.kind == Kind::kInertia && knob.row != knob.column) {
    io::refuse(kOption, fmt::format("{} needs bounds: {}=LOW:HIGH", value.name(), value.name()));
  } else {
    const double times = knob.kind == Kind::kMass ? 2.0 : 4.0;
    value.lowest = at / times;
    value.highest = at * times;
  }
}

double number_of(const std::string& text, const std::string& whole) {
  double number = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end || !std::isfinite(number)) {
    io::refuse(kOption, fmt::format("\"{}\" must be POINTER or POINTER=LOW:HIGH", whole));
  }
  if (std::abs(number) > kGreatest) {
    io::refuse(kOption, fmt::format("{} in \"{}\" is beyond every robot; bounds are from -{:g} to "
                                    "{:g} kg, m, kg m^2 or rad",
                                    text, whole, kGreatest, kGreatest));
  }
  return number;
}

void set_stated_bounds(const std::string& bounds, const std::string& whole, const Robot& robot,
                       FreeValue& value) {
  const std::size_t colon = bounds.find(':');
  if (colon == std::string::npos) {
    io::refuse(kOption, fmt::format("\"{}\" must be POINTER or POINTER=LOW:HIGH", whole));
  }
  value.has_stated_bounds = true;
  value.lowest = number_of(bounds.substr(0, colon), whole);
  value.highest = number_of(bounds.substr(colon + 1), whole);
  if (!(value.lowest < value.highest)) {
    io::refuse(kOption,
               fmt::format("{} is not below {} in \"{}\"", value.lowest, value.highest, whole));
  }
  for (const Knob& knob : value.knobs) {
    if (knob.kind == Kind::kMass && !(value.lowest > 0.0)) {
      io::refuse(kOption, fmt::format("a mass must be positive in \"{}\"", whole));
    }
    if (knob.kind != Kind::kPosture) continue;
    const dynamics::JointLimits& limits = limits_of(knob, robot);
    if (value.lowest >= limits.position_min && value.highest <= limits.position_max) continue;
    io::refuse(kOption, fmt::format("\"{}\" leaves the joint's range [{}, {}]", whole,
                                    limits.position_min, limits.position_max));
  }
}

}  // namespace

std::string words_of(const Knob& knob, const Robot& robot) {
  const dynamics::Body& body = robot.tree.bodies[knob.body];
  constexpr std::array<char, 3> kAxes{'x', 'y', 'z'};
  const char row = kAxes[static_cast<std::size_t>(knob.row)];
  switch (knob.kind) {
    case Kind::kMass:
      return body.name + ": mass, kg";
    case Kind::kCenterOfMass:
      return fmt::format("{}: centre of mass {}, m", body.name, row);
    case Kind::kInertia:
      return fmt::format("{}: moment of inertia {}{}, kg m^2", body.name, row,
                         kAxes[static_cast<std::size_t>(knob.column)]);
    case Kind::kRoundInertia:
      return body.name + ": moment of inertia, kg m^2";
    case Kind::kJointPosition:
      return fmt::format("{}: place {}, m", body.joint.name, row);
    case Kind::kPosture:
      break;
  }
  return fmt::format("posture {}: {}, rad", robot.postures[knob.posture].name, body.joint.name);
}

std::string FreeValue::name() const { return fmt::format("{}", fmt::join(pointers, ",")); }

void turn(const Knob& knob, double value, dynamics::Tree& tree, std::vector<Posture>& postures) {
  dynamics::Body& body = tree.bodies[knob.body];
  switch (knob.kind) {
    case Kind::kMass:
      body.inertia.mass_kg = value;
      return;
    case Kind::kCenterOfMass:
      body.inertia.center_of_mass_m[knob.row] = value;
      return;
    case Kind::kInertia:
      body.inertia.inertia_kg_m2(knob.row, knob.column) = value;
      body.inertia.inertia_kg_m2(knob.column, knob.row) = value;
      return;
    case Kind::kRoundInertia:
      body.inertia.inertia_kg_m2 = value * Eigen::Matrix3d::Identity();
      return;
    case Kind::kJointPosition:
      body.joint.p_PB_m[knob.row] = value;
      return;
    case Kind::kPosture:
      postures[knob.posture].joints[static_cast<Eigen::Index>(knob.body) - 1] = value;
      return;
  }
}

FreeValue free_value(const std::string& text, const io::Document& document, const Robot& robot) {
  FreeValue value;
  const std::size_t equals = text.rfind('=');
  const std::string pointers = text.substr(0, equals);
  for (std::size_t start = 0; start <= pointers.size();) {
    const std::size_t comma = std::min(pointers.find(',', start), pointers.size());
    add_pointer(pointers.substr(start, comma - start), document, robot, value);
    start = comma + 1;
  }
  if (equals == std::string::npos) {
    set_plausible_bounds(robot, value);
  } else {
    set_stated_bounds(text.substr(equals + 1), text, robot, value);
  }
  return value;
}

}  // namespace torquewright::hopper::calibration
