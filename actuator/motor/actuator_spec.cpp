// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/actuator_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "actuator/effects/effect_spec.hpp"
#include "actuator/motor/derived_values_spec.hpp"
#include "actuator/motor/envelope_spec.hpp"
#include "actuator/motor/gearbox_source_spec.hpp"
#include "actuator/motor/statement_spec.hpp"
#include "io/documents/schema.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::json;

ResistanceConvention resistance_convention(const std::string& word) {
  if (word == "phase") return ResistanceConvention::kPhase;
  return word == "line_to_line" ? ResistanceConvention::kLineToLine : ResistanceConvention::kDc;
}

Modulation modulation(const std::string& word) {
  if (word == "sine") return Modulation::kSine;
  return word == "six_step" ? Modulation::kSixStep : Modulation::kSvpwm;
}

std::optional<double> find(const json& object, const char* key) {
  if (!object.contains(key)) return std::nullopt;
  return object[key].get<double>();
}

/// Reads the keys of one document; faults gather until all of it is read.
class ActuatorReader {
 public:
  ActuatorReader(io::Document document, std::span<const io::Document> read_before)
      : read_before_(read_before), documents_{std::move(document)} {}

  ReadActuator read() {
    actuator_.name = root().value("name", io::stem_in_text(document().file));
    if (root().contains("mass_kg")) {
      actuator_.mass_kg = read_stated(root()["mass_kg"], "/mass_kg", actuator_.statements);
    }
    require_blocks();
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
    if (has_winding()) {
      read_motor();
      read_drive();
    }
    if (root().contains("battery")) read_battery(root()["battery"]);
    if (root().contains("thermal")) read_thermal(root()["thermal"]);
    if (root().contains("datasheet")) read_datasheet(root()["datasheet"]);
    read_effects();
    read_assumed();
    read_gearbox();
    if (has_winding()) {
      carry();
    } else if (faults_.empty()) {
      read_envelope(document(), actuator_, documents_, faults_);
    }
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
    return {std::move(actuator_), std::move(documents_)};
  }

 private:
  bool has_winding() const { return !root().contains("envelope"); }

  void require_blocks() {
    if (!has_winding()) return;
    const bool has_neither = !root().contains("motor") && !root().contains("drive");
    if (has_neither) {
      report("", "needs \"motor\" and \"drive\", or \"envelope\" where only the curve is known");
      return;
    }
    for (const char* block : {"motor", "drive", "gearbox"}) {
      if (!root().contains(block)) report(std::string("/") + block, "missing");
    }
    if (!root().contains("gearbox") || root()["gearbox"].contains("file")) return;
    for (const char* efficiency : {"forward_efficiency", "backward_efficiency"}) {
      if (root()["gearbox"].contains(efficiency)) continue;
      report(std::string("/gearbox/") + efficiency, "missing");
    }
  }

  const io::Document& document() const { return documents_.front(); }
  const json& root() const { return document().root; }

  void report(const std::string& path, std::string message) {
    faults_.push_back({document().file, path, std::move(message)});
  }

  /// A number that may say its side, ampere and tolerance.
  double stated(const char* block, const char* key) {
    return read_stated(root()[block][key], fmt::format("/{}/{}", block, key), actuator_.statements);
  }

  std::optional<double> find_stated(const char* block, const char* key) {
    if (!root()[block].contains(key)) return std::nullopt;
    return stated(block, key);
  }

  /// Once all is read: what was stated elsewhere comes to the motor.
  void carry() {
    carry_to_motor(actuator_);
    if (faults_.empty()) take_torques_for_currents(document(), actuator_, faults_);
    const Drive& drive = actuator_.drive;
    if (drive.continuous_current_A > drive.peak_current_A) {
      report("/drive/continuous_current_A",
             fmt::format("{} is above /drive/peak_current_A, {}", *drive.continuous_current_A,
                         drive.peak_current_A));
    }
    if (!faults_.empty()) return;  // no ratio to carry over, perhaps
    check_at_motor("torque_constant_Nm_A", actuator_.motor.torque_constant_Nm_A);
    if (actuator_.motor.back_emf_constant_V_s_rad) {
      check_at_motor("back_emf_constant_V_s_rad", *actuator_.motor.back_emf_constant_V_s_rad);
    }
  }

