// SPDX-License-Identifier: Apache-2.0
#include "io/text/one_line.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "io/faults/spec_error.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;

// Oracle: nlohmann's serializer, which puts U+FFFD where a text is no UTF-8. Every pair and triple
// of bytes at which its automaton decides, before and behind a letter.
TEST(OneLine, ReplacesWhatIsNoUtf8AsJsonDoes) {
  const std::string bytes =
      "a\x7E\x80\x8F\x90\x9F\xA0\xBF\xC1\xC2\xDF\xE0\xE1\xED\xEF\xF0\xF1\xF4\xF5\xFF";
  for (const char first : bytes) {
    for (const char second : bytes) {
      for (const char third : bytes) {
        for (const char fourth : {'a', '\x80', '\xBF'}) {
          const std::string text{'k', first, second, third, fourth, 'e'};
          const std::string dumped =
              json(text).dump(-1, ' ', false, json::error_handler_t::replace);
          std::string expected = json::parse(dumped);
          for (const char* missing : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
            const std::size_t at = expected.find(missing);
            if (at != std::string::npos) expected.replace(at, 3, "\xEF\xBF\xBD");
          }
          // The controls of C1, of two bytes each.
          for (std::size_t at = 0; (at = expected.find('\xC2', at)) != std::string::npos; ++at) {
            if (static_cast<unsigned char>(expected[at + 1]) <= 0x9F) {
              expected.replace(at, 2, "\xEF\xBF\xBD");
            }
          }
          EXPECT_EQ(one_line(text), expected);
          EXPECT_EQ(unprintable_in(text).has_value(), one_line(text) != text);
        }
      }
    }
  }
}

TEST(OneLine, ReplacesWhatNoLineHolds) {
  EXPECT_EQ(one_line("a\nb\tc\x1B\x7F"
                     "d"),
            "a\xEF\xBF\xBD"
            "b\xEF\xBF\xBD"
            "c\xEF\xBF\xBD\xEF\xBF\xBD"
            "d");
  EXPECT_EQ(unprintable_in("k\n"), "the character U+000A");
  EXPECT_EQ(unprintable_in("\xEF\xBF\xBE"), "the character U+FFFE");
  EXPECT_EQ(unprintable_in("k\xE9"), "the byte 0xE9, which is not UTF-8");
  EXPECT_EQ(unprintable_in("kn\xC3\xA9"), std::nullopt);
  EXPECT_EQ(one_line(""), "");
}

// Oracle: Unicode 15, the category Cc (C0, DEL, C1), its separators of lines and paragraphs, and
// the embeddings, overrides and isolates of its annex 9; characters beside each range are none.
TEST(OneLine, HoldsNoControlsOfTerminalsAndOfDirection) {
  for (const std::string text :
       {"\xC2\x80", "\xC2\x85", "\xC2\x9B", "\xC2\x9F", "\xE2\x80\xA8", "\xE2\x80\xA9",
        "\xE2\x80\xAA", "\xE2\x80\xAE", "\xE2\x81\xA6", "\xE2\x81\xA9"}) {
    EXPECT_NE(unprintable_in("k" + text), std::nullopt) << text;
    EXPECT_EQ(one_line(text + "k"), "\xEF\xBF\xBDk") << text;
  }
  for (const std::string text :
       {"~", "\xC2\xA0", "\xE2\x80\xA7", "\xE2\x80\xAF", "\xE2\x81\xA5", "\xE2\x81\xAA"}) {
    EXPECT_EQ(unprintable_in(text), std::nullopt) << text;
    EXPECT_EQ(one_line(text), text);
  }
  EXPECT_EQ(unprintable_in("\xC2\x9B"), "the character U+009B");
}

TEST(OneLine, NamesAFileAndItsStem) {
  EXPECT_EQ(name_in_text("a/k\xE9.json"), "a/k\xEF\xBF\xBD.json");
  EXPECT_EQ(stem_in_text("a\n/k\xE9.json"), "k\xEF\xBF\xBD");
}

TEST(SpecError, IsUtf8WhateverAFileIsCalled) {
  EXPECT_STREQ(SpecError({{"k\xE9.json", "", "no such file"}}).what(),
               "k\xEF\xBF\xBD.json: no such file");
}

}  // namespace
}  // namespace torquewright::io
