// SPDX-License-Identifier: Apache-2.0
#include "tests/actuator/exporters/exported_parameters.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace torquewright::actuator {
namespace {

using Law = std::function<TorqueLimits(double)>;
constexpr double kPi = 3.14159265358979323846;

double clamped(double value, double low, double high) {
  return std::max(low, std::min(value, high));
}

std::vector<double> numbers(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> values;
  for (std::string word; stream >> word;) values.push_back(std::stod(word));
  return values;
}

/// An XML file: elements by path, attributes as numbers.
class XmlFile {
 public:
  explicit XmlFile(const std::string& text) {
    if (document_.Parse(text.c_str()) != tinyxml2::XML_SUCCESS) {
      throw std::runtime_error(document_.ErrorStr());
    }
  }

  std::vector<double> at(const std::vector<std::string>& path, const std::string& name) const {
    const tinyxml2::XMLElement* element = document_.RootElement();
    if (element == nullptr || element->Name() != path[0]) throw std::runtime_error(path[0]);
    for (std::size_t i = 1; i < path.size(); ++i) {
      element = element->FirstChildElement(path[i].c_str());
      if (element == nullptr) throw std::runtime_error("no element " + path[i]);
    }
    const char* value = element->Attribute(name.c_str());
    if (value == nullptr) throw std::runtime_error("no attribute " + name);
    return numbers(value);
  }

