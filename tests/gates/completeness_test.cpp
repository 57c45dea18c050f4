// SPDX-License-Identifier: Apache-2.0
// Whatever lies in a folder of like parts is in that part's library, in the docs and in the
// schemas. Oracle: the files themselves, against what the libraries answer, the tables of docs/ and
// the enumerations of specs/schema.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "actuator/effects/library.hpp"
#include "actuator/exporters/library.hpp"
#include "actuator/lint/check.hpp"
#include "gearbox/any_topology.hpp"
#include "gearbox/topologies/topology.hpp"
#include "hopper/engines/library.hpp"
#include "hopper/planning/constraints/library.hpp"
#include "hopper/planning/objectives/library.hpp"
#include "hopper/planning/tasks/library.hpp"
#include "hopper/tracking/library.hpp"
#include "identification/imports/importer.hpp"
#include "identification/outputs/output.hpp"
#include "robot/mechanisms/library_spec.hpp"
#include "tests/gates/excuses.hpp"
#include "tests/gates/source_tree.hpp"

namespace torquewright::gates {
namespace {

namespace fs = std::filesystem;

/// Parts of one kind: one file each (or a few in one), without a header of their own.
struct Library {
  std::string_view what;
  fs::path folder;
  std::string definition;  ///< Its first group is the constant or function that a file defines.
  Names registered;        ///< What the library answers, spelt as in documents.
  std::vector<Excuse> excuses;  ///< Files that define none and have no header either.
};

void PrintTo(const Library& library, std::ostream* stream) { *stream << library.what; }

std::string constant_of(std::string type) { return "^const " + std::move(type) + R"( (\w+) = \{)"; }

/// `isaac-lab-2.3` is the constant isaac_lab_2_3, "feet stay" is feet_stay; `3k` is three_k, since
/// no name in C++ begins with a digit.
std::string constant_called(std::string name) {
  if (name.starts_with("3k")) name.replace(0, 2, "three_k");
  std::replace(name.begin(), name.end(), '-', '_');
  std::replace(name.begin(), name.end(), '.', '_');
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

template <typename List, typename Name>
Names names_of(const List& list, Name name) {
  Names names;
  for (const auto& entry : list) names.emplace(name(entry));
  return names;
}

Names effects() {
  return names_of(actuator::effect_library(), [](auto* effect) { return effect->name; });
}
Names exporters() {
  return names_of(actuator::exporter_library(), [](auto* exporter) { return exporter->name; });
}
Names lint_checks() {
  return names_of(actuator::lint::library(), [](auto* check) { return check->rule; });
}
Names importers() {
  return names_of(identification::importer_library(),
                  [](auto* importer) { return importer->name; });
}
Names outputs() {
  return names_of(identification::output_library(), [](auto* output) { return output->name; });
}
Names mechanisms() {
  return names_of(hopper::mechanism_types(), [](auto* type) { return type->name; });
}
Names topologies() {
  return names_of(gearbox::topologies(), [](const auto& topology) { return topology.name; });
}
Names objectives() {
  return names_of(hopper::every_objective(), [](const auto& one) { return one.name; });
}
Names constraints() {
  return names_of(hopper::every_constraint(), [](auto* one) { return one->name; });
}
Names tasks() {
  return names_of(hopper::every_task(), [](auto* task) { return task->name; });
}
Names engines() {
  return names_of(hopper::every_engine(), [](auto* engine) { return engine->name; });
}
Names controllers() {
  return names_of(hopper::every_controller(), [](auto* kind) { return kind->name; });
}
/// kEveryRule holds functions, which have no names when the program runs.
Names hopper_rules() {
  const std::string text = text_of("hopper/check/rules/every_rule.hpp");
  return matches(text.substr(text.find("kEveryRule")), R"((\w+)(?=[,}]))");
}

std::vector<Library> libraries() {
  return {
      {"effects", "actuator/effects", constant_of("EffectKind"), effects(), {}},
      {"exporters", "actuator/exporters", constant_of("Exporter"), exporters(), {}},
      {"imports",
       "identification/imports",
       constant_of("Importer"),
       importers(),
       {{"identification/imports/library.cpp", "the list"}}},
      {"outputs",
       "identification/outputs",
       constant_of("Output"),
       outputs(),
       {{"identification/outputs/library.cpp", "the list"}}},
      {"lint",
       "actuator/lint",
       constant_of("Check"),
       lint_checks(),
       {{"actuator/lint/explanations.cpp", "the other ways of reading numbers, for all checks"},
        {"actuator/lint/library.cpp", "the list"},
        {"actuator/lint/same_motor.cpp", "compares several documents; a check looks at one"}}},
      {"mechanisms", "robot/mechanisms", constant_of("MechanismType"), mechanisms(), {}},
      {"topologies",
       "gearbox/topologies",
       R"(^Topology (topology)\()",
       topologies(),
       {{"gearbox/topologies/common_remarks.cpp", "remarks of all topologies"},
        {"gearbox/topologies/three_k_constraints.cpp", "a part of three_k.cpp"},
        {"gearbox/topologies/three_k_remarks.cpp", "a part of three_k.cpp"}}},
      {"rules",
       "hopper/check/rules",
       R"(^std::vector<Finding> (\w+)\(const CheckedMotion& checked\) \{)",
       hopper_rules(),
       {}},
      {"objectives",
       "hopper/planning/objectives",
       R"(^const Objective objectives::(\w+)\{)",
       objectives(),
       {}},
      {"constraints",
       "hopper/planning/constraints",
       R"(^const Constraint constraints::(\w+)\{)",
       constraints(),
       {}},
      {"tasks", "hopper/planning/tasks", constant_of("PlanTask"), tasks(), {}},
      {"engines",
       "hopper/engines",
       constant_of("EngineKind"),
       engines(),
       {{"hopper/engines/mujoco_absent.cpp", "a part of mujoco.cpp"},
        {"hopper/engines/mujoco_engine.cpp", "a part of mujoco.cpp"}}},
      {"controllers",
       "hopper/tracking",
       constant_of("ControllerKind"),
       controllers(),
       {{"hopper/tracking/lqr_controller.cpp", "a part of lqr_kind.cpp"}}},
  };
}

class EveryFile : public testing::TestWithParam<Library> {};

TEST_P(EveryFile, IsInItsLibrary) {
  const Library& library = GetParam();
  Names defined;
  Names strangers;
  for (const fs::path& file : files_in(library.folder, ".cpp")) {
    const Names here = matches(text_of(file), library.definition);
    for (const std::string& name : here) {
      defined.insert(name == "topology" ? file.stem().string() : name);
    }
    const bool has_header = fs::exists(root() / fs::path(file).replace_extension(".hpp"));
    if (here.empty() && !has_header) strangers.insert(file.generic_string());
  }
  Names registered;
  for (const std::string& name : library.registered) registered.insert(constant_called(name));
  EXPECT_EQ(defined, registered);
  expect_excused(strangers, library.excuses, "defines nothing that its library could list");
}

INSTANTIATE_TEST_SUITE_P(Libraries, EveryFile, testing::ValuesIn(libraries()),
                         [](const auto& test) { return std::string(test.param.what); });

/// String literals in folders that are spelt as the rules of findings are: friction-cone.
Names rules_in(const std::vector<fs::path>& folders) {
  Names rules;
  for (const fs::path& folder : folders) {
    for (const fs::path& file : files_in(folder, ".cpp")) {
      const std::string text = text_of(file);
      rules.merge(matches(text, R"re("([a-z]+(?:-[a-z]+)+)")re"));
      rules.merge(matches(text, R"re((?:Severity::k\w+,\s*|\.rule = )"([a-z]+)")re"));
    }
  }
  return rules;
}

TEST(Docs, NameEverySimulatorFormat) {
  EXPECT_EQ(matches(text_of("docs/simulator_formats.md"), "^## `([^`]+)`"), exporters());
}

TEST(Docs, NameEveryImporter) {
  EXPECT_EQ(named_in_first_column(section(text_of("docs/logs.md"), "## Imports")), importers());
}

TEST(Docs, NameEveryOutput) {
  EXPECT_EQ(named_in_first_column(section(text_of("docs/logs.md"), "## Outputs")), outputs());
}

TEST(Docs, NameEveryMechanism) {
  EXPECT_EQ(named_in_first_column(section(text_of("docs/robot_documents.md"), "## Mechanisms")),
            mechanisms());
}

TEST(Docs, NameEveryRuleOfTheLint) {
  const Names found = rules_in({"actuator/lint"});
  EXPECT_EQ(named_in_first_column(text_of("docs/lint.md")), found);
  for (const std::string& name : lint_checks()) EXPECT_TRUE(found.contains(name)) << name;
}

TEST(Docs, NameEveryRuleOfTheChecks) {
  EXPECT_EQ(named_in_first_column(text_of("docs/checks.md")),
            rules_in({"actuator/check", "actuator/drive_check", "hopper/check", "hopper/demand"}));
}

/// Name, unit and sentence are the row.
TEST(Docs, SayEveryConstraintOfThePlanner) {
  const std::string table = section(text_of("docs/flip.md"), "## What a plan obeys");
  EXPECT_EQ(named_in_first_column(table), constraints());
  for (const hopper::Constraint* one : hopper::every_constraint()) {
    const std::string_view unit = one->unit.empty() ? "-" : one->unit;
    const std::string row = fmt::format("| `{}` | {} | {} |\n", one->name, unit, one->sentence);
    EXPECT_NE(table.find(row), std::string::npos) << row;
  }
}

TEST(Docs, NameEveryTopology) {
  const Names headings = matches(text_of("docs/gearbox_constraints.md"), R"(^## (\w+))");
  for (const std::string& name : topologies()) EXPECT_TRUE(headings.contains(name)) << name;
}

/// A key of documents under which a part of a library is named.
struct NamingKey {
  std::string key;
  std::string only_in;  ///< The kind whose schema is meant; empty: all.
  Names names;
  std::string wider_kind = {};  ///< Whose schema knows one word more.
  std::string word = {};
};

/// Its own, and those of the checks that a replay uses.
Names replay_rules() {
  Names rules = rules_in({"hopper/replay", "hopper/replay_report", "hopper/skill"});
  rules.insert({"assumed", "battery-charge", "joint-speed", "joint-torque", "transmission-load"});
  return rules;
}

std::vector<NamingKey> naming_keys() {
  return {
      {"topology", "", topologies(), "gearbox_problem", std::string(gearbox::kAnyTopology)},
      {"format", "simulator_file", exporters()},
      {"rule", "check_report",
       rules_in({"actuator/check", "actuator/drive_check", "hopper/check", "hopper/demand"})},
      {"rule", "replay_report", replay_rules()},
      {"rule", "lint_report", rules_in({"actuator/lint"})},
      {"effect", "", effects()},
      {"replaces", "", effects()},
      {"constraint", "", named_in_first_column(text_of("docs/gearbox_constraints.md"))},
  };
}

const std::vector<Excuse> kFreeNames = {
    {"actuator: effect",
     "its reader refuses an unknown effect and names the nearest one, which a schema cannot do"},
    {"actuator: replaces", "what a document says of its past: an unknown name changes no number"},
    {"gearbox_result: constraint",
     "read by `gearbox verify`, which says what it expects where a constraint's name differs"},
    {"check_report: effect", "as an actuator's document has it, whose reader refuses unknown ones"},
    {"identification_report: effect", "effects of rig and log stand in no library"},
    {"identification_report: replaces", "effects of rig and log stand in no library"},
};

/// What stands for the schema: itself, or the definition that it refers to.
const nlohmann::json& resolved(const nlohmann::json& schema, const nlohmann::json& root) {
  const std::string prefix = "#/definitions/";
  const std::string reference = schema.value("$ref", "");
  if (!reference.starts_with(prefix)) return schema;
  return root["definitions"][reference.substr(prefix.size())];
}

/// The schemas of all properties of that key, wherever they stand.
void find_properties(const nlohmann::json& schema, const std::string& key,
                     std::vector<nlohmann::json>& found) {
  if (!schema.is_structured()) return;
  if (schema.is_object() && schema.contains("properties") && schema["properties"].contains(key)) {
    found.push_back(schema["properties"][key]);
  }
  for (const auto& part : schema) find_properties(part, key, found);
}

TEST(Schemas, EnumerateWhatTheLibrariesHold) {
  Names free;
  for (const NamingKey& naming : naming_keys()) {
    std::size_t named = 0;
    for (const fs::path& file : files_in("specs/schema", ".json")) {
      const std::string kind = file.stem().string();
      if (!naming.only_in.empty() && naming.only_in != kind) continue;
      SCOPED_TRACE(kind + ": " + naming.key);
      const auto root = nlohmann::json::parse(text_of(file));
      std::vector<nlohmann::json> properties;
      find_properties(root, naming.key, properties);
      for (const nlohmann::json& property : properties) {
        const nlohmann::json& schema = resolved(property, root);
        ++named;
        if (schema.contains("enum")) {
          Names names = naming.names;
          if (kind == naming.wider_kind) names.insert(naming.word);
          EXPECT_EQ(schema["enum"].get<Names>(), names);
        } else {
          free.insert(kind + ": " + naming.key);
        }
      }
    }
    EXPECT_GT(named, 0u) << naming.key;
  }
  expect_excused(free, kFreeNames, "any string may stand there");
}

TEST(Schemas, EnumerateEveryMechanism) {
  const auto robot = nlohmann::json::parse(text_of("specs/schema/robot.json"));
  const auto& mechanism = robot["properties"]["mechanisms"]["items"]["properties"];
  EXPECT_EQ(mechanism["type"]["enum"].get<Names>(), mechanisms());
}

}  // namespace
}  // namespace torquewright::gates
