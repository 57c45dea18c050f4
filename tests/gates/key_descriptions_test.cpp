// SPDX-License-Identifier: Apache-2.0
// Every key of every schema says what it means and in which unit; documents to start from hold
// every key that can stand beside the others. Oracle: the files of specs/schema, walked here, and
// the units that the keys' names end in (docs/notation.md).
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <regex>

#include "io/documents/document.hpp"
#include "tests/gates/source_tree.hpp"

namespace torquewright::gates {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json schema_in(const fs::path& file) { return json::parse(text_of(file)); }

const json& referenced(const json& node, const json& root) {
  return root.at(json::json_pointer(node["$ref"].get<std::string>().substr(1)));
}

/// The node, what it refers to, and its alternatives and entries.
bool any_of_its_nodes(const json& node, const json& root,
                      const std::function<bool(const json&)>& holds) {
  if (holds(node)) return true;
  const bool is_inside = node.contains("$ref") && node["$ref"].get<std::string>().starts_with('#');
  if (is_inside && any_of_its_nodes(referenced(node, root), root, holds)) return true;
  for (const json& each : node.value("anyOf", json::array())) {
    if (any_of_its_nodes(each, root, holds)) return true;
  }
  return node.contains("items") && node["items"].is_object() &&
         any_of_its_nodes(node["items"], root, holds);
}

bool is_described(const json& node, const json& root) {
  if (node.contains("description")) return true;
  const bool is_inside = node.contains("$ref") && node["$ref"].get<std::string>().starts_with('#');
  return is_inside && is_described(referenced(node, root), root);
}

/// Calls with every key of the schema and its node, wherever it stands.
void for_each_key(const json& schema,
                  const std::function<void(const std::string&, const json&)>& visit) {
  if (!schema.is_structured()) return;
  if (schema.is_object() && schema.contains("properties") && schema["properties"].is_object()) {
    for (const auto& [key, node] : schema["properties"].items()) visit(key, node);
  }
  for (const auto& [key, part] : schema.items()) {
    if (!schema.is_object() || key != "examples") for_each_key(part, visit);
  }
}

TEST(EveryKey, IsDescribed) {
  std::size_t count = 0;
  for (const fs::path& file : files_in("specs/schema", ".json")) {
    const json schema = schema_in(file);
    for_each_key(schema, [&](const std::string& key, const json& node) {
      EXPECT_TRUE(is_described(node, schema)) << file << ": " << key << " lacks a description";
      ++count;
    });
  }
  EXPECT_GT(count, 1000u);
}

/// What a key's name says of its unit: resistance_ohm.
std::string unit_in_name(const std::string& key) {
  static const std::vector<std::pair<std::string, std::string>> kEndings = {
      {"rad_per_mm", "rad/mm"},
      {"V_s_rad", "V s/rad"},
      {"Nm_s_rad", "Nm s/rad"},
      {"N_s_m", "N s/m"},
      {"Nm_rad", "Nm/rad"},
      {"N_m", "N/m"},
      {"rpm_V", "rpm/V"},
      {"Nm_A", "Nm/A"},
      {"Nm_s", "Nm s"},
      {"kg_m2_s", "kg m^2/s"},
      {"kg_m2", "kg m^2"},
      {"kg_m3", "kg/m^3"},
      {"K_W", "K/W"},
      {"J_K", "J/K"},
      {"m_s2", "m/s^2"},
      {"rad_s", "rad/s"},
      {"m_s", "m/s"},
      {"N_s", "N s"},
      {"MPa", "MPa"},
      {"ohm", "ohm"},
      {"rad", "rad"},
      {"mm", "mm"},
      {"kg", "kg"},
      {"Nm", "Nm"},
      {"hz", "Hz"},
      {"H", "H"},
      {"V", "V"},
      {"A", "A"},
      {"W", "W"},
      {"K", "K"},
      {"J", "J"},
      {"N", "N"},
      {"s", "s"},
      {"m", "m"}};
  for (const auto& [ending, unit] : kEndings) {
    if (key.ends_with("_" + ending)) return unit;
  }
  return "";
}

TEST(EveryKey, HasTheUnitThatItsNameEndsIn) {
  std::size_t count = 0;
  for (const fs::path& file : files_in("specs/schema", ".json")) {
    const json schema = schema_in(file);
    for_each_key(schema, [&](const std::string& key, const json& node) {
      const std::string unit = unit_in_name(key);
      const bool is_object = any_of_its_nodes(node, schema, [](const json& each) {
        const json properties = each.value("properties", json::object());
        return each.value("type", json()) == "object" && !properties.contains("value") &&
               !properties.contains("least");
      });
      if (unit.empty() || is_object) return;  // widths by layer: the unit stands at the layers
      const bool has_unit = any_of_its_nodes(
          node, schema, [&](const json& each) { return each.value("unit", "") == unit; });
      EXPECT_TRUE(has_unit) << file << ": " << key << " is not in " << unit;
      ++count;
    });
  }
  EXPECT_GT(count, 300u);
}

TEST(EverySchema, SaysWhichItIs) {
  for (const fs::path& file : files_in("specs/schema", ".json")) {
    const json schema = schema_in(file);
    EXPECT_EQ(schema["$id"], "https://torquewright.invalid/schema/" + file.filename().string());
    EXPECT_EQ(schema["properties"]["$schema"]["type"], "string") << file;
  }
}

/// Keys that a document to start from leaves out, and why. Patterns of their pointers.
struct LeftOut {
  std::string pattern;
  std::string reason;
};

const std::vector<LeftOut> kLeftOut = {
    {R"(.*: /\$schema)", "names a file that each user has elsewhere"},
    {R"(actuator: .*/(value|side|ampere|bound|unit|tolerance|also))",
     "a number may say so too; the example shows each of them at least once, but for `unit` and "
     "`also`"},
    {R"(actuator: /(envelope|sources).*)",
     "in the place of motor and drive: `init actuator --envelope`"},
    {"actuator: /(motor/velocity_constant_rpm_V|drive/(peak|continuous)_torque_Nm)",
     "in the place of the torque constant and of currents, where a sheet prints these alone"},
    {R"(actuator: /effects/\*/(provenance/.*|replaces|standard_error))",
     "written by identify; a word stands for the provenance"},
    {"actuator: /gearbox/(file|friction_coefficient)", "in place of the numbers that stand there"},
    {"gear_strength: /gearbox/file", "in place of the gears that stand there"},
    {"gear(box|_strength): .*layer_2_module_mm", "most gearboxes have one module"},
    {"gear.*: .*/(planet|ring)(/.*)?", "of a planetary gearbox; the example is a 3k"},
    {"gear_strength: /own_material/.*", "one gear of another steel is shown"},
    {"gearbox_problem: /synthesis(/.*)?",
     "chooses face widths, which the example states: specs/gearbox/knee_synthesis.json"},
    {"jacobian: /table(/.*)?", "in place of the matrix"},
    {R"(randomisation: .*/\*/(bodies|drives|joints))", "names of one robot; absent: all"},
    {R"(policy: /estimator/layers/\*/(activation|alpha))", "shown by the layers behind"},
    {R"(policy: /outputs/\*/course)", "of one that goes along a motion"},
    {"randomisation: /state_of_charge(/.*)?", "needs batteries with a curve"},
    {R"(rig: (.*/links(/.*)?|/columns/\*/joint))", "of a serial arm; the example is a pendulum"},
    {R"(rig: .*/steady)", "of a dynamometer; the example is a pendulum"},
    {R"(rig: (.*/(file|base|roll_rad|pitch_rad|held_rad)(/.*)?|/controllers?(/.*)?|/alike(/.*)?))",
     "of a robot; the example is a pendulum"},
    {R"(robot: /base/(position_m|rotation_rpy_rad))", "of a fixed base"},
    {R"(robot: /joints/\*/(force_limit_N|range_m|reflected_mass_kg|speed_limit_m_s))",
     "of a prismatic joint"},
    {R"(robot: /joints/\*/(damping_N_s_m|.*_friction_N|stiffness_N_m|spring_rest_m))",
     "of a prismatic joint"},
    {R"(robot: /mechanisms/\*/(branch|c(losures|oupler|rank).*|ground.*|jacobian|lever.*|links.*|rocker.*|rod.*|transmission_angle.*|turned))",
     "of mechanisms that are not direct"},
    {R"(robot: /followers.*)", "of loops that no drive turns; the example is a chain"},
    {R"(robot: /mechanisms/\*/reflected_inertia_kg_m2)", "the example's joint states it"},
    {R"(robot: /mechanisms/\*/transmission_limit/strength)", "in place of the torque"},
};

bool stands_in(const json& value, const std::vector<std::string>& path, std::size_t at = 0) {
  if (at == path.size()) return true;
  if (path[at] != "*") {
    return value.is_object() && value.contains(path[at]) &&
           stands_in(value[path[at]], path, at + 1);
  }
  return value.is_structured() && std::any_of(value.begin(), value.end(), [&](const json& child) {
           return stands_in(child, path, at + 1);
         });
}

/// The paths of a schema's keys, with * for entries of lists and for any key.
void collect_paths(const json& node, const json& root, const std::vector<std::string>& path,
                   std::vector<std::vector<std::string>>& paths) {
  if (node.contains("$ref")) return collect_paths(referenced(node, root), root, path, paths);
  const auto below = [&](const std::string& step) {
    std::vector<std::string> longer = path;
    longer.push_back(step);
    return longer;
  };
  if (node.contains("properties")) {
    for (const auto& [key, child] : node["properties"].items()) {
      paths.push_back(below(key));
      collect_paths(child, root, below(key), paths);
    }
  }
  for (const char* keyword : {"items", "additionalProperties"}) {
    if (!node.contains(keyword) || !node[keyword].is_object()) continue;
    collect_paths(node[keyword], root, below("*"), paths);
  }
  for (const json& each : node.value("anyOf", json::array())) {
    collect_paths(each, root, path, paths);
  }
}

TEST(EveryDocumentToStartFrom, HoldsEveryKeyThatCanStandThere) {
  std::vector<std::size_t> uses(kLeftOut.size(), 0);
  for (const fs::path& file : files_in("specs/schema", ".json")) {
    const json schema = schema_in(file);
    if (!schema.contains("examples")) continue;
    std::vector<std::vector<std::string>> paths;
    collect_paths(schema, schema, {}, paths);
    for (const std::vector<std::string>& path : paths) {
      if (stands_in(schema["examples"].front(), path)) continue;
      std::string name = file.stem().string() + ": ";
      for (const std::string& step : path) name += "/" + step;
      bool is_excused = false;
      for (std::size_t i = 0; i < kLeftOut.size(); ++i) {
        if (!std::regex_match(name, std::regex(kLeftOut[i].pattern))) continue;
        is_excused = true;
        ++uses[i];
      }
      EXPECT_TRUE(is_excused) << name << " is missing in the document to start from";
    }
  }
  for (std::size_t i = 0; i < kLeftOut.size(); ++i) {
    EXPECT_GT(uses[i], 0u) << kLeftOut[i].pattern << " needs no excuse any more";
  }
}

TEST(EveryDocumentToStartFrom, HasTheShapeOfItsKind) {
  for (const fs::path& file : files_in("specs/schema", ".json")) {
    const json schema = schema_in(file);
    if (!schema.contains("examples")) continue;
    EXPECT_NO_THROW(
        io::check_document(schema["examples"].front(), file.stem().string(), file.string(), ""))
        << file;
  }
}

}  // namespace
}  // namespace torquewright::gates
