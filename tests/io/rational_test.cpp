// SPDX-License-Identifier: Apache-2.0
#include "io/text/rational.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

namespace torquewright::io {
namespace {

// Oracle: the definition of a decimal fraction, by hand.
TEST(Exact, IsTheDecimalThatWasWritten) {
  EXPECT_EQ(exact(0.1), Rational(1, 10));
  EXPECT_EQ(exact(79.4) / exact(0.6), Rational(397, 3));
  EXPECT_EQ(exact(-12.5), Rational(-25, 2));
  EXPECT_EQ(exact(0.0), 0);
  EXPECT_EQ(exact(-0.0), 0);
  EXPECT_EQ(exact(1e22), Rational("10000000000000000000000"));
  EXPECT_EQ(exact(2.5e-7), Rational(1, 4000000));
}

TEST(Exact, RefusesWhatIsNotFinite) {
  EXPECT_THROW(exact(std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_THROW(exact(-std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_THROW(exact(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

// Oracle: the numeral as an exact fraction. Up to 15 significant digits survive a double.
TEST(Exact, KeepsFifteenDigits) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::int64_t> digits(100000000000000, 999999999999999);
  std::uniform_int_distribution<int> exponent(-30, 30);
  for (int i = 0; i < 2000; ++i) {
    const std::string numeral =
        std::to_string(digits(random)) + "e" + std::to_string(exponent(random));
    const double value = std::strtod(numeral.c_str(), nullptr);
    EXPECT_EQ(exact(value), rational_from_numeral(numeral)) << numeral;
  }
}

// Oracle: the C library's reading of the same numeral, correctly rounded.
TEST(NearestDouble, IsTheDoubleThatTheNumeralStandsFor) {
  for (const char* numeral : {"0.1", "0.2", "0.3", "0.4", "0.6", "0.7", "0.8", "-0.2", "79.4", "0",
                              "5e-324", "1.7976931348623157e308"}) {
    EXPECT_EQ(nearest(rational_from_numeral(numeral)), std::strtod(numeral, nullptr)) << numeral;
  }
  std::mt19937_64 random(2);
  std::uniform_int_distribution<std::int64_t> digits(-999999999999999999, 999999999999999999);
  std::uniform_int_distribution<int> exponent(-200, 200);
  for (int i = 0; i < 5000; ++i) {
    const std::string numeral =
        std::to_string(digits(random)) + "e" + std::to_string(exponent(random));
    EXPECT_EQ(nearest(rational_from_numeral(numeral)), std::strtod(numeral.c_str(), nullptr))
        << numeral;
  }
}

TEST(RationalFromNumeral, ReadsTheGrammarOfJson) {
  EXPECT_EQ(rational_from_numeral("-12.5e-3"), Rational(-1, 80));
  EXPECT_EQ(rational_from_numeral("0"), 0);
  EXPECT_EQ(rational_from_numeral("-0.0"), 0);
  EXPECT_EQ(rational_from_numeral("10.50E+2"), 1050);
  EXPECT_EQ(rational_from_numeral("0.333"), Rational(333, 1000));
  EXPECT_EQ(rational_from_numeral("1e1000").get_num().get_str().size(), 1001u);
}

TEST(RationalFromNumeral, RefusesEverythingElse) {
  for (const char* text : {"", "-", "+1", "01", ".5", "5.", "1e", "1e+", "1 ", " 1", "0x10", "nan",
                           "inf", "1,5", "--1", "1e1001", "1e-1001", "1e99999999999999999999"}) {
    EXPECT_THROW(rational_from_numeral(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace torquewright::io
