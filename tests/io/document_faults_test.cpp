// SPDX-License-Identifier: Apache-2.0
// The exact sentences for every kind of mistake in a document.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "io/documents/document.hpp"
#include "io/faults/diagnosis.hpp"
#include "io/faults/json_text.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;

/// The sentences, without the file's name in front.
std::string faults_of(const std::string& text) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("f", text).string();
  try {
    read_document(file, "gearbox_problem");
    return "";
  } catch (const SpecError& error) {
    std::string lines = error.what();
    for (auto at = lines.find(file); at != std::string::npos; at = lines.find(file)) {
      lines.erase(at, file.size());
    }
    return lines;
  }
}

struct Slip {
  std::string replaced;  ///< In the good document below.
  std::string with;
  std::string faults;
};

void PrintTo(const Slip& slip, std::ostream* out) { *out << slip.with; }

std::string with_slip(const Slip& slip) {
  std::string text =
      R"({"kind": "gearbox_problem", "version": 1, "topology": "3k", "target_ratio": 20,)"
      R"( "rotor_inner_diameter_mm": 79.4, "module_mm": 0.6, "planet_count": 4,)"
      R"( "min_teeth": {"sun": 40, "planet_1": 40, "planet_2": 30},)"
      R"( "min_carrier_clearance_rad": 0.26, "constraints": "paper", "objective": "paper_cost"})";
  return text.replace(text.find(slip.replaced), slip.replaced.size(), slip.with);
}

class OneSlip : public testing::TestWithParam<Slip> {};

TEST_P(OneSlip, IsNamedAtItsPlace) {
  EXPECT_EQ(faults_of(with_slip(GetParam())), GetParam().faults);
}

INSTANTIATE_TEST_SUITE_P(
    Shape, OneSlip,
    testing::Values(
        Slip{"20,", "20,", ""},  // no slip, no fault
        Slip{"0.6", "0.0006", "#/module_mm: 0.0006 is outside [0.05, 25] mm"},
        Slip{"0.6", "0.05", ""},  // just inside
        Slip{"0.6", "0.0499", "#/module_mm: 0.0499 is outside [0.05, 25] mm"},
        Slip{"0.6", "25.1", "#/module_mm: 25.1 is outside [0.05, 25] mm"},
        Slip{"0.6", "[0.6, 600]", "#/module_mm/1: 600 is outside [0.05, 25] mm"},
        Slip{"0.6", "[]", "#/module_mm: [] is empty, must hold at least 1 value"},
        Slip{"0.6", "\"fine\"", "#/module_mm: is a string, must be a number or a list of numbers"},
        Slip{"0.6", "[\"fine\"]", "#/module_mm/0: is a string, must be a number"},
        Slip{" 4,", " 4.5,", "#/planet_count: 4.5 is not whole, must be a whole number"},
        Slip{" 4,", " 4.0,", ""},
        Slip{" 4,", " [3, 4.5],", "#/planet_count/1: 4.5 is not whole, must be a whole number"},
        Slip{" 4,", " true,",
             "#/planet_count: is true or false, must be a whole number or a list of whole numbers"},
        Slip{" 4,", " 99999999999999999999,",
             "#/planet_count: 1e+20 is too large, must be a whole number"},
        Slip{"\"sun\"", "\"sunn\"",
             "#/min_teeth/sunn: unknown key; did you mean \"sun\"?\n#/min_teeth/sun: missing"},
        Slip{"\"sun\"", "\"a/b~c\": 1, \"sun\"",
             "#/min_teeth/a~1b~0c: unknown key; known are \"planet\", \"planet_1\", \"planet_2\", "
             "\"sun\""},
        // The ends of a range are inside, even where something else is wrong.
        Slip{"20,", "10000, \"loud\": 1,", "#/loud: unknown key; did you mean \"load\"?"},
        Slip{"20,", "1, \"loud\": 1,", "#/loud: unknown key; did you mean \"load\"?"},
        Slip{"40", "0", "#/min_teeth/sun: 0 is outside [1, 100000] teeth"},
        Slip{"\"3k\"", "\"4k\"",
             "#/topology: \"4k\" is not one of \"3k\", \"planetary\", \"3k_b\", \"compound\", "
             "\"any\""},
        Slip{"\"3k\"", "3", "#/topology: is a number, must be a string"},
        Slip{"\"target_ratio\": 20,", "", "#/target_ratio: missing"},
        Slip{"20,", "\"20\",", "#/target_ratio: is a string, must be a number"},
        Slip{"20,", "null,", "#/target_ratio: is null, must be a number"},
        Slip{"20,", "-20,", "#/target_ratio: -20 is outside [1, 10000]"},
        Slip{"{\"sun\": 40, \"planet_1\": 40, \"planet_2\": 30}", "[40, 40, 30]",
             "#/min_teeth: is a list, must be an object"},
        Slip{"\"kind\": \"gearbox_problem\", ", "", "#/kind: missing, must be \"gearbox_problem\""},
        Slip{"\"gearbox_problem\", \"version\": 1, \"topology\"",
             "\"actuator\", \"version\": 1, \"moon\"",
             "#/kind: \"actuator\" is not \"gearbox_problem\""},  // and nothing else
        Slip{"\"version\": 1", "\"version\": 2", "#/version: 2 is not 1"},
        Slip{"\"version\": 1, ", "", "#/version: missing, must be 1"},
        Slip{"20,", "20, \"target_ratio\": 21,",
             "#/target_ratio: stands twice in its object; keep one"},
        Slip{"20,", "20, \"assumed\": [\"/min_teeth/sun\", \"/min_teeth/moon\", \"sun\", 3],",
             "#/assumed/3: is a number, must be a string\n"
             "#/assumed/1: \"/min_teeth/moon\" points at nothing; must be the JSON pointer of a "
             "value of this document\n"
             "#/assumed/2: \"sun\" points at nothing; must be the JSON pointer of a value of this "
             "document"}));

