// SPDX-License-Identifier: Apache-2.0
#include "src/commands/shared/sheet_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "actuator/motor/convention.hpp"
#include "actuator/motor/gearbox_source_spec.hpp"
#include "io/documents/document.hpp"
#include "io/documents/json_layout.hpp"
#include "io/documents/schema.hpp"
#include "io/documents/stated_units.hpp"
#include "io/faults/refusal.hpp"
#include "io/faults/spec_error.hpp"
#include "src/commands/shared/sheet_answer.hpp"

namespace torquewright::cli {
namespace {

using actuator::CurrentConvention;
using nlohmann::ordered_json;

ordered_json value_of(const Typed& typed) {
  const bool is_whole = std::abs(typed.number) < 1e9 && typed.number == std::round(typed.number);
  ordered_json number = typed.number;
  if (is_whole) number = static_cast<std::int64_t>(typed.number);
  if (typed.unit.empty() && typed.bound.empty()) return number;
  ordered_json value{{"value", number}};
  if (!typed.unit.empty()) value["unit"] = typed.unit;
  if (!typed.bound.empty()) value["bound"] = typed.bound;
  return value;
}

/// A document whose shape is right, whatever stands beside the value that is looked at.
ordered_json document_around(std::string_view pointer, const ordered_json& value) {
  ordered_json document{{"kind", "actuator"},
                        {"version", 1},
                        {"motor", {{"resistance_ohm", 1}, {"resistance_convention", "dc"}}},
                        {"drive", {{"bus_voltage_V", 48}}},
                        {"gearbox", {{"ratio", 1}}},
                        {"datasheet", ordered_json::object()}};
  document[ordered_json::json_pointer(std::string(pointer))] = value;
  return document;
}

/// 60 / (2 pi Kv), which is between two leads, over Kt: what the two constants say of the ampere.
double back_emf_share(CurrentConvention convention) {
  const double leads_per_winding = actuator::phase_volts_per_winding_volt(convention) /
                                   actuator::phase_volts_per_winding_volt(CurrentConvention::kDc);
  return actuator::back_emf_per_torque_constant(convention) * leads_per_winding;
}

/// Catalogues print typical constants, usually with 10 %; the conventions' shares lie 15 % apart
/// and more, so that no share fits two of them within half of that.
constexpr double kFits = 0.07;

/// The answers of one sheet, made into a document.
class Sheet {
 public:
  Sheet(const SheetAnswers& answers, std::filesystem::path folder) : folder_(std::move(folder)) {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (answers[i].empty()) continue;
      const auto [first, second] = parts_of(kSheetQuestions[i], answers[i]);
      known_[std::string(kSheetQuestions[i].pointer)] = taken_apart(kSheetQuestions[i], first);
      if (second.empty()) continue;
      known_[std::string(kSupplyCurrent.pointer)] = taken_apart(kSupplyCurrent, second);
    }
  }

  SheetDocument document() {
    const bool has_constant =
        has("/motor/torque_constant_Nm_A") || has("/motor/velocity_constant_rpm_V");
    const bool has_peak = has("/drive/peak_current_A") || has("/drive/peak_torque_Nm");
    const bool has_winding =
        has_constant && has_peak && has("/drive/bus_voltage_V") && has("/motor/resistance_ohm");
    const bool has_curve = has("/drive/peak_torque_Nm") && has("/datasheet/no_load_speed_rad_s");
    if (!has_winding && !has_curve) refuse_few();
    if (has_winding) {
      add_motor();
      add_drive();
      add_gearbox();
      add_datasheet();
    } else {
      add_envelope();
    }
    assume_bounds();
    name_about();
    name_remarks();
    if (!assumed_.empty()) document_["assumed"] = assumed_;
    return {io::json_layout(document_), explanation_};
  }

 private:
  [[noreturn]] static void refuse_few() {
    io::refuse("init --from-sheet",
               "the answers are too few for a document: a winding needs the supply voltage, Kt or "
               "Kv, the resistance, and peak current or torque; else a curve needs peak torque and "
               "no-load speed. Nothing is written");
  }