 private:
  tinyxml2::XMLDocument document_;
};

/// name=number or "name": number outside comments, as in Python and USD.
/// The number of a field; of one that a motor's strength scales, that of a strength of 1.
double literal(const std::string& text, const std::string& name) {
  const std::regex line("(?:^|\\n)[^#\\n]*\\b" + name +
                        "\"?\\s*[=:]\\s*(?:strength \\* )?(-?[0-9][0-9.eE+-]*)");
  std::smatch found;
  if (!std::regex_search(text, found, line)) throw std::runtime_error("no field " + name);
  return std::stod(found[1]);
}

std::vector<double> array(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find(name + "[] = {");
  if (begin == std::string::npos) throw std::runtime_error("no array " + name);
  const std::size_t open = text.find('{', begin) + 1;
  std::string inside = text.substr(open, text.find('}', open) - open);
  std::replace(inside.begin(), inside.end(), ',', ' ');
  return numbers(inside);
}

/// Voltage line and cap at the joint, as every DC motor law writes it.
Law line(double stall_Nm, double no_load_rad_s, double cap_Nm, bool clamps_speed) {
  return [=](double speed) {
    const double overspeed = no_load_rad_s * (1.0 + cap_Nm / stall_Nm);
    const double at = clamps_speed ? clamped(speed, -overspeed, overspeed) : speed;
    return TorqueLimits{std::max(stall_Nm * (-1.0 - at / no_load_rad_s), -cap_Nm),
                        std::min(stall_Nm * (1.0 - at / no_load_rad_s), cap_Nm)};
  };
}

Law mujoco(const std::string& text) {
  const XmlFile file(text);
  const std::vector<std::string> general{"mujoco", "actuator", "general"};
  const double gain = file.at(general, "gainprm")[0];
  const std::vector<double> bias = file.at(general, "biasprm");
  const std::vector<double> control = file.at(general, "ctrlrange");
  const std::vector<double> force = file.at(general, "forcerange");
  const double gear = file.at(general, "gear")[0];
  return [=](double speed) {
    const auto at = [&](double ctrl) {
      return gear * clamped(gain * ctrl + bias[0] + bias[2] * gear * speed, force[0], force[1]);
    };
    return TorqueLimits{at(control[0]), at(control[1])};
  };
}

// dcmotor.tex: v = clip(R/K tau + K w, Vmax); torque = clip(K/R (v - K w), saturation); w at the
// rotor.
Law mujoco_dcmotor(const std::string& text) {
  const XmlFile file(text);
  const std::vector<std::string> motor{"mujoco", "actuator", "dcmotor"};
  const std::vector<double> constants = file.at(motor, "motorconst");
  const double constant = std::sqrt(constants.at(0) * constants.at(1));
  const double resistance = file.at(motor, "resistance")[0];
  const double cap = file.at(motor, "saturation").at(0);
  const double voltage = file.at(motor, "controller").at(5);
  const double gear = file.at(motor, "gear")[0];
  return [=](double speed) {
    const double rotor = gear * speed;
    const auto at = [&](double wanted) {
      const double volts =
          clamped(resistance / constant * wanted + constant * rotor, -voltage, voltage);
      return gear * clamped(constant / resistance * (volts - constant * rotor), -cap, cap);
    };
    const double one = at(1e9);
    const double other = at(-1e9);
    return TorqueLimits{std::min(one, other), std::max(one, other)};
  };
}

/// tau = K (V - K w) / R, held to the effort limit: as Isaac Lab's BAM and mjlab's <dcmotor>.
Law by_voltage(const std::string& text, const std::string& volts, const std::string& effort) {
  const double constant = literal(text, "kt");
  const double resistance = literal(text, "resistance");
  const double limit = literal(text, volts);
  const double cap = literal(text, effort);
  return [=](double speed) {
    const auto at = [&](double voltage) {
      return clamped(constant * (voltage - constant * speed) / resistance, -cap, cap);
    };
    return TorqueLimits{at(-limit), at(limit)};
  };
}

Law raisim2(const std::string& text) {
  const XmlFile file(text);
  const std::vector<std::string> motor{"motor_group", "motor"};
  const double gear = file.at({"motor_group"}, "gear_ratio")[0];
  const double bus = file.at({"motor_group"}, "bus_voltage")[0];
  const double resistance = file.at(motor, "resistance")[0];
  const double torque_constant = file.at(motor, "torque_constant")[0];
  const double velocity_constant = file.at(motor, "velocity_constant")[0];
  const double peak = file.at(motor, "peak_torque")[0];
  return [=](double speed) {
    const double rotor = gear * speed;
    double low = torque_constant / resistance * (-bus - rotor / velocity_constant);
    double high = torque_constant / resistance * (bus - rotor / velocity_constant);
    if (high < -peak) {
      low = high;
    } else if (low > peak) {
      high = low;
    } else {
      low = std::max(low, -peak);
      high = std::min(high, peak);
    }
    return TorqueLimits{std::min(gear * low, gear * high), std::max(gear * low, gear * high)};
  };
}

Law unitree(const std::string& text) {
  const double x1 = literal(text, "X1");
  const double x2 = literal(text, "X2");
  const double y1 = literal(text, "Y1");
  const double y2 = literal(text, "Y2");
  return [=](double speed) {
    const auto limit = [&](double effort) {
      const double most = speed * effort > 0.0 ? y1 : y2;
      if (std::abs(speed) < x1) return most;
      return std::max(0.0, most - most / (x2 - x1) * (std::abs(speed) - x1));
    };
    return TorqueLimits{-limit(-1.0), limit(1.0)};
  };
}

Law physx(const std::string& text) {
  const std::string envelope = "physxDrivePerformanceEnvelope:angular:";
  const double most = literal(text, "drive:angular:physics:maxForce");
  const double velocity = literal(text, envelope + "maxActuatorVelocity") * kPi / 180.0;
  const double gradient = literal(text, envelope + "speedEffortGradient") * kPi / 180.0;
  const double resistance = literal(text, envelope + "velocityDependentResistance") * 180.0 / kPi;
  return [=](double speed) {
    const double first = most - resistance * std::abs(speed);
    const double second = (velocity - std::abs(speed)) / gradient;
    const double limit = std::max(0.0, std::min(first, second));
    return TorqueLimits{-limit, limit};
  };
}

Law urdf(const std::string& text) {
  const XmlFile file(text);
  const double effort = file.at({"robot", "joint", "limit"}, "effort")[0];
  const double velocity = file.at({"robot", "joint", "limit"}, "velocity")[0];
  return [=](double speed) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double limit = std::abs(speed) <= velocity ? effort : infinity;
    return TorqueLimits{-limit, limit};
  };
}

Law sdf(const std::string& text) {
  const auto number = [&](const std::string& name) {
    const std::size_t begin = text.find("<" + name + ">");
    if (begin == std::string::npos) throw std::runtime_error("no element " + name);
    return std::stod(text.substr(begin + name.size() + 2));
  };
  const double effort = number("effort");
  const double velocity = number("velocity");
  return [=](double speed) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double limit = std::abs(speed) <= velocity ? effort : infinity;
    return TorqueLimits{-limit, limit};
  };
}

/// The first row's torque; of speeds beyond the note's greatest the format says nothing.
Law remotized(const std::string& text) {
  const std::string mark = "joint_parameter_lookup=[[";
  const std::size_t begin = text.find(mark);
  if (begin == std::string::npos) throw std::runtime_error("no lookup");
  std::string row = text.substr(begin + mark.size(), text.find(']', begin) - begin - mark.size());
  std::replace(row.begin(), row.end(), ',', ' ');
  const double effort = numbers(row).at(2);
  const std::string speed_mark = "# greatest_speed_rad_s = ";
  const std::size_t place = text.find(speed_mark);
  if (place == std::string::npos) throw std::runtime_error("no speed in the note");
  const double velocity = std::stod(text.substr(place + speed_mark.size()));
  return [=](double speed) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double limit = std::abs(speed) <= velocity ? effort : infinity;
    return TorqueLimits{-limit, limit};
  };
}