  /// The range of the schema is that of the motor.
  void check_at_motor(const std::string& key, double value) {
    const json& range =
        io::schema_of("actuator")["properties"]["motor"]["properties"][key]["anyOf"][0];
    const auto least = range["minimum"].get<double>(), greatest = range["maximum"].get<double>();
    if (value >= least && value <= greatest) return;
    const std::string unit = range["unit"];
    report("/motor/" + key + "/value",
           fmt::format("is {:.6g} {} at the motor, outside [{:g}, {:g}] {}", value, unit, least,
                       greatest, unit));
  }

  void read_motor() {
    const json& keys = root()["motor"];
    Motor& motor = actuator_.motor;
    read_torque_constant(document(), actuator_, faults_);
    motor.back_emf_constant_V_s_rad = find_stated("motor", "back_emf_constant_V_s_rad");
    motor.resistance_ohm = stated("motor", "resistance_ohm");
    motor.resistance_convention = resistance_convention(keys["resistance_convention"]);
    motor.inductance_d_H = find_stated("motor", "inductance_d_H").value_or(0.0);
    motor.inductance_q_H = find_stated("motor", "inductance_q_H").value_or(0.0);
    motor.pole_pairs = keys.value("pole_pairs", 1.0);
    motor.rotor_inertia_kg_m2 = find_stated("motor", "rotor_inertia_kg_m2").value_or(0.0);
    motor.winding_temperature_K = keys.value("winding_temperature_K", kDefaultTemperature_K);
    motor.demagnetisation_current_A =
        find_stated("motor", "demagnetisation_current_A").value_or(kUnlimited);
    const bool has_inductance = motor.inductance_d_H > 0.0 || motor.inductance_q_H > 0.0;
    if (has_inductance && !keys.contains("pole_pairs")) {
      report("/motor/pole_pairs", "missing; the voltage over an inductance needs it");
    }
  }

  void read_drive() {
    const json& keys = root()["drive"];
    Drive& drive = actuator_.drive;
    drive.bus_voltage_V = keys["bus_voltage_V"];
    drive.peak_current_A = find_stated("drive", "peak_current_A").value_or(kUnlimited);
    drive.continuous_current_A = find_stated("drive", "continuous_current_A");
    drive.supply_current_A = keys.value("supply_current_A", kUnlimited);
    check_torques_for_currents(document(), faults_);
    if (keys.contains("modulation")) drive.modulation = modulation(keys["modulation"]);
    drive.field_weakening = keys.value("field_weakening", false);
    drive.regeneration = keys.value("regeneration", true);
    drive.regeneration_limit_W = keys.value("regeneration_limit_W", kUnlimited);
    const bool is_dc = actuator_.motor.torque_constant_convention == CurrentConvention::kDc;
    if (!is_dc && !keys.contains("modulation")) {
      report("/drive/modulation",
             "missing; outside the dc convention it sets the voltage: sine, svpwm or six_step");
    }
    if (drive.field_weakening && actuator_.motor.inductance_d_H == 0.0) {
      report("/drive/field_weakening",
             "needs /motor/inductance_d_H: without inductance no current weakens the field");
    }
  }