  bool has(const char* pointer) const { return known_.contains(pointer); }
  ordered_json value(const char* pointer) const { return value_of(known_.at(pointer)); }

  void put(const char* block, const char* key, const char* pointer) {
    if (has(pointer)) document_[block][key] = value(pointer);
  }

  void assume(const std::string& pointer, const std::string& why) {
    assumed_.push_back(pointer);
    explanation_ += fmt::format("{}: {}\n", pointer, why);
  }

  /// What a region needs as a number and the sheet bounds.
  void assume_bounds() {
    for (const char* block : {"motor", "drive", "envelope"}) {
      if (!document_.contains(block)) continue;
      for (const auto& [key, value] : document_[block].items()) {
        if (!value.is_object() || !value.contains("bound")) continue;
        assume(fmt::format("/{}/{}", block, key),
               fmt::format("the sheet says {} that; a region takes the number itself",
                           value["bound"] == "at_least" ? "at least" : "at most"));
      }
    }
  }

  void name_about() {
    std::string names;
    for (const SheetQuestion& question : kSheetQuestions) {
      const auto found = known_.find(question.pointer);
      if (found == known_.end() || !found->second.is_about) continue;
      names += (names.empty() ? "" : ", ") + std::string(question.name);
    }
    if (!names.empty()) {
      explanation_ += fmt::format("The sheet says \"about\"; taken as it stands: {}.\n", names);
    }
  }

  void name_remarks() {
    for (const SheetQuestion& question : kSheetQuestions) {
      const auto found = known_.find(question.pointer);
      if (found == known_.end() || found->second.remark.empty()) continue;
      explanation_ +=
          fmt::format("{}: \"{}\" is left aside.\n", question.name, found->second.remark);
    }
  }

  void add_motor() {
    const bool is_by_kv = !has("/motor/torque_constant_Nm_A");
    put("motor", "torque_constant_Nm_A", "/motor/torque_constant_Nm_A");
    if (is_by_kv) {
      put("motor", "velocity_constant_rpm_V", "/motor/velocity_constant_rpm_V");
      explanation_ += "The torque constant is 60 / (2 pi Kv), of one equivalent winding.\n";
    } else {
      convention_ = concluded_convention();
      document_["motor"]["torque_constant_convention"] = std::string(name_of(convention_));
    }
    put("motor", "resistance_ohm", "/motor/resistance_ohm");
    const std::string word = known_.at("/motor/resistance_ohm").word;
    document_["motor"]["resistance_convention"] = word.empty() ? kOfTerminals : word;
    if (word.empty())
      assume("/motor/resistance_convention", "as most sheets print it, between two leads");
    put("motor", "rotor_inertia_kg_m2", "/motor/rotor_inertia_kg_m2");
  }

  /// By the ampere in Kt's own unit, by the two constants where both are printed, else by the
  /// ampere of a current.
  CurrentConvention concluded_convention() {
    const std::string pointer = "/motor/torque_constant_convention";
    const std::string& ampere = known_.at("/motor/torque_constant_Nm_A").ampere;
    if (ampere == "rms") return CurrentConvention::kRmsPhase;
    if (ampere == "peak") return CurrentConvention::kPeakPhase;
    if (has("/motor/velocity_constant_rpm_V")) {
      if (const auto convention = convention_of_constants()) return *convention;
    }
    for (const char* current : {"/drive/peak_current_A", "/drive/continuous_current_A"}) {
      const std::string unit = has(current) ? known_.at(current).unit : "";
      const bool is_rms = unit.ends_with("rms"), is_peak = unit.ends_with("peak");
      if (!is_rms && !is_peak) continue;
      assume(pointer, "the ampere of the sheet's currents; Kt may be of another");
      return is_rms ? CurrentConvention::kRmsPhase : CurrentConvention::kPeakPhase;
    }
    assume(pointer, "of one equivalent winding, as hobby motors have it; the sheet does not say");
    return CurrentConvention::kDc;
  }

  double in_SI(const char* pointer) const;

