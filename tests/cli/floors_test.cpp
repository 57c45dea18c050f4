// SPDX-License-Identifier: Apache-2.0
// Floors and ceilings of a problem without synthesis, as a user meets them. Oracle: the published
// knee, whose efficiencies are 0.9568 and 0.9552 with a hollow shaft of 22.2 mm (docs/gearbox.md).
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

json knee() { return json::parse(text_of(in_specs("gearbox/d151_knee.json"))); }

// The only design that the paper's minima leave is the knee itself.
TEST(Floors, AreNamedProvedAndLoosened) {
  const Workplace place;
  json asked = knee();
  asked["min_backward_efficiency"] = 0.96;
  asked["min_hollow_shaft_diameter_mm"] = 22.2;
  place.write("knee.json", asked.dump());
  const Outcome found =
      place.run({"gearbox", "optimize", "knee.json", "--verify", "-o", "result.json"});
  EXPECT_EQ(found.exit_code, 1) << found.err;
  EXPECT_NE(found.out.find("\n  backward_efficiency: Without backward_efficiency there is "),
            std::string::npos)
      << found.out;
  EXPECT_NE(found.out.find("\n  min_backward_efficiency = 0.96 is too much: 0.9552 would do "
                           "(44/44/32/132/120 with 4 planets, module 0.6 mm).\n"),
            std::string::npos)
      << found.out;
  EXPECT_NE(found.out.find("\naccepted: "), std::string::npos) << found.out;
  const json result = json::parse(place.text("result.json"));
  for (const json& remedy : result["would_be_feasible_with"]) {
    if (remedy["key"] == "/min_backward_efficiency") {
      asked["min_backward_efficiency"] = remedy["needed"];
    }
  }
  place.write("knee.json", asked.dump());
  const Outcome loosened = place.run({"gearbox", "optimize", "knee.json", "--verify"});
  EXPECT_EQ(loosened.exit_code, 0) << loosened.out << loosened.err;
  EXPECT_NE(loosened.out.find("\n1. sun 44, planet_1 44, planet_2 32"), std::string::npos);
}

TEST(Floors, AreConstraintsOfADesign) {
  const Workplace place;
  json asked = knee();
  asked["min_backward_efficiency"] = 0.96;
  asked["min_hollow_shaft_diameter_mm"] = 22.2;
  place.write("knee.json", asked.dump());
  const Outcome judged = place.run({"gearbox", "evaluate", "knee.json", "--teeth", "44,44,32"});
  EXPECT_EQ(judged.exit_code, 1);
  EXPECT_NE(judged.out.find("backward_efficiency: 0.9552 of the power put in comes out with the "
                            "output driving; at least 0.96 is asked for: "),
            std::string::npos)
      << judged.out;
  EXPECT_NE(judged.out.find("hollow_shaft: 22.2 mm left for a hollow shaft; at least 22.2 mm are "
                            "asked for: met exactly."),
            std::string::npos)
      << judged.out;
}

TEST(Floors, SayWhatTheyNeed) {
  const Workplace place;
  json asked = knee();
  asked.erase("friction_coefficient");
  asked["assumed"] = json::array();
  asked["min_forward_efficiency"] = 0.9;
  asked["max_mass_kg"] = 0.2;
  place.write("knee.json", asked.dump());
  EXPECT_EQ(place.run({"gearbox", "optimize", "knee.json"}).err,
            "knee.json#/friction_coefficient: missing; min_forward_efficiency needs it\n"
            "knee.json#/face_width_mm: missing; max_mass_kg needs it\n"
            "knee.json#/materials/density_kg_m3: missing; max_mass_kg needs it\n");
  asked = knee();
  asked["max_mass"] = 0.2;
  place.write("knee.json", asked.dump());
  EXPECT_NE(place.run({"gearbox", "optimize", "knee.json"}).err.find("\"max_mass_kg\""),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::cli_test
