// SPDX-License-Identifier: Apache-2.0
#include "gearbox/search/design_spec.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearbox/problem_spec.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;

Rational rational(const json& number) { return io::exact(number.get<double>()); }

}  // namespace

ReadDesign read_design(const io::Document& result, std::size_t number) {
  const json& designs = result.root["designs"];
  if (number < 1 || number > designs.size()) {
    throw io::SpecError({{result.file, "/designs",
                          fmt::format("--design {} is not there; the number of designs is {}",
                                      number, designs.size())}});
  }
  const json& keys = designs[number - 1];
  ReadDesign read;
  read.problem = read_problem(
      io::check_document(result.root["problem"], "gearbox_problem", result.file, "/problem"));
  const TrainParts& parts = train_parts(read.problem.topology);
  for (const auto& gear : parts.gears) {
    const std::string name(gear);
    read.design.teeth.push_back(keys["teeth"].at(name));
    if (keys.contains("profile_shift")) {
      read.design.profile_shift.push_back(keys["profile_shift"].at(name));
    }
  }
  read.design.planet_count = keys["planet_count"];
  read.design.module_mm = rational(keys["module_mm"]);
  if (keys.contains("layer_2_module_mm")) {
    read.design.layer_2_module_mm = rational(keys["layer_2_module_mm"]);
  }
  const json widths =
      keys.value("face_width_mm", result.root["problem"].value("face_width_mm", json()));
  for (const std::string& layer : parts.layer_names()) {
    if (widths.contains(layer)) read.face_width_mm.push_back(widths[layer]);
  }
  return read;
}

}  // namespace torquewright::gearbox
