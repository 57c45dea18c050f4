// SPDX-License-Identifier: Apache-2.0
// What is said to a wrong key or a word in other capitals. Oracle: the documents that the schemas
// start from, each with one slip of the kind that newcomers make, and what each of them meant.
#include "io/faults/meant_key.hpp"

#include <gtest/gtest.h>

#include "io/documents/document.hpp"
#include "io/documents/schema.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;

json started(const std::string& kind) {
  return json::parse(schema_as_written(kind)["examples"].front().dump());
}

std::string refusal(const json& document) {
  try {
    check_document(document, document["kind"].get<std::string>(), "f", "");
    return "";
  } catch (const SpecError& error) {
    return error.what();
  }
}

/// What is said where the key at the pointer has another name.
std::string refusal_of_renamed(const std::string& kind, const std::string& pointer,
                               const std::string& wrong) {
  json document = started(kind);
  const json::json_pointer place(pointer);
  json& parent = document[place.parent_pointer()];
  parent[wrong] = parent[place.back()];
  parent.erase(place.back());
  return refusal(document);
}

struct RenamedKey {
  std::string kind;
  std::string right;  ///< Pointer.
  std::string wrong;
};

TEST(WrongKey, LeadsToTheRightOne) {
  const std::vector<RenamedKey> slips = {
      {"gearbox_problem", "/rotor_inner_diameter_mm", "rotor_diameter_mm"},
      {"gearbox_problem", "/target_ratio", "ratio"},
      {"gearbox_problem", "/target_ratio", "gear_ratio"},
      {"gearbox_problem", "/planet_count", "planets"},
      {"gearbox_problem", "/module_mm", "module"},
      {"gearbox_problem", "/load/output_torque_Nm", "torque"},
      {"gearbox", "/planet_count", "planets"},
      {"actuator", "/motor/torque_constant_Nm_A", "kt"},
      {"actuator", "/motor/torque_constant_Nm_A", "Kt"},
      {"actuator", "/motor/torque_constant_Nm_A", "torque_constant"},
      {"actuator", "/motor/resistance_ohm", "resistance"},
      {"actuator", "/motor/resistance_ohm", "resistence_ohm"},
      {"actuator", "/drive/bus_voltage_V", "voltage"},
      {"actuator", "/drive/bus_voltage_V", "voltage_V"},
      {"actuator", "/drive/peak_current_A", "max_current"},
      {"actuator", "/gearbox/ratio", "gear_ratio"},
      {"actuator", "/datasheet/velocity_constant_rpm_V", "kv"},
  };
  for (const RenamedKey& slip : slips) {
    const json::json_pointer place(slip.right);
    const std::string wrong_place = (place.parent_pointer() / slip.wrong).to_string();
    const std::string said = refusal_of_renamed(slip.kind, slip.right, slip.wrong);
    EXPECT_NE(
        said.find("f#" + wrong_place + ": unknown key; did you mean \"" + place.back() + "\"?"),
        std::string::npos)
        << slip.wrong << ": " << said;
  }
}

TEST(WrongKey, LeadsToAnotherPlace) {
  json actuator = started("actuator");
  actuator["drive"]["poles"] = 14;
  EXPECT_EQ(refusal(actuator), "f#/drive/poles: unknown key; it is /motor/pole_pairs");
}

TEST(WrongKey, LeadsToAKeyThatIsThereOnlyWhereNoOtherFits) {
  json problem = started("gearbox_problem");
  problem["ring_outer_diamater_mm"] = 60;
  EXPECT_EQ(refusal(problem),
            "f#/ring_outer_diamater_mm: unknown key; did you mean \"ring_outer_diameter_mm\"?");
  problem.erase("ring_outer_diamater_mm");
  problem.erase("rotor_inner_diameter_mm");
  problem["rotor_outer_diameter_mm"] = 60;  // two letters from the ring's, which stands there
  EXPECT_NE(refusal(problem).find("did you mean \"rotor_inner_diameter_mm\"?"), std::string::npos);
}

TEST(MissingKey, ListsTheWordsThatAreAllowed) {
  json actuator = started("actuator");
  actuator["motor"].erase("resistance_convention");
  EXPECT_EQ(
      refusal(actuator),
      "f#/motor/resistance_convention: missing, must be \"dc\", \"phase\" or \"line_to_line\"");
}

TEST(ListedWord, MayHaveOtherCapitals) {
  json problem = started("gearbox_problem");
  problem["topology"] = "3K";
  problem["constraints"] = "Buildable";
  const Document document = check_document(problem, "gearbox_problem", "f", "");
  EXPECT_EQ(document.root["topology"], "3k");
  EXPECT_EQ(document.root["constraints"], "buildable");
}

/// Every list of words in a schema.
void collect_choices(const json& schema, std::vector<json>& lists) {
  if (!schema.is_structured()) return;
  if (schema.is_object() && schema.contains("enum")) lists.push_back(schema["enum"]);
  for (const json& part : schema) collect_choices(part, lists);
}

// Else two words that differ in capitals alone would be one.
TEST(ListedWords, DifferInMoreThanCapitals) {
  for (const std::string& kind : document_kinds()) {
    std::vector<json> lists;
    collect_choices(schema_of(kind), lists);
    for (const json& list : lists) {
      std::vector<std::string> small;
      for (const json& word : list) {
        std::string text = word.dump();
        for (char& letter : text) letter = static_cast<char>(std::tolower(letter));
        small.push_back(text);
      }
      std::sort(small.begin(), small.end());
      EXPECT_EQ(std::adjacent_find(small.begin(), small.end()), small.end()) << kind << list;
    }
  }
}

}  // namespace
}  // namespace torquewright::io
