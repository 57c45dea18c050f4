// SPDX-License-Identifier: Apache-2.0
#include "src/options/noise_option.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "io/spec_error.hpp"

namespace torquewright::cli {
namespace {

constexpr double kGreatest = 1e9;  ///< So that squares and sums have an end.

}  // namespace

std::map<identification::Quantity, double> read_noise(const std::vector<std::string>& texts) {
  std::map<identification::Quantity, double> noise;
  for (const std::string& text : texts) {
    const auto refuse = [&](const std::string& why) {
      throw io::SpecError({{"command line", "--noise " + text, why}});
    };
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) refuse("QUANTITY=SIGMA is expected");
    const auto quantity = identification::find_quantity(text.substr(0, equals));
    if (!quantity) refuse("no such quantity; docs/logs.md lists them");
    const char* number = text.c_str() + equals + 1;
    char* end = nullptr;
    const double sigma = std::strtod(number, &end);
    if (end == number || *end != '\0' || !(sigma >= 0.0 && sigma <= kGreatest)) {
      refuse(fmt::format(
          "SIGMA is a standard deviation: a number from 0 to {:g}, in the quantity's unit",
          kGreatest));
    }
    noise[*quantity] = sigma;
  }
  return noise;
}

}  // namespace torquewright::cli
