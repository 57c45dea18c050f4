// SPDX-License-Identifier: Apache-2.0
// sampled_bench CLASS SEED FOLDER: writes a measured log with a known truth. Exit code 2:
// arguments.
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>

#include "tests/oracles/sampled_bench/classes.hpp"
#include "tests/oracles/sampled_bench/documents.hpp"

namespace sampled = torquewright::oracles::sampled;

namespace {

std::optional<std::uint64_t> seed_of(std::string_view text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, seed);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return seed;
}

int usage() {
  std::cerr << "usage: sampled_bench CLASS SEED FOLDER\nclasses:";
  for (const std::string& name : sampled::class_names()) std::cerr << ' ' << name;
  std::cerr << '\n';
  return 2;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return usage();
  const std::string kind = arguments[1];
  const std::optional<std::uint64_t> seed = seed_of(arguments[2]);
  const auto& names = sampled::class_names();
  if (!seed || std::find(names.begin(), names.end(), kind) == names.end()) return usage();
  try {
    sampled::write_bench(sampled::draw_bench(kind, *seed), arguments[3]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