  void read_battery(const json& keys) {
    Battery battery;
    battery.series_cells = keys["series_cells"];
    battery.parallel_cells = keys["parallel_cells"];
    battery.cell_resistance_ohm = keys["cell_resistance_ohm"];
    if (keys.contains("cell_capacity_Ah")) battery.cell_capacity_Ah = keys["cell_capacity_Ah"];
    battery.wiring_resistance_ohm = keys.value("wiring_resistance_ohm", 0.0);
    battery.discharge_limit_A = keys.value("discharge_limit_A", kUnlimited);
    battery.charge_limit_A = keys.value("charge_limit_A", kUnlimited);
    battery.maximum_voltage_V = keys.value("maximum_voltage_V", kUnlimited);
    read_open_circuit(keys["cell_open_circuit_V"], battery);
    actuator_.battery = battery;
  }

  void read_open_circuit(const json& value, Battery& battery) {
    if (value.is_number()) {
      battery.cell_open_circuit = {{1.0, value.get<double>()}};
      return;
    }
    for (const json& point : value) {
      battery.cell_open_circuit.push_back({point["state_of_charge"], point["voltage_V"]});
    }
    for (std::size_t i = 1; i < battery.cell_open_circuit.size(); ++i) {
      const ChargePoint& before = battery.cell_open_circuit[i - 1];
      const ChargePoint& here = battery.cell_open_circuit[i];
      if (here.state_of_charge > before.state_of_charge && here.voltage_V >= before.voltage_V) {
        continue;
      }
      report(fmt::format("/battery/cell_open_circuit_V/{}", i),
             "must ascend: more charge than the entry before, and no less voltage");
    }
  }

  void read_thermal(const json& keys) {
    Thermal thermal;
    thermal.winding_to_case_K_W = keys["winding_to_case_K_W"];
    thermal.case_to_ambient_K_W = keys["case_to_ambient_K_W"];
    thermal.winding_J_K = keys["winding_J_K"];
    thermal.case_J_K = keys["case_J_K"];
    thermal.winding_limit_K = keys["winding_limit_K"];
    thermal.ambient_K = keys.value("ambient_K", kDefaultTemperature_K);
    if (thermal.winding_limit_K <= thermal.ambient_K) {
      report("/thermal/winding_limit_K", fmt::format("{} K is not above the ambient's {} K",
                                                     thermal.winding_limit_K, thermal.ambient_K));
    }
    actuator_.thermal = thermal;
  }

  void read_datasheet(const json& keys) {
    Datasheet sheet;
    sheet.joint_side = keys.value("side", "motor") == "joint";
    sheet.voltage_V = find(keys, "voltage_V");
    sheet.no_load_speed_rad_s = find_stated("datasheet", "no_load_speed_rad_s");
    sheet.maximum_speed_rad_s = find_stated("datasheet", "maximum_speed_rad_s");
    sheet.no_load_current_A = find_stated("datasheet", "no_load_current_A");
    sheet.stall_torque_Nm = find_stated("datasheet", "stall_torque_Nm");
    sheet.stall_current_A = find_stated("datasheet", "stall_current_A");
    sheet.peak_torque_Nm = find_stated("datasheet", "peak_torque_Nm");
    sheet.peak_torque_current_A = find_stated("datasheet", "peak_torque_current_A");
    sheet.peak_braking_torque_Nm = find_stated("datasheet", "peak_braking_torque_Nm");
    sheet.rated_torque_Nm = find_stated("datasheet", "rated_torque_Nm");
    sheet.peak_power_W = find_stated("datasheet", "peak_power_W");
    sheet.velocity_constant_rpm_V = find_stated("datasheet", "velocity_constant_rpm_V");
    sheet.backlash_rad = find_stated("datasheet", "backlash_rad");
    sheet.reflected_inertia_kg_m2 = find_stated("datasheet", "reflected_inertia_kg_m2");
    sheet.electrical_time_constant_s = find_stated("datasheet", "electrical_time_constant_s");
    sheet.mechanical_time_constant_s = find_stated("datasheet", "mechanical_time_constant_s");
    if (keys.contains("stall_limit")) {
      sheet.stall_limit =
          keys["stall_limit"] == "drive" ? StallLimit::kDrive : StallLimit::kWinding;
    }
    const Statement* rated = find_statement(actuator_, "/datasheet/rated_torque_Nm");
    if (rated != nullptr && rated->bound == Bound::kAtMost) {
      report("/datasheet/rated_torque_Nm/bound",
             "\"at_most\" names no torque that may last; a rating is a number, or \"at_least\"");
    }
    actuator_.datasheet = sheet;
  }

