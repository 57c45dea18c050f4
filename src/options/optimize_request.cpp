// SPDX-License-Identifier: Apache-2.0
#include "src/options/optimize_request.hpp"

namespace torquewright::cli {

void add_optimize_options(command_line::Command& command, OptimizeRequest& request) {
  request.declared = &command.declared();
  command.add_option("problem", request.problem_file, "Document of kind gearbox_problem")
      .required();
  add_output_options(command, request.outputs);
  command.add_option("--top", request.top, "How many of the best designs are listed")
      .integer_between(1, 1000000)
      .stated_as("top");
  command
      .add_option("--relaxation", request.relaxation,
                  "When bounds come from a convex relaxation too, which Ipopt solves, and not from "
                  "intervals alone")
      .one_of({"auto", "always", "never"})
      .stated_as("relaxation");
  command
      .add_option("--max-nodes", request.max_nodes,
                  "End the search after so many boxes, parts of the space that is searched")
      .otherwise("as many as it takes")
      .integer_between(1, std::int64_t{1} << 60)
      .stated_as("max_nodes");
  command.add_option("--time-limit", request.time_limit_s, "End the search after so many seconds")
      .otherwise("as long as it takes")
      .between(0.001, 1e7)
      .stated_as("time_limit_s");
  command.add_flag("--verify", request.verify, "Check the proof with the independent checker");
  command.add_flag("--json", request.json, "Print the result as JSON");
  command
      .add_flag("--all", request.all,
                "Print tables of gears and meshes, every constraint, the proof")
      .excludes("--json");
  command.add_flag("--timing", request.timing, "State the seconds (runs then differ in bytes)");
}

}  // namespace torquewright::cli
