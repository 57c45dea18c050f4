// SPDX-License-Identifier: Apache-2.0
#include "src/commands/refined_actuators.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "actuator/region/mor_table.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "actuator/region/region_comparison.hpp"
#include "io/json_text.hpp"
#include "src/report/comparison_text.hpp"
#include "src/report/region_plot.hpp"

namespace torquewright::cli {
namespace {

namespace fs = std::filesystem;
using identification::Verdict;
using nlohmann::ordered_json;

/// As it is to stand in the file: a gearbox in a file of its own is found from there.
std::string text_for(const ordered_json& document, const fs::path& nominal,
                     const fs::path& output) {
  ordered_json moved = document;
  ordered_json& gearbox = moved["gearbox"];
  if (gearbox.contains("file") && !output.empty()) {
    const fs::path file = nominal.parent_path() / gearbox["file"].get<std::string>();
    gearbox["file"] =
        fs::proximate(fs::absolute(file), fs::absolute(output).parent_path()).string();
  }
  return io::json_text(moved, 2);
}

RefinedActuator refined_actuator_of(const IdentifyInputs& inputs,
                                    const identification::Identification& found, std::size_t i) {
  const identification::JointActuator& nominal = inputs.actuators[i];
  const ordered_json document = identification::refined_actuator(found, nominal);
  const std::string& file = nominal.nominal.documents.front().file;
  const std::string output = i < inputs.outputs.size() ? inputs.outputs[i] : std::string();
  // From text, as whoever reads the file will see it.
  nlohmann::json root = nlohmann::json::parse(io::json_text(document));
  return {nominal.joint, text_for(document, file, output),
          actuator::read_actuator(io::check_document(std::move(root), "actuator", file, ""))};
}

bool has_changed(const actuator::RegionComparison& comparison) {
  for (const actuator::QuadrantComparison& quadrant : comparison.quadrants) {
    if (quadrant.worst_loss.change_Nm != 0.0 || quadrant.best_gain.change_Nm != 0.0) return true;
  }
  return false;
}

}  // namespace

std::vector<RefinedActuator> refined_actuators(const IdentifyInputs& inputs,
                                               const identification::Identification& found) {
  if (found.verdict == Verdict::kCannotTell || found.verdict == Verdict::kUnexplained) return {};
  std::vector<RefinedActuator> refined;
  try {
    for (std::size_t i = 0; i < inputs.actuators.size(); ++i) {
      refined.push_back(refined_actuator_of(inputs, found, i));
    }
  } catch (const io::SpecError& error) {
    std::fprintf(stderr, "the refined actuator would be refused:\n%s\n", error.what());
    return {};
  }
  return refined;
}

std::vector<io::FileContent> refined_files(const IdentifyInputs& inputs,
                                           const std::vector<RefinedActuator>& refined) {
  std::vector<io::FileContent> files;
  for (std::size_t i = 0; i < inputs.outputs.size(); ++i) {
    if (i < refined.size()) {
      files.push_back({inputs.outputs[i], refined[i].text});
    } else {
      std::fprintf(stderr, "%s: not written, there is nothing sure to add to the actuator\n",
                   inputs.outputs[i].c_str());
    }
  }
  return files;
}

std::vector<report::RegionSection> region_sections(const IdentifyInputs& inputs,
                                                   const std::vector<RefinedActuator>& refined) {
  std::vector<report::RegionSection> sections;
  const actuator::OperatingConditions conditions;
  for (std::size_t i = 0; i < refined.size(); ++i) {
    const actuator::Actuator& nominal = inputs.actuators[i].nominal.actuator;
    const actuator::Actuator& changed = refined[i].read.actuator;
    if (!actuator::objections(nominal, conditions).empty()) continue;
    if (!actuator::objections(changed, conditions).empty()) continue;
    const actuator::Region from(nominal, conditions), to(changed, conditions);
    const actuator::RegionComparison comparison = actuator::compare(from, to);
    if (!has_changed(comparison)) continue;
    const std::vector<report::PlottedRegion> regions{{"refined", actuator::mor_table(to)},
                                                     {"as stated", actuator::mor_table(from)}};
    sections.push_back({refined[i].joint,
                        report::region_plot(report::PlotFormat::kSvg, nominal.name, regions),
                        report::comparison_text("as stated", "refined", comparison)});
  }
  return sections;
}

}  // namespace torquewright::cli