INSTANTIATE_TEST_SUITE_P(
    Text, OneSlip,
    testing::Values(
        Slip{"20,", "NaN,",
             "#/target_ratio: NaN is not a JSON number, must be finite (line 1, column 77)"},
        Slip{"20,", "-Infinity,",
             "#/target_ratio: Infinity is not a JSON number, must be finite (line 1, column 78)"},
        Slip{"20,", "1e400,",
             "#/target_ratio: 1e400 is too large for a number (line 1, column 81)"},
        Slip{"0.6", "[1, 2, -1e400]",
             "#/module_mm/2: -1e400 is too large for a number (line 1, column 139)"},
        Slip{"0.26", "1e-400",
             "#/min_carrier_clearance_rad: 1e-400 is too close to zero to be told from it"},
        Slip{"0.26", "0e-400", ""},
        Slip{"20,", "20",
             ": line 1, column 104: not JSON: unexpected string literal; expected '}'"},
        Slip{"20,", "20,\n,",
             ": line 2, column 1: not JSON: unexpected ','; expected string literal"},
        Slip{"\"3k\"", "\"\xC3\xA4\", \xFF",
             ": line 1, column 60: not JSON: invalid literal; expected string literal"},
        Slip{"\"3k\"", "\"\xC3\xA4\xFF\"", ": line 1, column 57: not UTF-8"}));

TEST(WholeText, HasToBeThere) {
  EXPECT_EQ(faults_of(""), ": is empty");
  EXPECT_EQ(
      faults_of(" \n"),
      ": line 2, column 1: not JSON: unexpected end of input; expected '[', '{', or a literal");
  EXPECT_EQ(faults_of("[]"), ": is a list, must be an object");
  EXPECT_EQ(faults_of(std::string("{}\n\0[", 5)), ": line 2, column 1: not JSON: zero byte");
  EXPECT_EQ(faults_of("{\"kind\": \"gear"),
            ": line 1, column 15: not JSON: invalid string: missing closing quote");
}

TEST(WholeText, NamesAllFaultsAtOnce) {
  EXPECT_EQ(
      faults_of(R"({"kind": "gearbox_problem", "version": 1, "topology": "4k", "topologi": 1,
      "target_ratio": "x", "rotor_inner_diameter_mm": 1, "module_mm": [], "planet_count": 4,
      "min_teeth": {"sun": 40}, "constraints": "paper", "constraints": "paper"})"),
      "#/constraints: stands twice in its object; keep one\n"
      "#/module_mm: [] is empty, must hold at least 1 value\n"
      "#/rotor_inner_diameter_mm: 1 is outside [2, 10000] mm\n"
      "#/target_ratio: is a string, must be a number\n"
      "#/topologi: unknown key; did you mean \"topology\"?\n"
      "#/topology: \"4k\" is not one of \"3k\", \"planetary\", \"3k_b\", \"compound\", \"any\"\n"
      "#/min_carrier_clearance_rad: missing\n"
      "#/objective: missing, must be \"paper_cost\", \"mass\", \"hollow_shaft\", "
      "\"forward_efficiency\", \"backward_efficiency\" or \"reflected_inertia\"");
}