  std::optional<CurrentConvention> convention_of_constants() {
    const double constant_Nm_A = in_SI("/motor/torque_constant_Nm_A");
    const double kv_rad_s_V = in_SI("/motor/velocity_constant_rpm_V") * std::numbers::pi / 30.0;
    const double share = 1.0 / (kv_rad_s_V * constant_Nm_A);
    for (const CurrentConvention each :
         {CurrentConvention::kDc, CurrentConvention::kPeakPhase, CurrentConvention::kRmsPhase}) {
      if (std::abs(share / back_emf_share(each) - 1.0) > kFits) continue;
      assume("/motor/torque_constant_convention",
             fmt::format("{0}: 60 / (2 pi Kv Kt) is {1:.3g}, and is {2:.3g} where Kt is per "
                         "ampere of {0}",
                         name_of(each), share, back_emf_share(each)));
      return each;
    }
    return std::nullopt;
  }

  void add_drive() {
    document_["drive"]["bus_voltage_V"] = value("/drive/bus_voltage_V");
    if (has("/drive/peak_current_A")) {
      put("drive", "peak_current_A", "/drive/peak_current_A");
    } else {
      put("drive", "peak_torque_Nm", "/drive/peak_torque_Nm");
      explanation_ += "The peak current is the one that gives the peak torque: T / (Kt N eta).\n";
    }
    put("drive", "continuous_current_A", "/drive/continuous_current_A");
    put("drive", "supply_current_A", "/drive/supply_current_A");
    if (has("/drive/supply_current_A")) {
      explanation_ += "Power drawn is at most the supply current times the bus voltage.\n";
    }
    if (convention_ == CurrentConvention::kDc) return;
    document_["drive"]["modulation"] = "svpwm";
    assume("/drive/modulation", "as most drives work");
  }

  std::string gearbox_file() const { return has(kRatio) ? known_.at(kRatio).file : ""; }

  /// As the document names it.
  ordered_json gearbox_of_file() {
    explanation_ += "/gearbox: ratio and losses are those of its teeth.\n";
    const auto file = std::filesystem::absolute(gearbox_file());
    return {{"file", std::filesystem::proximate(file, folder_).generic_string()}};
  }

  void add_gearbox() {
    if (!gearbox_file().empty()) {
      document_["gearbox"] = gearbox_of_file();
      return;
    }
    document_["gearbox"] = {{"ratio", has(kRatio) ? value(kRatio) : ordered_json(1)},
                            {"forward_efficiency", 1},
                            {"backward_efficiency", 1}};
    if (!has(kRatio)) return;
    assume("/gearbox/forward_efficiency", "no losses: sheets do not print them");
    assume("/gearbox/backward_efficiency", "the same");
  }

  void add_datasheet() {
    ordered_json sheet;
    sheet["side"] = "joint";
    const bool is_for_lint = has("/drive/peak_current_A") && has("/drive/peak_torque_Nm");
    if (is_for_lint) sheet["peak_torque_Nm"] = value("/drive/peak_torque_Nm");
    if (has("/datasheet/no_load_speed_rad_s")) {
      sheet["no_load_speed_rad_s"] = value("/datasheet/no_load_speed_rad_s");
    }
    if (has("/motor/torque_constant_Nm_A") && has("/motor/velocity_constant_rpm_V")) {
      const ordered_json kv = value("/motor/velocity_constant_rpm_V");
      ordered_json& stated = sheet["velocity_constant_rpm_V"];
      if (kv.is_number()) stated["value"] = kv;
      if (kv.is_object()) stated = kv;
      stated["side"] = "motor";
    }
    if (sheet.size() == 1) return;
    document_["datasheet"] = sheet;
    explanation_ += "`actuator lint` holds what the sheet prints against the rest.\n";
  }

  void add_envelope() {
    explanation_ +=
        "The winding is not known, so the document is a curve: torque falls straight "
        "from rest to the no-load speed.\n";
    document_["envelope"] = {{"side", "joint"},
                             {"peak_torque_Nm", value("/drive/peak_torque_Nm")},
                             {"no_load_speed_rad_s", value("/datasheet/no_load_speed_rad_s")}};
    put("envelope", "voltage_V", "/drive/bus_voltage_V");
    if (!gearbox_file().empty()) {
      document_["gearbox"] = gearbox_of_file();
    } else if (has(kRatio)) {
      document_["gearbox"]["ratio"] = value(kRatio);
    }
    name_unused();
  }

