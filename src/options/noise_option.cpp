// SPDX-License-Identifier: Apache-2.0
#include "src/options/noise_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "io/faults/spec_error.hpp"
#include "io/files/given_once.hpp"

namespace torquewright::cli {
namespace {

constexpr double kGreatest = 1e9;  ///< So that squares and sums have an end.

}  // namespace

std::map<identification::Quantity, double> read_noise(const std::vector<std::string>& texts,
                                                      const identification::Rig& rig) {
  io::require_each_once("--noise", texts);
  std::map<identification::Quantity, double> noise;
  for (const std::string& text : texts) {
    const auto refuse = [&](const std::string& why) {
      throw io::SpecError({{"command line", "--noise " + text, why}});
    };
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) refuse("QUANTITY=SIGMA is expected");
    const auto quantity = identification::find_quantity(text.substr(0, equals));
    if (!quantity) refuse("no such quantity; docs/logs.md lists them");
    const bool is_measured =
        std::any_of(rig.columns.begin(), rig.columns.end(),
                    [&](const auto& use) { return use.quantity == *quantity; });
    if (!is_measured) {
      refuse(fmt::format("the rig {} has no column of {}; noise is added to what it names",
                         rig.file, identification::name_of(*quantity)));
    }
    const char* number = text.c_str() + equals + 1;
    char* end = nullptr;
    const double sigma = std::strtod(number, &end);
    const bool is_decimal = text.find_first_of("xX", equals) == std::string::npos;
    if (end == number || !is_decimal || *end != '\0' || !(sigma >= 0.0 && sigma <= kGreatest)) {
      refuse(fmt::format(
          "SIGMA is a standard deviation: a number from 0 to {:g}, in the quantity's unit",
          kGreatest));
    }
    noise[*quantity] = sigma;
  }
  return noise;
}

}  // namespace torquewright::cli
