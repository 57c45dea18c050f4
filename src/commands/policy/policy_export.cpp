// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <memory>
#include <string>

#include "hopper/policy/c_source.hpp"
#include "hopper/policy/onnx_export.hpp"
#include "hopper/policy/policy_spec.hpp"
#include "src/commands/policy/policy_commands.hpp"
#include "src/commands/shared/origin_lines.hpp"
#include "src/options/output_files.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct PolicyExportOptions {
  std::string policy_file;
  std::string format;
  std::string output_file;
};

ExitCode run_policy_export(const PolicyExportOptions& options) {
  const hopper::ReadPolicy read = hopper::read_policy(options.policy_file);
  check_written(named({options.output_file}), {options.policy_file});
  const std::array documents{read.document};
  deliver_result(options.format == "onnx"
                     ? hopper::onnx_bytes(hopper::onnx_graph_of(read.policy))
                     : hopper::c_source_of(read.policy, origin_of("policy export", documents)),
                 options.output_file);
  return ExitCode::kPasses;
}

}  // namespace

void add_policy_export_command(command_line::Command& policy) {
  auto options = std::make_shared<PolicyExportOptions>();
  command_line::Command command = policy.add_command(
      "export", "Write a policy as ONNX, or as a header of C, for the robot's computer");
  command.add_option("policy", options->policy_file, "Document of kind policy").required();
  command
      .add_option("--format", options->format,
                  "What is written: onnx (from observation to action and target), or c (a header "
                  "without dependencies, in floats)")
      .required()
      .one_of({"onnx", "c"});
  command.add_option("-o,--output", options->output_file, "Write it to this file")
      .otherwise("-, standard output")
      .names_a_file();
  command.example("torquewright policy export specs/policy/upright.json --format c");
  command.works([options] { return run_policy_export(*options); });
}

}  // namespace torquewright::cli
