// SPDX-License-Identifier: Apache-2.0
#include "identification/preparation/uncertain.hpp"

#include <cstdlib>
#include <map>
#include <string_view>

#include "io/faults/json_text.hpp"

namespace torquewright::identification {
namespace {

double* value_of(Link& link, std::string_view key) {
  if (key == "mass_kg") return &link.mass_kg;
  if (key == "length_m") return &link.length_m;
  if (key == "center_of_mass_m") return &link.center_of_mass_m;
  if (key == "inertia_kg_m2") return &link.inertia_kg_m2;
  return nullptr;
}

double* value_of(Load& load, std::string_view key) {
  constexpr std::string_view kLinks = "links/";
  if (key.substr(0, kLinks.size()) == kLinks) {
    const std::size_t slash = key.find('/', kLinks.size());
    if (slash == std::string_view::npos) return nullptr;
    const std::string number(key.substr(kLinks.size(), slash - kLinks.size()));
    const std::size_t index = std::strtoul(number.c_str(), nullptr, 10);
    return index < load.links.size() ? value_of(load.links[index], key.substr(slash + 1)) : nullptr;
  }
  if (key == "mass_kg") return &load.mass_kg;
  if (key == "length_m") return &load.length_m;
  if (key == "inertia_kg_m2") return &load.inertia_kg_m2;
  if (key == "roll_rad") return &load.roll_rad;
  if (key == "pitch_rad") return &load.pitch_rad;
  return nullptr;
}

/// RUN/KEY. Runs may have slashes in their names.
double* value_of(std::map<std::string, Load, std::less<>>& loads, std::string_view path) {
  for (auto& [run, load] : loads) {
    const std::string begin = io::child_path("", run) + "/";
    if (("/" + std::string(path)).starts_with(begin)) {
      return value_of(load, path.substr(begin.size() - 1));
    }
  }
  return nullptr;
}

double* value_of(actuator::Motor& motor, std::string_view key) {
  if (key == "torque_constant_Nm_A") return &motor.torque_constant_Nm_A;
  if (key == "resistance_ohm") return &motor.resistance_ohm;
  if (key == "rotor_inertia_kg_m2") return &motor.rotor_inertia_kg_m2;
  if (key == "back_emf_constant_V_s_rad" && motor.back_emf_constant_V_s_rad) {
    return &*motor.back_emf_constant_V_s_rad;
  }
  return nullptr;
}

double* value_of(actuator::Transmission& gear, std::string_view key) {
  if (key == "ratio") return &gear.ratio;
  if (key == "forward_efficiency") return &gear.forward_efficiency;
  if (key == "backward_efficiency") return &gear.backward_efficiency;
  if (key == "inertia_kg_m2") return &gear.inertia_kg_m2;
  return nullptr;
}

}  // namespace

bool is_of_load(const std::string& pointer) {
  return pointer.starts_with("/load/") || pointer.starts_with("/loads/");
}

double* value_at(const std::string& pointer, Rig& rig, actuator::Actuator& actuator) {
  const std::string_view all = pointer;
  const std::size_t slash = all.find('/', 1);
  if (slash == std::string_view::npos) return nullptr;
  const std::string_view part = all.substr(0, slash), key = all.substr(slash + 1);
  if (part == "/load") return value_of(rig.load, key);
  if (part == "/loads") return value_of(rig.loads, key);
  if (part == "/motor") return value_of(actuator.motor, key);
  if (part == "/gearbox") return value_of(actuator.transmission, key);
  return nullptr;
}

}  // namespace torquewright::identification
