// SPDX-License-Identifier: Apache-2.0
#include "src/options/identify_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/atomic_file.hpp"
#include "io/nearest.hpp"
#include "io/wording.hpp"

namespace torquewright::cli {
namespace {

using identification::Rig;

[[noreturn]] void refuse(const std::string& option, std::string message) {
  throw io::SpecError({{option, "", std::move(message)}});
}

bool is_arm(const Rig& rig) { return rig.joints.size() > 1 || !rig.joints.front().empty(); }

std::size_t joint_of(const Rig& rig, const std::string& option, const std::string& name) {
  const auto found = std::find(rig.joints.begin(), rig.joints.end(), name);
  if (found != rig.joints.end()) return static_cast<std::size_t>(found - rig.joints.begin());
  const std::optional<std::string> near = io::nearest(name, rig.joints);
  refuse(option, fmt::format("the rig has no joint \"{}\"{}", name,
                             near ? fmt::format("; did you mean \"{}\"?", *near)
                                  : fmt::format(", only {}", io::listed(rig.joints))));
}

/// Files given as JOINT=FILE, in the order of the rig's joints; as FILE where there is one joint.
std::vector<std::string> by_joint(const Rig& rig, const std::string& option,
                                  const std::vector<std::string>& given) {
  if (!is_arm(rig)) {
    if (given.size() != 1) refuse(option, "the rig has one joint, and so one such file");
    return given;
  }
  std::vector<std::string> files(rig.joints.size());
  for (const std::string& text : given) {
    const std::size_t mark = text.find('=');
    if (mark == std::string::npos || mark + 1 == text.size()) {
      refuse(option, fmt::format("\"{}\" must be JOINT=FILE; the rig's joints are {}", text,
                                 io::listed(rig.joints)));
    }
    std::string& file = files[joint_of(rig, option, text.substr(0, mark))];
    if (!file.empty()) refuse(option, fmt::format("{} is given twice", text.substr(0, mark)));
    file = text.substr(mark + 1);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].empty()) refuse(option, fmt::format("{}=FILE is missing", rig.joints[i]));
  }
  return files;
}

void check_files(const IdentifyRequest& request, const IdentifyInputs& inputs) {
  std::vector<std::filesystem::path> written(inputs.outputs.begin(), inputs.outputs.end());
  if (!request.report_file.empty()) written.emplace_back(request.report_file);
  std::vector<std::filesystem::path> read(request.logs.begin(), request.logs.end());
  read.emplace_back(request.rig_file);
  for (const auto& actuator : inputs.actuators) {
    for (const io::Document& document : actuator.nominal.documents)
      read.emplace_back(document.file);
  }
  io::check_outputs(written, read);
}

}  // namespace

void add_log_options(command_line::Command& command, IdentifyRequest& request) {
  command.add_option("logs", request.logs, "CSV files of one rig, with a header");
  command.add_option("--rig", request.rig_file, "Document of kind rig: what the columns are");
  command
      .add_option(
          "--actuator", request.actuators,
          "Document of kind actuator, as designed; JOINT=FILE, once for each, on a serial arm")
      .one_value_each();
  command.add_flag("--json", request.json, "The report as JSON");
}

void require_log_options(const IdentifyRequest& request) {
  if (request.logs.empty()) command_line::refuse("logs is required");
  if (request.rig_file.empty()) command_line::refuse("--rig is required");
  if (request.actuators.empty()) command_line::refuse("--actuator is required");
}

IdentifyInputs read_inputs(const IdentifyRequest& request) {
  IdentifyInputs inputs;
  inputs.rig_document = io::read_document(request.rig_file, "rig");
  inputs.rig = identification::read_rig(inputs.rig_document);
  const std::vector<std::string> files = by_joint(inputs.rig, "--actuator", request.actuators);
  if (!request.outputs.empty()) inputs.outputs = by_joint(inputs.rig, "-o", request.outputs);
  for (std::size_t i = 0; i < files.size(); ++i) {
    inputs.actuators.push_back({inputs.rig.joints[i], actuator::read_actuator(files[i])});
  }
  check_files(request, inputs);
  return inputs;
}

}  // namespace torquewright::cli
