// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/document_mutation.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/fuzz/program/chance.hpp"

namespace torquewright::fuzz {
namespace {

using nlohmann::json;

const std::vector<double> kOtherNumbers{0.0,  1.0,   -1.0,   1e-12,  1e12,  1e-6,
                                        1e6,  1e-15, 1e100,  1e-300, 1e300, 5e-324,
                                        1e-3, 1e3,   0.9999, 1.0001, 360.0, 1.7976931348623157e308};

json other_number(const json& number, Random& random) {
  if (number.is_number_integer() && !once_in(4, random)) {
    const std::vector<std::int64_t> counts{0, 1, 2, 3, 5, 17, 100, 1000, 100000, 2147483648, -1};
    return one_of(counts, random);
  }
  if (once_in(3, random)) return one_of(kOtherNumbers, random);
  // Over 24 orders of magnitude, smaller steps more often.
  const auto step = static_cast<double>(one_below(2401, random)) / 100.0 - 12.0;
  return number.get<double>() * std::pow(10.0, once_in(2, random) ? step : step / 6.0);
}

}  // namespace

std::string with_other_numbers(const std::string& text, Random& random) {
  json document = json::parse(text, nullptr, false);
  std::vector<json::json_pointer> places;
  if (!document.is_discarded() && document.is_structured()) {
    const json flat = document.flatten();
    for (const auto& [pointer, value] : flat.items()) {
      if (value.is_number() && pointer != "/version") places.emplace_back(pointer);
    }
  }
  if (places.empty()) return mutated({text}, random);
  for (std::size_t count = 1 + one_below(3, random); count > 0; --count) {
    json& place = document[one_of(places, random)];
    place = other_number(place, random);
  }
  return document.dump();
}

}  // namespace torquewright::fuzz