  void read_effects() {
    const json effects = root().value("effects", json::array());
    for (std::size_t i = 0; i < effects.size(); ++i) {
      const std::string path = fmt::format("/effects/{}", i);
      std::optional<Effect> effect = read_effect(effects[i], document().file, path, faults_);
      if (!effect) continue;
      for (const Effect& other : actuator_.effects) {
        if (other.kind == effect->kind) {
          report(path + "/effect",
                 fmt::format("{} stands twice; one of them would be counted twice",
                             effect->kind->name));
        }
      }
      actuator_.effects.push_back(std::move(*effect));
    }
    for (std::size_t i = 0; i < effects.size(); ++i) check_replaced(effects[i], i);
  }

  void check_replaced(const json& entry, std::size_t index) {
    const std::string replaced = entry.value("replaces", "");
    if (replaced.empty()) return;
    for (const Effect& other : actuator_.effects) {
      if (other.kind->name != replaced) continue;
      report(fmt::format("/effects/{}/replaces", index),
             fmt::format("{} is declared besides what replaces it and would be counted twice; "
                         "remove it",
                         replaced));
    }
  }

  /// What is listed, and each bound that stands in the place of a number.
  void read_assumed() {
    actuator_.assumed = root().value("assumed", actuator_.assumed);
    for (const std::string& pointer : taken_at_their_bounds(root())) {
      const auto covers = [&](const std::string& listed) {
        return pointer == listed || pointer.starts_with(listed + "/");
      };
      std::vector<std::string>& assumed = actuator_.assumed;
      if (std::none_of(assumed.begin(), assumed.end(), covers)) assumed.push_back(pointer);
    }
  }

  void read_gearbox() {
    if (!root().contains("gearbox")) return;  // of a curve at the joint
    const json& keys = root()["gearbox"];
    Transmission& transmission = actuator_.transmission;
    if (keys.contains("file")) {
      transmission = transmission_from_file(keys, document(), read_before_, documents_);
    } else {
      transmission.ratio = keys["ratio"];
      transmission.forward_efficiency = keys.value("forward_efficiency", 1.0);
      transmission.backward_efficiency = keys.value("backward_efficiency", 1.0);
      transmission.inertia_kg_m2 = keys.value("inertia_kg_m2", 0.0);
    }
    // What is stated stands before what the teeth bear.
    transmission.peak_torque_Nm = keys.value("peak_torque_Nm", transmission.peak_torque_Nm);
    if (std::abs(transmission.ratio) < 0.01) {
      report("/gearbox/ratio",
             fmt::format("{} is no ratio; must be at least 0.01 in magnitude", transmission.ratio));
    }
  }

  std::span<const io::Document> read_before_;
  std::vector<io::Document> documents_;
  Actuator actuator_;
  std::vector<io::Fault> faults_;
};

}  // namespace

ReadActuator read_actuator(const std::filesystem::path& file) {
  return read_actuator(io::read_document(file, "actuator"));
}

ReadActuator read_wound_actuator(const std::filesystem::path& file) {
  ReadActuator read = read_actuator(file);
  if (!read.actuator.envelope) return read;
  throw io::SpecError({{read.documents.front().file, "/envelope",
                        "only the curve is known; what is asked for reckons with currents, which "
                        "need a winding: state /motor and /drive"}});
}

ReadActuator read_actuator(io::Document document, std::span<const io::Document> read_before) {
  return ActuatorReader(std::move(document), read_before).read();
}

}  // namespace torquewright::actuator