// Just inside and just outside the limit, and far beyond what a recursive reader survives.
TEST(WholeText, MayBeNestedSoDeep) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_EQ(faults_of(nested(kMaxDepth)), ": is a list, must be an object");
  EXPECT_EQ(faults_of(nested(kMaxDepth + 1)), ": is nested deeper than 256 levels");
  EXPECT_EQ(faults_of(nested(100000)), ": is nested deeper than 256 levels");
}

TEST(WholeText, StaysOnOneLinePerFault) {
  EXPECT_EQ(
      faults_of(with_slip({"20,", "20, \"q\\nq\": 1, \"load\": \"\\n\",", ""})),
      "#/load: is a string, must be an object\n#/q\\u000aq: unknown key; known are "
      "\"assumed\", \"constraints\", \"cutter\", \"face_width_mm\", \"friction_coefficient\", "
      "\"hollow_shaft_wall_mm\", \"kind\", \"load\", \"materials\", "
      "\"max_axial_length_mm\", \"max_backlash_rad_per_mm\", \"max_mass_kg\", "
      "\"max_reflected_inertia_kg_m2\", \"min_backward_efficiency\", "
      "\"min_carrier_clearance_rad\", \"min_contact_ratio\", \"min_forward_efficiency\", "
      "\"min_hollow_shaft_diameter_mm\", "
      "\"min_neighbour_clearance_mm\", \"min_teeth\", \"module_mm\", \"name\", "
      "\"objective\", \"planet_count\", \"ratio_tolerance\", \"ring_outer_diameter_mm\", "
      "\"ring_wall_mm\", \"rotor_inertia_kg_m2\", \"rotor_inner_diameter_mm\", "
      "\"sun_under_second_layer\", \"synthesis\", \"target_ratio\", \"topology\", "
      "\"version\"");
}

/// Keys that no document has, so many that not all their faults are listed.
std::string unknown_keys() {
  std::string keys;
  for (std::size_t i = 0; i < 2 * kMaxListedFaults; ++i)
    keys += "\"a" + std::to_string(i) + "\":1,";
  return keys;
}

// Nothing may hide behind other faults: what is of another kind, or version, is refused for that.
TEST(DocumentFaults, DoNotHideTheKind) {
  const auto of_kind = [](const std::string& kind, const std::string& version) {
    return faults_of("{" + unknown_keys() + "\"kind\":" + kind + ",\"version\":" + version + "}");
  };
  EXPECT_EQ(of_kind("\"actuator\"", "1"), "#/kind: \"actuator\" is not \"gearbox_problem\"");
  EXPECT_EQ(of_kind("\"gearbox_problem\"", "2"), "#/version: 2 is not 1");
  EXPECT_NE(of_kind("\"gearbox_problem\"", "1"), "");
}

TEST(DocumentFaults, AreListedWithAnEnd) {
  std::string keys;
  for (int i = 0; i < 5000; ++i) keys += "\"a\":1,";
  const std::string lines = faults_of("{" + keys + "\"a\":1}");
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 1000);
  EXPECT_TRUE(lines.ends_with(" faults more")) << lines.substr(lines.size() - 100);

  const std::string long_key(100000, 'k');
  EXPECT_LT(faults_of("{\"" + long_key + "\":1}").size(), 5000u * 20u);
}

TEST(WholeText, ListsNoMoreThanSoManyFaults) {
  json root = json::parse(with_slip({"20,", "20,", ""}));
  root["module_mm"] = json::array();
  root["assumed"] = json::array();
  for (std::size_t i = 0; i < 2 * kMaxListedFaults; ++i) root["assumed"].push_back(1);
  try {
    check_document(root, "gearbox_problem", "f", "");
    FAIL();
  } catch (const SpecError& error) {
    EXPECT_EQ(error.faults().size(), kMaxListedFaults);
    EXPECT_EQ(error.faults().back().message, "has more faults than are listed here");
  }
}

}  // namespace
}  // namespace torquewright::io
