// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/workplace.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace torquewright::cli_test {

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

fs::path in_repository(std::string_view file) { return fs::path(TORQUEWRIGHT_SOURCE_DIR) / file; }

std::string in_specs(std::string_view file) {
  return in_repository("specs").string() + "/" + std::string(file);
}

std::string with(std::string text, std::string_view from, std::string_view to) {
  const std::size_t place = text.find(from);
  if (place == std::string::npos) throw std::runtime_error("nothing reads " + std::string(from));
  return text.replace(place, from.size(), to);
}

std::string knee() {
  return R"({
  "kind": "gearbox_problem",
  "version": 1,
  "name": "D151 knee",
  "topology": "3k",
  "target_ratio": 20,
  "ratio_tolerance": 0,
  "rotor_inner_diameter_mm": 79.4,
  "module_mm": 0.6,
  "planet_count": 4,
  "min_teeth": {"sun": 40, "planet_1": 40, "planet_2": 30},
  "min_carrier_clearance_rad": 0.26,
  "constraints": "paper",
  "objective": "paper_cost",
  "friction_coefficient": 0.08,
  "assumed": ["/min_teeth", "/min_carrier_clearance_rad", "/friction_coefficient"]
}
)";
}

std::string knee_with(std::string_view from, std::string_view to) { return with(knee(), from, to); }

std::string tight_knee() {
  return knee_with("\"min_carrier_clearance_rad\": 0.26", "\"min_carrier_clearance_rad\": 0.4");
}

std::map<std::string, std::string> Workplace::files() const {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(path())) {
    files[entry.path().filename()] = entry.is_regular_file() ? text_of(entry.path()) : "";
  }
  return files;
}

}  // namespace torquewright::cli_test
