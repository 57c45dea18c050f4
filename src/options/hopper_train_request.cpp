// SPDX-License-Identifier: Apache-2.0
#include "src/options/hopper_train_request.hpp"

#include "hopper/engines/library.hpp"
#include "hopper/training/rewards/library.hpp"
#include "hopper/training/task/task_spec.hpp"
#include "io/text/wording.hpp"
#include "src/options/named_sentences.hpp"

namespace torquewright::cli {
namespace {

void add_task_options(command_line::Command& command, HopperTrainRequest& request) {
  command.add_option("robot", request.robot_file, "Document of kind robot").required();
  command.add_option("--task", request.task,
                     "What is learned: " + io::either(hopper::training_task_names()) +
                         ", or a document of kind training_task, whose terms are " +
                         io::listed(hopper::reward_names()));
  command
      .add_option("--limits", request.limits,
                  "What limits each drive: mor, its region at the voltage and temperature of the "
                  "instant; box, its peak torque at any speed up to no load")
      .one_of({"mor", "box"});
  command
      .add_option(
          "--engine", request.engine,
          "Which engine simulates: " + named_sentences(hopper::every_engine(), "{} ({})", " or "))
      .one_of(hopper::engine_names());
  command
      .add_option("--randomise", request.randomise_file,
                  "Document of kind randomisation, which says what differs from episode to episode")
      .otherwise("what the task says of the start alone");
  command.add_flag("--curriculum", request.eases,
                   "Go by none of what --randomise says of bodies, ground, gains and sensors at "
                   "first, by a quarter more of it whenever 8 of 10 judged runs do the task");
  command
      .add_option(
          "--reference", request.reference_file,
          "Motion, as hopper flip writes it, whose targets the actions correct: what they "
          "ask for at 0 gives its torques on its way. The task flies when it does, and half "
          "of the episodes begin on the way through it. The task for it is flip_along")
      .otherwise("none: actions move targets about the posture of the start, where all begin");
  add_operating_options(command, request.operating);
}

void add_learning_options(command_line::Command& command, HopperTrainRequest& request) {
  command
      .add_option("--seconds", request.seconds,
                  "When the training ends, in s; the best policy is then written, as it is at "
                  "every moment before")
      .between(0.1, 1e7);
  command
      .add_option("--iterations", request.iterations,
                  "How often the policy is improved at most, whatever the time")
      .otherwise("as often as the time allows")
      .integer_between(1, 1000000000);
  command.add_option("--seed", request.seed, "Seed of the policy and of all episodes");
  command.add_option("--threads", request.threads, "How many threads act; they change no result")
      .integer_between(1, 256);
  command
      .add_option("--judge-every", request.judged_every,
                  "Iterations from one judgement of the policy to the next: runs as hopper replay "
                  "makes them, without noise on its actions")
      .integer_between(1, 1000000);
  command.add_option("--judge-runs", request.judged_runs, "Runs of each judgement")
      .integer_between(1, 10000);
  command.add_flag("--resume", request.resume,
                   "Go on where the training that writes to -o was when it last judged");
}

}  // namespace

void add_hopper_train_options(command_line::Command& command, HopperTrainRequest& request) {
  add_task_options(command, request);
  add_learning_options(command, request);
  command
      .add_option("-o,--output", request.policy_file,
                  "Write the best policy to this file, whole at every moment; beside it, with "
                  ".training behind its name, what --resume goes on from")
      .names_a_file()
      .not_standard_output()
      .needed_by_its_work();
  command.add_option("--curve", request.curve_file, "Write the learning curve to this CSV")
      .names_a_file();
}

}  // namespace torquewright::cli