Law jaxsim(const std::string& text) {
  const double most = literal(text, "torque_max");
  const double knee = literal(text, "omega_th");
  const double end = literal(text, "omega_max");
  return [=](double speed) {
    const double at = std::abs(speed);
    const double limit = at <= knee  ? most
                         : at <= end ? most * (1.0 - (at - knee) / (end - knee))
                                     : 0.0;
    return TorqueLimits{-limit, limit};
  };
}

Law table(const std::vector<double>& speeds, const std::vector<double>& least,
          const std::vector<double>& greatest) {
  return [=](double speed) {
    TorqueLimits rest{1e300, -1e300};
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      if (speeds[i] != speed) continue;
      rest = {std::min(rest.least_Nm, least[i]), std::max(rest.greatest_Nm, greatest[i])};
    }
    if (rest.least_Nm <= rest.greatest_Nm) return rest;
    if (speed < speeds.front()) return TorqueLimits{least.front(), greatest.front()};
    if (speed > speeds.back()) return TorqueLimits{least.back(), greatest.back()};
    std::size_t i = 1;
    while (speeds[i] < speed) ++i;
    const double share = (speed - speeds[i - 1]) / (speeds[i] - speeds[i - 1]);
    return TorqueLimits{least[i - 1] + share * (least[i] - least[i - 1]),
                        greatest[i - 1] + share * (greatest[i] - greatest[i - 1])};
  };
}

/// What stands between a mark and the next end, as numbers.
std::vector<double> numbers_after(const std::string& text, const std::string& mark,
                                  const std::string& end) {
  const std::size_t begin = text.find(mark);
  if (begin == std::string::npos) throw std::runtime_error("no " + mark);
  const std::size_t open = begin + mark.size();
  std::string inside = text.substr(open, text.find(end, open) - open);
  std::replace_if(
      inside.begin(), inside.end(),
      [](char letter) { return letter == ',' || letter == '{' || letter == '}'; }, ' ');
  return numbers(inside);
}

Law python(const std::string& text) {
  return table(numbers_after(text, "\"speed_rad_s\": [", "]"),
               numbers_after(text, "\"least_Nm\": [", "]"),
               numbers_after(text, "\"greatest_Nm\": [", "]"));
}

/// Rows of speed, next speed, least, its slope, greatest, its slope.
Law c_rows(const std::string& text) {
  const std::vector<double> all = numbers_after(text, "_row[] = {", "};");
  std::vector<double> columns[6];
  for (std::size_t i = 0; i < all.size(); ++i) columns[i % 6].push_back(all[i]);
  return table(columns[0], columns[2], columns[4]);
}

}  // namespace

Law law_of_file(const std::string& format, const std::string& text) {
  if (format == "mujoco") return mujoco(text);
  if (format == "mujoco-dcmotor") return mujoco_dcmotor(text);
  if (format == "raisim2") return raisim2(text);
  if (format == "unitree-xy") return unitree(text);
  if (format == "physx") return physx(text);
  if (format == "urdf") return urdf(text);
  if (format == "sdf" || format == "drake-sdf") return sdf(text);
  if (format == "jaxsim") return jaxsim(text);
  if (format == "raisim1" || format == "drake") {
    return table(array(text, "kSpeed"), array(text, "kLeast"), array(text, "kGreatest"));
  }
  if (format == "python" || format == "pybullet" || format == "isaac-gym" || format == "genesis" ||
      format == "playground") {
    return python(text);
  }
  if (format == "c") return c_rows(text);
  if (format == "isaac-lab") {
    return line(literal(text, "saturation_effort"), literal(text, "actuator_velocity_limit"),
                literal(text, "actuator_effort_limit"), true);
  }
  if (format == "isaac-lab-2.3") {
    return line(literal(text, "saturation_effort"), literal(text, "velocity_limit"),
                literal(text, "effort_limit"), true);
  }
  if (format == "isaac-lab-remotized") return remotized(text);
  if (format == "isaac-lab-bam") return by_voltage(text, "vin", "actuator_effort_limit");
  if (format == "mjlab-dcmotor") return by_voltage(text, "voltage_limit", "effort_limit");
  if (format == "mjlab") {
    return line(literal(text, "saturation_effort"), literal(text, "velocity_limit"),
                literal(text, "effort_limit"), true);
  }
  if (format == "newton") {
    return line(literal(text, "saturation_effort"), literal(text, "velocity_limit"),
                literal(text, "max_motor_effort"), true);
  }
  throw std::runtime_error("no reader for " + format);
}

}  // namespace torquewright::actuator
