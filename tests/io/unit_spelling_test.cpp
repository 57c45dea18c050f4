// SPDX-License-Identifier: Apache-2.0
// Units as sheets and loggers print them. Oracle: the units' own definitions (the pound is
// 0.45359237 kg, the inch 25.4 mm, standard gravity 9.80665 m/s^2).
#include "io/text/unit_spelling.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "io/text/units.hpp"

namespace torquewright::io {
namespace {

struct Printed {
  const char* printed;
  const char* here;
};

class UnitSpelling : public testing::TestWithParam<Printed> {};

TEST_P(UnitSpelling, IsTheTables) { EXPECT_EQ(unit_spelling(GetParam().printed), GetParam().here); }

INSTANTIATE_TEST_SUITE_P(
    Sheets, UnitSpelling,
    testing::Values(Printed{"m\u03a9", "mohm"}, Printed{"\u2126", "ohm"}, Printed{"mOhm", "mohm"},
                    Printed{"Ohms", "ohm"}, Printed{"MOhm", "MOhm"}, Printed{"RPM", "rpm"},
                    Printed{"min\u207b\u00b9", "rpm"}, Printed{"min-1", "rpm"},
                    Printed{"1/min", "rpm"}, Printed{"r/min/V", "rpm/V"},
                    Printed{"V/1000 rpm", "V/krpm"}, Printed{"N\u00b7m", "Nm"},
                    Printed{"N.m", "Nm"}, Printed{"N*mm", "mNm"}, Printed{"Nmm", "mNm"},
                    Printed{"N*m/A", "Nm/A"}, Printed{"Nm/Arms", "Nm/A_rms"},
                    Printed{"mNm/A", "mNm/A"}, Printed{"nm", "nm"}, Printed{"oz-in", "ozf_in"},
                    Printed{"oz\u00b7in/A", "ozf_in/A"}, Printed{"in-lb", "lbf_in"},
                    Printed{"ft-lb", "lbf_ft"}, Printed{"kg\u00b7cm", "kgf_cm"},
                    Printed{"g\u00b7cm\u00b2", "gcm2"}, Printed{"kg-m^2", "kgm2"},
                    Printed{"oz-in-s\u00b2", "ozf_in_s2"}, Printed{"\u00b0/s", "deg/s"},
                    Printed{"\u00b0C", "degC"}, Printed{"A (rms)", "A_rms"}, Printed{"Vdc", "V"},
                    Printed{"\u00b5s", "us"}));

TEST(UnitSpelling, LeadsToUnitsOfItsSize) {
  EXPECT_DOUBLE_EQ(find_unit("oz-in")->in_SI, 0.45359237 / 16.0 * 9.80665 * 0.0254);
  EXPECT_DOUBLE_EQ(find_unit("kg\u00b7cm")->in_SI, 9.80665 * 0.01);
  EXPECT_DOUBLE_EQ(find_unit("1/min")->in_SI, std::numbers::pi / 30.0);
  EXPECT_FALSE(find_unit("MV").has_value());
}

}  // namespace
}  // namespace torquewright::io
