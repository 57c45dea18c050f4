// SPDX-License-Identifier: Apache-2.0
// robot_bench CLASS SEED FOLDER [EFFECT]: a log of a robot that MuJoCo simulates, and the truth
// about it.
#include <charconv>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tests/oracles/robot_bench/documents.hpp"
#include "tests/oracles/robot_bench/robots.hpp"

namespace {

std::optional<std::uint64_t> seed_in(std::string_view text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return seed;
}

int run(const std::string& kind, std::string_view seed_text, const char* folder,
        const std::string& only) {
  using namespace torquewright::oracles::robot_bench;
  const auto seed = seed_in(seed_text);
  if (!seed) throw std::invalid_argument("SEED is a whole number, not negative");
  write_all(draw_situation(kind, *seed, data_folder(), only), *seed, folder);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count == 4 || count == 5)
      return run(arguments[1], arguments[2], arguments[3], count == 5 ? arguments[4] : "");
    std::fputs("usage: robot_bench CLASS SEED FOLDER [EFFECT]\n", stderr);
    return 2;
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "robot_bench: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "robot_bench: %s\n", error.what());
    return 1;
  }
}
