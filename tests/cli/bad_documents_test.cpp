// SPDX-License-Identifier: Apache-2.0
// Documents that are wrong: exit 2, one line per fault on stderr, nothing on stdout, no file
// touched.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

/// The D151's knee with one place changed, and what is said of it.
struct BadPlace {
  std::string from, to;
  std::vector<std::string> faults;  ///< The lines, each without "knee.json" in front.
};

void PrintTo(const BadPlace& place, std::ostream* stream) { *stream << place.to; }

const std::vector<BadPlace> kBadPlaces = {
    {"\"kind\": \"gearbox_problem\"",
     "\"kind\": \"gearbox\"",
     {"#/kind: \"gearbox\" is not \"gearbox_problem\""}},
    {"\"version\": 1", "\"version\": 2", {"#/version: 2 is not 1"}},
    {"\"kind\": \"gearbox_problem\",", "", {"#/kind: missing, must be \"gearbox_problem\""}},
    {"\"modul",
     "\"modl",
     {"#/modle_mm: unknown key; did you mean \"module_mm\"?", "#/module_mm: missing"}},
    {"\"target_ratio\": 20",
     "\"target_ratio\": \"20\"",
     {"#/target_ratio: is a string, must be a number"}},
    {"\"module_mm\": 0.6",
     "\"module_mm\": \"0.6\"",
     {"#/module_mm: is a string, must be a number or a list of numbers"}},
    {"\"planet_count\": 4",
     "\"planet_count\": 4.5",
     {"#/planet_count: 4.5 is not whole, must be a whole number"}},
    // Metres for millimetres.
    {"79.4", "0.0794", {"#/rotor_inner_diameter_mm: 0.0794 is outside [2, 10000] mm"}},
    {"\"module_mm\": 0.6", "\"module_mm\": 0", {"#/module_mm: 0 is outside [0.05, 25] mm"}},
    {"\"module_mm\": 0.6", "\"module_mm\": -0.6", {"#/module_mm: -0.6 is outside [0.05, 25] mm"}},
    {"\"target_ratio\": 20",
     "\"target_ratio\": 0.5",
     {"#/target_ratio: 0.5 is outside [1, 10000]"}},
    {"\"module_mm\": 0.6",
     "\"module_mm\": []",
     {"#/module_mm: [] is empty, must hold at least 1 value"}},
    {"\"planet_count\": 4",
     "\"planet_count\": []",
     {"#/planet_count: [] is empty, must hold at least 1 value"}},
    {"\"target_ratio\": 20",
     "\"target_ratio\": NaN",
     {"#/target_ratio: NaN is not a JSON number, must be finite (line 6, column 19)"}},
    {"\"target_ratio\": 20",
     "\"target_ratio\": 1e400",
     {"#/target_ratio: 1e400 is too large for a number (line 6, column 23)"}},
    {"\"target_ratio\": 20",
     "\"target_ratio\": 20, \"target_ratio\": 21",
     {"#/target_ratio: stands twice in its object; keep one"}},
    {"\"sun\": 40",
     "\"sun\": 40, \"sun\": 40",
     {"#/min_teeth/sun: stands twice in its object; keep one"}},
    {"D151", "D151\xff", {": line 4, column 16: not UTF-8"}},
    {"\"planet_count\": 4",
     "\"planet_count\": 4 4",
     {": line 10, column 21: not JSON: unexpected number literal; expected '}'"}},
    {"]\n}", "]\n", {": line 18, column 1: not JSON: unexpected end of input; expected '}'"}},
    {"\"3k\"",
     "\"4K\"",
     {"#/topology: \"4K\" is not one of \"3k\", \"planetary\", \"3k_b\", \"compound\", \"any\""}},
    // Several at once.
    {"\"target_ratio\": 20,\n  \"ratio_tolerance\": 0",
     "\"target_ratio\": 0,\n  \"ratio_tolerence\": 0",
     {"#/ratio_tolerence: unknown key; did you mean \"ratio_tolerance\"?",
      "#/target_ratio: 0 is outside [1, 10000]"}},
};

