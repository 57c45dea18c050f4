// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/readers.hpp"

#include "gearbox/problem_spec.hpp"
#include "io/document.hpp"
#include "io/schema.hpp"
#include "tests/fuzz/result_reader.hpp"

namespace torquewright::fuzz {
namespace {

namespace fs = std::filesystem;

void read_problem(const fs::path& file) {
  (void)gearbox::read_problem(io::read_document(file, "gearbox_problem"));
}

}  // namespace

std::vector<Reader> readers() {
  std::vector<Reader> readers = {
      {"gearbox_problem, read", ".json", read_problem},
      {"gearbox_result, verified", ".json", verify_result},
  };
  for (const std::string& kind : io::document_kinds()) {
    readers.push_back(
        {kind, ".json", [kind](const fs::path& file) { (void)io::read_document(file, kind); }});
  }
  return readers;
}

}  // namespace torquewright::fuzz
