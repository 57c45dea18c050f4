// SPDX-License-Identifier: Apache-2.0
// Numbers that say their unit. Oracle: the units' definitions, worked out by hand.
#include "io/documents/stated_units.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "io/documents/schema.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;

struct Taken {
  json document;
  std::vector<Fault> faults;
};

Taken taken(json document) {
  Taken result{std::move(document), {}};
  take_stated_units(result.document, schema_of("actuator"), "a.json", result.faults);
  return result;
}

json motor_with(const char* key, const json& value) { return {{"motor", {{key, value}}}}; }

TEST(StatedUnits, BecomeThoseOfTheirKeys) {
  const auto of = [](const char* key, double value, const char* unit) {
    const Taken read = taken(motor_with(key, {{"value", value}, {"unit", unit}}));
    EXPECT_TRUE(read.faults.empty()) << key;
    return read.document["motor"][key];
  };
  EXPECT_EQ(of("resistance_ohm", 93, "mohm"), json(0.093));
  EXPECT_EQ(of("inductance_d_H", 57, "uH"), json(5.7e-5));
  EXPECT_EQ(of("rotor_inertia_kg_m2", 600, "g cm^2"), json(6e-5));
  EXPECT_EQ(of("rotor_inertia_kg_m2", 600, "gcm2"), json(6e-5));
  EXPECT_EQ(of("torque_constant_Nm_A", 95, "mNm/A"), json(0.095));
  EXPECT_EQ(of("demagnetisation_current_A", 40, "A_rms"),
            (json{{"value", 40.0}, {"ampere", "rms"}}));
  // 25 degC are 298.15 K, which this key takes as a number alone.
  EXPECT_EQ(of("winding_temperature_K", 25, "degC"), json(298.15));
}

// The sheet's 95 rpm are rounded to half a turn; 9.94837... rad/s would claim more.
TEST(StatedUnits, KeepWhatTheSheetsDigitsSay) {
  const Taken read =
      taken({{"datasheet", {{"no_load_speed_rad_s", {{"value", 95}, {"unit", "rpm"}}}}}});
  const json& speed = read.document["datasheet"]["no_load_speed_rad_s"];
  EXPECT_NEAR(speed["value"].get<double>(), 95.0 * std::numbers::pi / 30.0, 1e-13);
  EXPECT_NEAR(speed["tolerance"].get<double>(), 0.5 / 95.0, 1e-15);
}

TEST(StatedUnits, KeepWhatElseIsSaid) {
  const Taken read = taken(motor_with(
      "resistance_ohm", {{"value", 93}, {"unit", "mohm"}, {"tolerance", 0.1}, {"also", {95, 97}}}));
  EXPECT_EQ(read.document["motor"]["resistance_ohm"],
            (json{{"value", 0.093}, {"tolerance", 0.1}, {"also", {0.095, 0.097}}}));
}

TEST(StatedUnits, OfAnotherKindAreFaults) {
  for (const char* unit : {"kohms", "V", "", "A_rms"}) {
    const Taken read = taken(motor_with("resistance_ohm", {{"value", 93}, {"unit", unit}}));
    ASSERT_EQ(read.faults.size(), 1u) << unit;
    EXPECT_EQ(read.faults[0].path, "/motor/resistance_ohm/unit");
    EXPECT_EQ(read.faults[0].message,
              "\"" + std::string(unit) + "\" is not one of ohm, mohm, the units of this key");
  }
}

// A supply's current is no phase's: amperes of a phase are neither taken nor offered.
TEST(StatedUnits, OfAPhaseAreNotOfferedForASupply) {
  const json document = {{"drive", {{"supply_current_A", {{"value", 10}, {"unit", "A_rms"}}}}}};
  const Taken read = taken(document);
  ASSERT_EQ(read.faults.size(), 1u);
  EXPECT_EQ(read.faults[0].message, "\"A_rms\" is not one of A, mA, the units of this key");
}

}  // namespace
}  // namespace torquewright::io