/// Runs every command that reads such a document, and asks for all outputs there are.
void expect_bad_document(const Workplace& place, const std::string& document,
                         const std::string& refusal) {
  place.write("result.json", "old");
  const auto before = place.files();
  const std::vector<std::vector<std::string>> commands = {
      {"gearbox", "optimize", document}, {"gearbox", "evaluate", document, "--teeth", "44,44,32"}};
  for (std::vector<std::string> command : commands) {
    command.insert(command.end(), {"-o", "result.json", "--draw", "drawing.svg", "--json"});
    const Outcome outcome = place.run(command);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, refusal);
    EXPECT_EQ(place.files(), before);
  }
}

class BadDocument : public testing::TestWithParam<BadPlace> {};

TEST_P(BadDocument, IsRefusedWithALinePerFault) {
  const Workplace place;
  place.write("knee.json", knee_with(GetParam().from, GetParam().to));
  std::string lines;
  for (const std::string& fault : GetParam().faults) lines += "knee.json" + fault + "\n";
  expect_bad_document(place, "knee.json", lines);
}

INSTANTIATE_TEST_SUITE_P(Each, BadDocument, testing::ValuesIn(kBadPlaces));

TEST(BadDocument, NamesAllKnownKeysWhereNoneIsNear) {
  const Workplace place;
  place.write("knee.json", knee_with("\"name\"", "\"colour\""));
  const Outcome outcome = place.run({"gearbox", "optimize", "knee.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(outcome.err.starts_with("knee.json#/colour: unknown key; known are \"assumed\", "))
      << outcome.err;
}

TEST(BadDocument, IsMissing) {
  expect_bad_document(Workplace(), "a.json", "a.json: no such file\n");
}

TEST(BadDocument, IsEmpty) {
  const Workplace place;
  place.write("a.json", "");
  expect_bad_document(place, "a.json", "a.json: is empty\n");
}

TEST(BadDocument, IsAFolder) {
  const Workplace place;
  fs::create_directory(place.path("a.json"));
  expect_bad_document(place, "a.json", "a.json: is a folder, must be a file\n");
}

TEST(BadDocument, IsBelowAFile) {
  const Workplace place;
  place.write("a", "");
  expect_bad_document(place, "a/a.json", "a/a.json: cannot be read: Not a directory\n");
}

TEST(BadDocument, IsAHundredThousandListsDeep) {
  const Workplace place;
  place.write("a.json", std::string(100000, '['));
  expect_bad_document(place, "a.json", "a.json: is nested deeper than 256 levels\n");
}

TEST(BadDocument, IsOfAnotherEncoding) {
  const Workplace place;
  std::string wide = "\xFF\xFE";
  for (const char letter : knee()) (wide += letter) += '\0';
  place.write("a.json", wide);
  expect_bad_document(place, "a.json", "a.json: line 1, column 4: not JSON: zero byte\n");
}

// A hundred megabytes, of which no disk has to hold any. The program has 64 MB (the sanitizers
// reserve far more than that: there the refusal alone has to do).
TEST(BadDocument, IsTooLargeToBeOne) {
  Workplace place;
  place.write("a.json", "");
  fs::resize_file(place.path("a.json"), 100'000'000);
#if !defined(__SANITIZE_ADDRESS__)
  place.here.memory_limit = 64 << 20;
#endif
  const Outcome outcome = place.run({"gearbox", "optimize", "a.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "a.json: holds 100000000 bytes, more than the allowed 64 MiB\n");
}

// What other systems' editors add is no mistake.
TEST(GoodDocument, MayHaveAByteOrderMarkAndForeignLineEnds) {
  const Workplace place;
  place.write("plain.json", knee());
  place.write("marked.json", "\xEF\xBB\xBF" + knee());
  place.write("foreign.json", std::regex_replace(knee(), std::regex("\n"), "\r\n"));
  const std::string plain = place.run({"gearbox", "optimize", "plain.json", "--all"}).out;
  EXPECT_EQ(place.run({"gearbox", "optimize", "marked.json", "--all"}).out, plain);
  EXPECT_EQ(place.run({"gearbox", "optimize", "foreign.json", "--all"}).out, plain);
}

// Linux allows any bytes in a name; the result has to be a document all the same.
TEST(GoodDocument, MayHaveANameThatIsNoText) {
  const Workplace place;
  place.write("knee\xff.json", knee());
  const Outcome outcome = place.run({"gearbox", "optimize", "knee\xff.json", "-o", "result.json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(place.run({"gearbox", "verify", "result.json"}).exit_code, 0);
}

}  // namespace
}  // namespace torquewright::cli_test
