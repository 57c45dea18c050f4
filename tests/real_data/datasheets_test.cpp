// SPDX-License-Identifier: Apache-2.0
// Public data sheets, collected and judged by hand before the rules were made
// (datasheets/README.md). Oracle: those verdicts. The counts may only become better.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "actuator/lint/examination.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "io/document.hpp"

namespace torquewright::actuator::lint {
namespace {

namespace fs = std::filesystem;

const fs::path kSheets = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "tests" / "real_data" / "datasheets";

/// By document: "sound", "contradictory" or "not decidable", as the table says.
std::map<std::string, std::string> verdicts() {
  std::map<std::string, std::string> all;
  std::ifstream table(kSheets / "README.md");
  for (std::string line; std::getline(table, line);) {
    if (!line.starts_with("| [")) continue;
    const std::string name = line.substr(3, line.find(']') - 3);
    for (const char* verdict : {"sound", "contradictory", "not decidable"}) {
      if (line.find(std::string("| ") + verdict) != std::string::npos) all[name] = verdict;
    }
  }
  return all;
}

bool alarms(const Actuator& document) {
  return has_contradiction(examine_all(std::vector{document}));
}

Actuator sheet(const std::string& name) {
  return read_actuator((kSheets / (name + ".json")).string()).actuator;
}

/// The same with another torque constant, whether that stands alone or says its side.
Actuator with_torque_constant_times(double factor, const std::string& name) {
  io::Document document = io::read_document(kSheets / (name + ".json"), "actuator");
  nlohmann::json& constant = document.root["motor"]["torque_constant_Nm_A"];
  nlohmann::json& value = constant.is_object() ? constant["value"] : constant;
  value = value.get<double>() * factor;
  return read_actuator(std::move(document)).actuator;
}

TEST(Datasheets, AreAllJudgedByHand) {
  std::set<std::string> documents;
  for (const auto& entry : fs::directory_iterator(kSheets)) {
    if (entry.path().extension() == ".json") documents.insert(entry.path().stem());
  }
  std::set<std::string> judged;
  for (const auto& [name, verdict] : verdicts()) judged.insert(name);
  EXPECT_EQ(judged, documents);
  EXPECT_GE(judged.size(), 20u);
}

/// Cried at though sound, but for the two that are missed though contradictory (maxon_ecmax40_120w,
/// and one that was held out). They may only become fewer.
const std::set<std::string> kWrong = {"dynamixel_ex106", "dynamixel_xm540_w270",
                                      "maxon_ecmax40_120w", "myactuator_x8_pro_v2",
                                      "uav_motor_36v"};

TEST(Datasheets, AreCriedAtWhereTheyContradictThemselves) {
  std::set<std::string> wrong;
  for (const auto& [name, verdict] : verdicts()) {
    if (verdict == "not decidable") continue;
    if (alarms(sheet(name)) != (verdict == "contradictory")) wrong.insert(name);
  }
  EXPECT_EQ(wrong, kWrong);
}

// Oracle: the culprit that each verdict of the open group names (of the last: one of the two).
TEST(Datasheets, OfTheOpenGroupNameTheirCulprit) {
  const std::map<std::string, std::set<std::string>> kCulprits = {
      {"maxon_ec45flat_30w_200142", {"/datasheet/stall_torque_Nm"}},
      {"orbray_bms10_1008", {"/datasheet/stall_torque_Nm"}},
      {"mit_mini_cheetah_2019_10",
       {"/motor/back_emf_constant_V_s_rad", "/motor/torque_constant_Nm_A"}}};
  for (const auto& [name, culprits] : kCulprits) {
    int contradictions = 0;
    for (const Finding& finding : examine(sheet(name)).findings) {
      if (finding.severity == Severity::kNote) continue;
      ++contradictions;
      std::set<std::string> named;
      for (const Numerals& set : finding.culprits) {
        for (const std::string& numeral : set) {
          if (culprits.contains(numeral)) named.insert(numeral);
        }
        EXPECT_TRUE(culprits.contains(set.front())) << name << ": " << set.front();
      }
      EXPECT_EQ(named, culprits) << name;
    }
    EXPECT_EQ(contradictions, 1) << name;
  }
}

// A torque constant per rms ampere read as one per ampere of amplitude, or the other way.
TEST(Datasheets, AreCriedAtWhereTheTorqueConstantIsOffByRootThree) {
  int checked = 0;
  std::set<std::string> missed;
  for (const auto& [name, verdict] : verdicts()) {
    if (verdict != "sound" || kWrong.contains(name)) continue;
    for (const double factor : {std::sqrt(3.0), 1.0 / std::sqrt(3.0)}) {
      ++checked;
      if (!alarms(with_torque_constant_times(factor, name)))
        missed.insert(name + (factor > 1.0 ? " times" : " over"));
    }
  }
  EXPECT_EQ(checked, 38);
  EXPECT_EQ(missed, std::set<std::string>{});
}

}  // namespace
}  // namespace torquewright::actuator::lint
