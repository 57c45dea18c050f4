// SPDX-License-Identifier: Apache-2.0
// loop_bench CLASS SEED FOLDER: a log of rigs under position loops, and the truth about it.
#include <charconv>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "tests/oracles/loop_bench/documents.hpp"

namespace {

std::optional<std::uint64_t> seed_in(std::string_view text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return seed;
}

}  // namespace

int main(int count, char** arguments) {
  namespace loop = torquewright::oracles::loop;
  const auto seed = count == 4 ? seed_in(arguments[2]) : std::nullopt;
  if (!seed) {
    std::fputs(
        "usage: loop_bench CLASS SEED FOLDER\nclasses: none, one, two, undecidable, outside\n",
        stderr);
    return 2;
  }
  try {
    loop::write_all(loop::made(arguments[1], *seed), arguments[3]);
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "loop_bench: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "loop_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
