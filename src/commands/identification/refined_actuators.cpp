// SPDX-License-Identifier: Apache-2.0
#include "src/commands/identification/refined_actuators.hpp"

#include <cstdio>
#include <utility>

#include "actuator/mor/mor_table.hpp"
#include "actuator/mor/region_comparison.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "identification/answer/refined_json.hpp"
#include "identification/answer/self_check.hpp"
#include "io/faults/json_text.hpp"
#include "io/text/one_line.hpp"
#include "src/commands/identification/identify_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/report/actuator/comparison_text.hpp"
#include "src/report/actuator/region_plot.hpp"

namespace torquewright::cli {
namespace {

RefinedActuator refined_actuator_of(const IdentifyInputs& inputs,
                                    const identification::Identification& found,
                                    const identification::Identification* judged, std::size_t i) {
  const identification::JointActuator& nominal = inputs.actuators[i];
  const std::vector<io::Document>& documents = nominal.nominal.documents;
  const std::string& file = documents.front().file;
  const std::string output = i < inputs.refined.size() ? inputs.refined[i] : std::string();
  const auto document = identification::refined_actuator(found, nominal, judged);
  io::Document refined = io::check_document(as_read(io::json_text(document)), "actuator", file, "");
  return {nominal.joint, refined_text(document, file, output),
          actuator::read_actuator(std::move(refined), documents)};
}

bool has_changed(const actuator::RegionComparison& comparison) {
  for (const actuator::QuadrantComparison& quadrant : comparison.quadrants) {
    if (quadrant.worst_loss.change_Nm != 0.0 || quadrant.best_gain.change_Nm != 0.0) return true;
  }
  return false;
}

}  // namespace

RefinedActuators refined_actuators(const IdentifyInputs& inputs,
                                   const identification::Identification& found,
                                   const identification::Identification* judged) {
  if (!identification::has_anything_to_write(found)) return {};
  RefinedActuators refined;
  try {
    for (std::size_t i = 0; i < inputs.actuators.size(); ++i) {
      refined.of_joints.push_back(refined_actuator_of(inputs, found, judged, i));
    }
  } catch (const io::SpecError& error) {
    return {{}, error.what(), {}};
  }
  return refined;
}

void judge_as_written(const IdentifyRequest& request, const IdentifyInputs& inputs,
                      const identification::Identification& found, RefinedActuators& refined) {
  if (refined.of_joints.empty()) return;
  std::vector<identification::JointActuator> actuators;
  for (const RefinedActuator& each : refined.of_joints)
    actuators.push_back({each.joint, each.read});
  identification::Identification judged = identification::as_written(
      {request.logs.begin(), request.logs.end()}, inputs.rig, actuators, found);
  std::string broken = identification::broken_promise(found, judged);
  if (!broken.empty()) {
    refined = {{}, std::move(broken), {}};
    return;
  }
  refined = refined_actuators(inputs, found, &judged);
  refined.judged = std::move(judged);
}

std::vector<io::FileContent> refined_files(const IdentifyInputs& inputs,
                                           const RefinedActuators& refined) {
  if (!refined.refusal.empty()) {
    std::fprintf(stderr, "the refined actuator is refused:\n%s\n", refined.refusal.c_str());
  }
  std::vector<io::FileContent> files;
  for (std::size_t i = 0; i < inputs.refined.size(); ++i) {
    if (inputs.refined[i].empty()) continue;
    if (i < refined.of_joints.size()) {
      files.push_back({inputs.refined[i], refined.of_joints[i].text});
    } else {
      std::fprintf(stderr, "%s: not written%s\n", io::name_in_text(inputs.refined[i]).c_str(),
                   refined.refusal.empty() ? ", there is nothing sure to add to the actuator" : "");
    }
  }
  return files;
}

std::vector<report::RegionSection> region_sections(const IdentifyInputs& inputs,
                                                   const RefinedActuators& refined) {
  std::vector<report::RegionSection> sections;
  const actuator::OperatingConditions conditions;
  for (std::size_t i = 0; i < refined.of_joints.size(); ++i) {
    const actuator::Actuator& nominal = inputs.actuators[i].nominal.actuator;
    const actuator::Actuator& changed = refined.of_joints[i].read.actuator;
    if (!actuator::objections(nominal, conditions).empty()) continue;
    if (!actuator::objections(changed, conditions).empty()) continue;
    const actuator::Region from(nominal, conditions), to(changed, conditions);
    const actuator::RegionComparison comparison = actuator::compare(from, to);
    if (!has_changed(comparison)) continue;
    const std::vector<report::PlottedRegion> regions{{"refined", actuator::mor_table(to)},
                                                     {"as stated", actuator::mor_table(from)}};
    sections.push_back({refined.of_joints[i].joint,
                        report::region_plot(report::PlotFormat::kSvg, nominal.name, regions),
                        report::comparison_text("as stated", "refined", comparison)});
  }
  return sections;
}

}  // namespace torquewright::cli