  void name_unused() {
    std::string names;
    for (const SheetQuestion& question : kSheetQuestions) {
      const bool is_of_winding =
          question.pointer.starts_with("/motor/") || question.pointer.ends_with("_current_A");
      if (!is_of_winding || !known_.contains(question.pointer)) continue;
      names += (names.empty() ? "" : ", ") + std::string(question.name);
    }
    if (has("/drive/supply_current_A")) {
      names += (names.empty() ? "" : ", ") + std::string(kSupplyCurrent.name);
    }
    if (!names.empty()) explanation_ += fmt::format("Not used: {}.\n", names);
  }

  std::filesystem::path folder_;  ///< Where the document will be.
  std::map<std::string, Typed, std::less<>> known_;
  CurrentConvention convention_ = CurrentConvention::kDc;
  ordered_json document_{{"kind", "actuator"}, {"version", 1}};
  ordered_json assumed_ = ordered_json::array();
  std::string explanation_;
};

/// In the place of a file's name.
constexpr const char* kAnswer = "answer";

/// As an actuator that names it would read it, from here.
void check_gearbox(const std::string& file) {
  const io::Document document{
      kAnswer, "", {{"kind", "actuator"}, {"gearbox", {{"file", file}}}}, ""};
  std::vector<io::Document> read;
  (void)actuator::transmission_from_file(document.root["gearbox"], document, {}, read);
}

/// As the document is read.
io::Document checked(std::string_view pointer, const Typed& typed) {
  const ordered_json document = document_around(pointer, value_of(typed));
  auto root = nlohmann::json::parse(document.dump());
  std::vector<io::Fault> faults;
  io::take_stated_units(root, io::schema_of("actuator"), kAnswer, faults);
  if (!faults.empty()) throw io::SpecError(std::move(faults));
  return io::check_document(std::move(root), "actuator", kAnswer, "");
}

double Sheet::in_SI(const char* pointer) const {
  const io::Document document = checked(pointer, known_.at(pointer));
  const nlohmann::json& value = document.root[nlohmann::json::json_pointer(pointer)];
  return value.is_object() ? value["value"].get<double>() : value.get<double>();
}

/// Voltage, ratio and supply current hold for all else, and are numbers.
bool takes_bound(std::string_view pointer) {
  return pointer != "/drive/bus_voltage_V" && pointer != "/gearbox/ratio" &&
         pointer != kSupplyCurrent.pointer;
}

/// With the unit as it was typed.
std::string message_of(const io::Fault& fault, const Typed& typed) {
  const std::string spelt = fmt::format("\"{}\" is not one of", typed.unit);
  if (!fault.message.starts_with(spelt)) return fault.message;
  return fmt::format("\"{}\" is not one of{}", typed.typed_unit,
                     fault.message.substr(spelt.size()));
}

std::optional<std::string> objection(const SheetQuestion& question, const std::string& answer) {
  const Typed number = taken_apart(question, answer);
  if (!number.fault.empty()) {
    return fmt::format("\"{}\": {}; as an example: {}", answer, number.fault, question.example);
  }
  if (!number.bound.empty() && !takes_bound(question.pointer)) {
    return fmt::format("\"{}\": {} is a number, not a bound", answer, question.name);
  }
  try {
    if (!number.file.empty()) check_gearbox(number.file);
    if (number.file.empty()) checked(question.pointer, number);
  } catch (const io::SpecError& error) {
    return fmt::format("\"{}\": {}", answer, message_of(error.faults().front(), number));
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> sheet_objection(const SheetQuestion& question,
                                           const std::string& answer) {
  const auto [first, second] = parts_of(question, answer);
  const auto wrong = objection(question, first);
  return wrong || second.empty() ? wrong : objection(kSupplyCurrent, second);
}

SheetDocument sheet_document(const SheetAnswers& answers, const std::filesystem::path& folder) {
  return Sheet(answers, folder).document();
}

}  // namespace torquewright::cli
