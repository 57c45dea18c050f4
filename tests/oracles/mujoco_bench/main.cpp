// SPDX-License-Identifier: Apache-2.0
// mujoco_bench CLASS SEED FOLDER: a log of a bench that MuJoCo simulates, and the truth about it.
#include <charconv>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tests/oracles/mujoco_bench/documents.hpp"

namespace {

std::optional<std::uint64_t> seed_in(std::string_view text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return seed;
}

int run(const std::string& kind, std::string_view seed_text, const char* folder) {
  using namespace torquewright::oracles::mujoco_bench;
  const auto seed = seed_in(seed_text);
  if (!seed) throw std::invalid_argument("SEED is a whole number, not negative");
  write_all(make_log(kind, *seed), *seed, folder);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count == 4) return run(arguments[1], arguments[2], arguments[3]);
    std::fputs("usage: mujoco_bench CLASS SEED FOLDER\n", stderr);
    return 2;
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "mujoco_bench: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mujoco_bench: %s\n", error.what());
    return 1;
  }
}
