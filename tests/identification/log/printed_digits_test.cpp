// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/printed_digits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "tests/identification/log/written_log.hpp"

namespace torquewright::identification {
namespace {

double last_digit(std::initializer_list<std::string_view> cells) {
  PrintedDigits digits;
  for (const std::string_view cell : cells) digits.add(cell);
  return digits.last_digit();
}

// Oracle: by hand.
TEST(PrintedDigits, AreDecimalsWhereTheseAreTheSame) {
  EXPECT_DOUBLE_EQ(last_digit({"0.001", "123.456", "-0.020"}), 1e-3);
  EXPECT_DOUBLE_EQ(last_digit({"0.001", "0", "12.5", "-11.987"}), 1e-3);
  EXPECT_DOUBLE_EQ(last_digit({"17", "-3", "0"}), 1.0);
  EXPECT_EQ(last_digit({}), 0.0);
}

TEST(PrintedDigits, AreSignificantOnesWhereThoseAreTheSame) {
  // Of four digits each: 1e-3, 1e-5, 1e2.
  EXPECT_DOUBLE_EQ(last_digit({"1.234", "0.01234", "-5.678e+05"}),
                   std::sqrt((1e-6 + 1e-10 + 1e4) / 3.0));
  EXPECT_DOUBLE_EQ(last_digit({"1.234E-5", "4.4e-5"}), 1e-8);
}

// One cell in a hundred may be a fault of the sensor; two are not isolated any more.
TEST(PrintedDigits, AreNotThoseOfOneFaultyCell) {
  PrintedDigits digits;
  for (int i = 0; i < 198; ++i) digits.add("1.234");
  digits.add("1e200");
  EXPECT_DOUBLE_EQ(digits.last_digit(), 1e-3);
  for (int i = 0; i < 2; ++i) digits.add("1234e3");
  EXPECT_DOUBLE_EQ(digits.last_digit(), std::sqrt((198 * 1e-6 + 3 * 1e6) / 201.0));
}

TEST(ReadLog, KnowsTheLastDigitOfEveryChannel) {
  nlohmann::json rig = test::rig_json({{"t", "time_s"}, {"q", "output_position_rad"}});
  rig["columns"]["q"] = {{"quantity", "output_position_rad"}, {"scale", -0.5}};
  rig["columns"]["V"] = "bus_voltage_V";
  const auto read = test::read({{"m.csv", "t,q,V\n0,0.10,48\n1,0.25,47\n2,0.30,48\n"}}, rig);
  ASSERT_EQ(read.refusal, "");
  ASSERT_EQ(read.log.printed.size(), 1u);
  const auto step = [&](Quantity quantity) {
    return read.log.printed[0][static_cast<std::size_t>(quantity)];
  };
  EXPECT_DOUBLE_EQ(step(Quantity::kOutputPosition), 0.005);
  EXPECT_DOUBLE_EQ(step(Quantity::kBusVoltage), 1.0);
  EXPECT_EQ(step(Quantity::kMotorCurrent), 0.0);
}

}  // namespace
}  // namespace torquewright::identification
