// SPDX-License-Identifier: Apache-2.0
// The files as they were read beside each simulator's documentation: golden/, whose fields
// docs/simulator_formats.md lists with unit, source and the number worked out by hand. The texts
// must be the same, the numbers to rounding.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <regex>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/library.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "io/files/file_bytes.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kRounding = 1e-6;  // what the fit of unitree-xy leaves open

const std::regex kNumber(R"([-+]?\d+(\.\d+)?([eE][-+]?\d+)?)");

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  for (std::sregex_iterator match(text.begin(), text.end(), kNumber), end; match != end; ++match) {
    numbers.push_back(std::stod(match->str()));
  }
  return numbers;
}

std::string without_numbers(const std::string& text) {
  return std::regex_replace(text, kNumber, "#");
}

/// The class Region of exported modules of Python, its grid and what is said of it are no
/// simulator's: they are run, and held against clip.hpp (region_file_test.cpp).
std::string without_region(std::string text) {
  const std::size_t begin = text.find("\n# Over voltage and temperature: ");
  const std::size_t end = text.find("\nclip = REGION.clip\n");
  if (begin == std::string::npos || end == std::string::npos) return text;
  return text.erase(begin, end - begin);
}

std::filesystem::path golden_file(std::string_view format) {
  const auto folder =
      std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "tests/actuator/exporters/golden";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().stem() == format) return entry.path();
  }
  return {};
}

TEST(Golden, EveryFormatIsAsItWasReadBesideItsDocumentation) {
  const Example example(knee());
  for (const Exporter* exporter : exporter_library()) {
    SCOPED_TRACE(exporter->name);
    // No simulator's fields: they are run, and held against clip.hpp (region_file_test.cpp).
    if (exporter == &exporters::python || exporter == &exporters::c) continue;
    const std::filesystem::path file = golden_file(exporter->name);
    ASSERT_FALSE(file.empty());
    const std::string golden = io::read_file_bytes(file);
    const std::string text = without_region(
        simulator_file(example.subject(LawFit::kConservative), *exporter, {"origin"}).text);
    EXPECT_EQ(without_numbers(text), without_numbers(golden));
    const std::vector<double> numbers = numbers_in(text);
    const std::vector<double> expected = numbers_in(golden);
    ASSERT_EQ(numbers.size(), expected.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      EXPECT_NEAR(numbers[i], expected[i], kRounding * (1.0 + std::abs(expected[i])));
    }
  }
}

// Every format has its section.
TEST(Golden, EveryFormatsFieldsAreListed) {
  const std::string page = io::read_file_bytes(std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) /
                                               "docs/simulator_formats.md");
  for (const Exporter* exporter : exporter_library()) {
    EXPECT_NE(page.find("\n## `" + std::string(exporter->name) + "`"), std::string::npos)
        << exporter->name;
  }
}

}  // namespace
}  // namespace torquewright::actuator
