// SPDX-License-Identifier: Apache-2.0
// The judge of outputs, judged by hand. Characters: RFC 3629, sections 3 and 4, and XML 1.0, 2.2.
#include "tests/cli/well_formed.hpp"

#include <gtest/gtest.h>

#include <string>

namespace torquewright::cli_test {
namespace {

TEST(FaultOfCharacters, IsNoneInTextOfAnyLanguage) {
  for (const std::string text :
       {"", "a\tb\r\n", "\xC2\x80", "k\xC3\xA9\xE2\x82\xAC", "\xED\x9F\xBF\xEE\x80\x80",
        "\xEF\xBF\xBD", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_EQ(fault_of_characters_in(text), "") << text;
  }
}

TEST(FaultOfCharacters, IsFoundWhereTheyAreIllegal) {
  for (const std::string& text :
       {std::string("\0", 1), std::string("\x01"), std::string("\x0B"), std::string("\x1B["),
        std::string("\xEF\xBF\xBE"), std::string("\xEF\xBF\xBF"), std::string("\xED\xA0\x80")}) {
    EXPECT_NE(fault_of_characters_in("a" + text).find("no text may hold"), std::string::npos);
  }
  for (const char* text : {"\xE9", "\xE9.", "\x80", "\xC0\x80", "\xE0\x80\x80", "\xE2\x82",
                           "\xF0\x80\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xC3("}) {
    EXPECT_NE(fault_of_characters_in(text).find("no UTF-8"), std::string::npos) << text;
  }
  EXPECT_EQ(fault_of_characters_in("a\nb\xE9"),
            "what is no UTF-8 begins with the byte 0xE9 in line 2");
}

TEST(FaultOfMarkup, IsFoundInCharactersToo) {
  EXPECT_EQ(fault_in("<a>k</a>"), "");
  EXPECT_EQ(fault_in("<a><script>if (1 <b && c> 2) d;</script></a>"), "");
  EXPECT_NE(fault_in("<a>k\xEF\xBF\xBE</a>"), "");
  EXPECT_NE(fault_in("<!-- \xE9 --><a></a>"), "");
}

}  // namespace
}  // namespace torquewright::cli_test
