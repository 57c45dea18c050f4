// SPDX-License-Identifier: Apache-2.0
#include "gearbox/verification/input_check_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "gearbox/synthesis_defaults_spec.hpp"
#include "gearbox/verification/difference_json.hpp"
#include "io/documents/document.hpp"
#include "io/files/file_bytes.hpp"
#include "io/files/sha256.hpp"

namespace torquewright::gearbox {
namespace {

using Json = nlohmann::json;

bool is_sha256(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// The file is the one that was read, byte for byte; so what it says is compared by value.
void check_file(const Json& problem, const std::string& file, const std::string& sha256,
                proof::Faults& faults) {
  try {
    if (io::sha256(io::read_file_bytes(file)) != sha256) {
      faults.add("/inputs/0/sha256",
                 fmt::format("is not that of {}: the file has changed since, or the result is not "
                             "of this file",
                             file));
      return;
    }
    const io::Document document = read_problem_document(file);
    if (const auto difference = first_difference(problem, document.root, "/problem")) {
      faults.add(difference->pointer, fmt::format("{} as in {}", difference->sentence, file));
    }
  } catch (const io::SpecError& error) {
    faults.add("/inputs/0/path", fmt::format("leads to no problem: {}", error.what()));
  }
}

}  // namespace

InputCheck check_input(const Json& result, const Json& problem, proof::Faults& faults) {
  const Json& inputs = result["inputs"];
  if (inputs.size() != 1) {
    faults.add("/inputs", "is no list of one file, the problem's");
    return {};
  }
  const std::string file = inputs[0]["path"];
  const std::string sha256 = inputs[0]["sha256"];
  if (!is_sha256(sha256)) {
    faults.add("/inputs/0/sha256", "is no SHA-256 in 64 hexadecimal digits");
    return {};
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    return {false,
            fmt::format("{} is not here: this is about the problem as the result gives it", file)};
  }
  const std::size_t before = faults.count();
  check_file(problem, file, sha256, faults);
  if (faults.count() != before) return {};
  return {true, fmt::format("{} is the file that was read, by its SHA-256, and holds this problem",
                            file)};
}

}  // namespace torquewright::gearbox
