// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/derived_values_spec.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "actuator/motor/statement_spec.hpp"
#include "io/documents/schema.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::json;

constexpr const char* kTorqueConstant = "/motor/torque_constant_Nm_A";

/// A current of the drive, and the torque that may stand in its place.
struct TorqueForCurrent {
  const char* current;
  const char* torque;
  const char* words;
  bool is_required;
};

constexpr TorqueForCurrent kTorques[] = {
    {"peak_current_A", "peak_torque_Nm", "peak current", true},
    {"continuous_current_A", "continuous_torque_Nm", "continuous current", false}};

CurrentConvention current_convention(const std::string& word) {
  if (word == "peak_phase") return CurrentConvention::kPeakPhase;
  return word == "rms_phase" ? CurrentConvention::kRmsPhase : CurrentConvention::kDc;
}

double number_of(const json& value) {
  return value.is_object() ? value["value"].get<double>() : value.get<double>();
}

/// Kt = 60 / (2 pi Kv): of one equivalent winding, whose back-EMF over speed is torque over current
/// (docs/derivations/conventions.md).
double constant_of_kv(double kv_rpm_V) { return 30.0 / (std::numbers::pi * kv_rpm_V); }

/// The torque constant that follows, with the tolerance that is stated.
void take_kv(const json& kv, Actuator& actuator) {
  actuator.motor.torque_constant_Nm_A = constant_of_kv(number_of(kv));
  if (!kv.is_object() || !(kv.contains("tolerance") || kv.contains("bound"))) return;
  Statement statement;
  statement.pointer = kTorqueConstant;
  statement.printed = actuator.motor.torque_constant_Nm_A;
  if (kv.contains("tolerance")) statement.tolerance = kv["tolerance"].get<double>();
  if (kv.contains("bound")) {  // its inverse
    statement.bound = kv["bound"] == "at_least" ? Bound::kAtMost : Bound::kAtLeast;
  }
  actuator.statements.push_back(std::move(statement));
}

/// Torque at the joint for each ampere, without friction.
double joint_torque_per_ampere(const Actuator& actuator) {
  const Transmission& gear = actuator.transmission;
  return actuator.motor.torque_constant_Nm_A * std::abs(gear.ratio) * gear.forward_efficiency;
}

double& current_of(Drive& drive, const TorqueForCurrent& pair) {
  if (pair.is_required) return drive.peak_current_A;
  return drive.continuous_current_A.emplace();
}

}  // namespace

void read_torque_constant(const io::Document& document, Actuator& actuator,
                          std::vector<io::Fault>& faults) {
  const json& keys = document.root["motor"];
  const auto report = [&](const char* key, const char* message) {
    faults.push_back({document.file, std::string("/motor/") + key, message});
  };
  const bool has_constant = keys.contains("torque_constant_Nm_A");
  const bool has_kv = keys.contains("velocity_constant_rpm_V");
  const std::string word = keys.value("torque_constant_convention", "");
  if (!has_constant && !has_kv) {
    return report("torque_constant_Nm_A",
                  "missing; or \"velocity_constant_rpm_V\", from which it follows");
  }
  if (!has_constant) {
    if (!word.empty() && word != "dc") {
      report("torque_constant_convention",
             "must be \"dc\", or absent: it is what follows from velocity_constant_rpm_V");
    }
    return take_kv(keys["velocity_constant_rpm_V"], actuator);
  }
  if (has_kv) {
    report("velocity_constant_rpm_V",
           "stands beside torque_constant_Nm_A, in whose place it would be; what a sheet prints "
           "besides belongs under /datasheet");
  }
  if (word.empty()) {
    report("torque_constant_convention",
           "missing, must be \"dc\", \"peak_phase\" or \"rms_phase\"");
  }
  actuator.motor.torque_constant_convention = current_convention(word);
  actuator.motor.torque_constant_Nm_A =
      read_stated(keys["torque_constant_Nm_A"], kTorqueConstant, actuator.statements);
}

void check_torques_for_currents(const io::Document& document, std::vector<io::Fault>& faults) {
  const json& keys = document.root["drive"];
  for (const TorqueForCurrent& pair : kTorques) {
    const bool has_current = keys.contains(pair.current), has_torque = keys.contains(pair.torque);
    if (has_current && has_torque) {
      faults.push_back({document.file, std::string("/drive/") + pair.torque,
                        fmt::format("stands beside {}, in whose place it would be; what a sheet "
                                    "prints besides belongs under /datasheet",
                                    pair.current)});
    }
    if (pair.is_required && !has_current && !has_torque) {
      faults.push_back({document.file, std::string("/drive/") + pair.current,
                        fmt::format("missing; or \"{}\", from which it follows", pair.torque)});
    }
  }
}

void take_torques_for_currents(const io::Document& document, Actuator& actuator,
                               std::vector<io::Fault>& faults) {
  const json& keys = document.root["drive"];
  const json& range =
      io::schema_of("actuator")["properties"]["drive"]["properties"]["peak_current_A"]["anyOf"][0];
  const double least_A = range["minimum"], greatest_A = range["maximum"];
  for (const TorqueForCurrent& pair : kTorques) {
    if (!keys.contains(pair.torque)) continue;
    const double current_A = number_of(keys[pair.torque]) / joint_torque_per_ampere(actuator);
    current_of(actuator.drive, pair) = current_A;
    if (current_A >= least_A && current_A <= greatest_A) continue;
    faults.push_back(
        {document.file, std::string("/drive/") + pair.torque,
         fmt::format("needs {:.6g} A, outside [{:g}, {:g}] A", current_A, least_A, greatest_A)});
  }
}

namespace {

/// Of numbers that the sheet bounds and the model needs.
std::vector<std::string> bound_sentences(const json& root) {
  std::vector<std::string> sentences;
  for (const std::string& pointer : taken_at_their_bounds(root)) {
    const json& value = root[json::json_pointer(pointer)];
    sentences.push_back(fmt::format("{} is stated as {} {:g}, and taken as that", pointer,
                                    value["bound"] == "at_least" ? "at least" : "at most",
                                    value["value"].get<double>()));
  }
  return sentences;
}

}  // namespace

std::vector<std::string> derived_values(const io::Document& document, const Actuator& actuator) {
  std::vector<std::string> sentences = bound_sentences(document.root);
  if (actuator.envelope) return sentences;
  const json &motor = document.root["motor"], &drive = document.root["drive"];
  if (motor.contains("velocity_constant_rpm_V")) {
    sentences.push_back(fmt::format("torque constant {:.4g} Nm/A = 60 / (2 pi Kv), Kv = {:g} rpm/V",
                                    actuator.motor.torque_constant_Nm_A,
                                    number_of(motor["velocity_constant_rpm_V"])));
  }
  for (const TorqueForCurrent& pair : kTorques) {
    if (!drive.contains(pair.torque)) continue;
    const double current_A = pair.is_required ? actuator.drive.peak_current_A
                                              : actuator.drive.continuous_current_A.value_or(0.0);
    sentences.push_back(fmt::format(
        "{} {:.4g} A = T / (Kt N eta), T = {:g} Nm at the joint; friction is not counted",
        pair.words, current_A, number_of(drive[pair.torque])));
  }
  return sentences;
}

}  // namespace torquewright::actuator
