// SPDX-License-Identifier: Apache-2.0
#include "src/commands/identification/identify_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "identification/rig/joint_actuator_json.hpp"
#include "identification/rig/stated_robot_spec.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "io/text/name_pattern.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"
#include "robot/model/robot_spec.hpp"
#include "src/commands/shared/moved_references_json.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

using identification::Rig;

bool is_arm(const Rig& rig) { return rig.joints.size() > 1 || !rig.joints.front().empty(); }

std::size_t joint_of(const Rig& rig, const std::string& option, const std::string& name) {
  const auto found = std::find(rig.joints.begin(), rig.joints.end(), name);
  if (found != rig.joints.end()) return static_cast<std::size_t>(found - rig.joints.begin());
  const std::optional<std::string> near = io::nearest(name, rig.joints);
  io::refuse(option, fmt::format("the rig has no joint \"{}\"{}", name,
                                 near ? fmt::format("; did you mean \"{}\"?", *near)
                                      : fmt::format(", only {}", io::listed(rig.joints))));
}

/// Indices of the rig's joints that a name or a pattern of names stands for.
std::vector<std::size_t> joints_of(const Rig& rig, const std::string& option,
                                   const std::string& pattern) {
  if (pattern.find('*') == std::string::npos) return {joint_of(rig, option, pattern)};
  std::vector<std::size_t> joints;
  for (std::size_t i = 0; i < rig.joints.size(); ++i) {
    if (io::fits_pattern(rig.joints[i], pattern)) joints.push_back(i);
  }
  if (joints.empty()) {
    io::refuse(option, fmt::format("\"{}\" fits no joint of the rig; they are {}", pattern,
                                   io::listed(rig.joints)));
  }
  return joints;
}

/// Files given as JOINT=FILE, in the order of the rig's joints; as FILE where there is one joint.
/// JOINT may be a pattern where one file may be of several. Empty for joints of which none is
/// given.
std::vector<std::string> given_by_joint(const Rig& rig, const std::string& option,
                                        const std::vector<std::string>& given) {
  if (!is_arm(rig)) {
    if (given.size() != 1) io::refuse(option, "the rig has one joint, and so one such file");
    return given;
  }
  std::vector<std::string> files(rig.joints.size());
  for (const std::string& text : given) {
    const std::size_t mark = text.find('=');
    if (mark == std::string::npos || mark + 1 == text.size()) {
      io::refuse(option, fmt::format("\"{}\" must be JOINT=FILE; the rig's joints are {}", text,
                                     io::listed(rig.joints)));
    }
    for (const std::size_t joint : joints_of(rig, option, text.substr(0, mark))) {
      if (!files[joint].empty()) {
        io::refuse(option, fmt::format("{} is given twice", rig.joints[joint]));
      }
      files[joint] = text.substr(mark + 1);
    }
  }
  return files;
}

/// The same with a file for every joint.
std::vector<std::string> by_joint(const Rig& rig, const std::string& option,
                                  const std::vector<std::string>& given) {
  std::vector<std::string> files = given_by_joint(rig, option, given);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].empty()) io::refuse(option, fmt::format("{}=FILE is missing", rig.joints[i]));
  }
  return files;
}

/// Takes a robot's folder out of what is to be written: what names no joint.
std::string taken_folder(std::vector<std::string>& refined) {
  const auto names_no_joint = [](const std::string& each) {
    return each.find('=') == std::string::npos;
  };
  const auto folder = std::find_if(refined.begin(), refined.end(), names_no_joint);
  if (folder == refined.end()) return "";
  const std::string taken = *folder;
  refined.erase(folder);
  std::error_code unknown;
  if (std::filesystem::exists(taken, unknown) && !std::filesystem::is_directory(taken, unknown)) {
    io::refuse(taken,
               "is a file; of a robot several are written: name a folder, or JOINT=FILE for one "
               "actuator");
  }
  return taken;
}

/// What goes through a pipe can be read once, and the refined actuator is tried on the log again.
void require_plain_logs(const IdentifyRequest& request) {
  if (request.refined.empty() && request.as.empty()) return;
  for (const std::string& log : request.logs) {
    std::error_code unknown;
    const std::filesystem::file_status status = std::filesystem::status(log, unknown);
    if (!std::filesystem::is_other(status)) continue;
    io::refuse(log,
               "is no plain file, and for a refined actuator it is read twice; write it into "
               "a file first");
  }
}

void check_files(const IdentifyRequest& request, const IdentifyInputs& inputs) {
  std::vector<std::filesystem::path> written;
  for (const std::string& file : inputs.refined) {
    if (!file.empty()) written.emplace_back(file);
  }
  if (!request.outputs.empty()) written.emplace_back(report_document(request));
  if (!request.report_file.empty()) written.emplace_back(request.report_file);
  std::vector<std::filesystem::path> read(request.logs.begin(), request.logs.end());
  read.emplace_back(request.rig_file);
  for (const auto& actuator : inputs.actuators) {
    for (const io::Document& document : actuator.nominal.documents)
      read.emplace_back(document.file);
  }
  for (const io::Document& document : inputs.robot_documents) read.emplace_back(document.file);
  check_written(written, read);
  for (std::size_t i = 0; i < inputs.refined.size(); ++i) {
    if (inputs.refined[i].empty()) continue;
    require_movable_actuator(inputs.actuators[i].nominal.documents.front(), inputs.refined[i]);
  }
}

}  // namespace

IdentifyInputs read_inputs(const IdentifyRequest& request) {
  IdentifyInputs inputs;
  inputs.rig_document = io::read_document(request.rig_file, "rig");
  if (!request.robot_file.empty()) {
    identification::state_robot(request.robot_file, inputs.rig_document);
  }
  inputs.rig = identification::read_rig(inputs.rig_document);
  const bool is_robot = inputs.rig.load.type == identification::LoadType::kRobot;
  if (!is_robot && request.actuators.empty()) command_line::refuse("--actuator is required");
  const auto files_of = is_robot ? given_by_joint : by_joint;
  const std::vector<std::string> files = files_of(inputs.rig, "--actuator", request.actuators);
  std::vector<std::string> refined = request.refined;
  if (is_robot) inputs.refined_folder = taken_folder(refined);
  if (!refined.empty()) {
    inputs.refined = files_of(inputs.rig, request.is_old_spelling ? "-o" : "--refined", refined);
  }
  if (is_robot) {
    const std::filesystem::path beside = std::filesystem::path(inputs.rig.file).parent_path();
    inputs.robot_documents = hopper::read_robot(beside / inputs.rig.load.robot->file).documents;
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    inputs.actuators.push_back(
        {inputs.rig.joints[i], files[i].empty() ? identification::actuator_of_joint(inputs.rig, i)
                                                : actuator::read_wound_actuator(files[i])});
  }
  require_plain_logs(request);
  check_files(request, inputs);
  return inputs;
}

}  // namespace torquewright::cli
