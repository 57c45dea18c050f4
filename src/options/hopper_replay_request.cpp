// SPDX-License-Identifier: Apache-2.0
#include "src/options/hopper_replay_request.hpp"

#include "hopper/engines/library.hpp"
#include "hopper/tracking/library.hpp"
#include "src/options/named_sentences.hpp"

namespace torquewright::cli {
namespace {

// Where results state options: behind those of the motion and of impacts, at 0.
constexpr int kSurroundingsPlace = 1;
constexpr int kTolerancesPlace = 2;
constexpr int kGroundPlace = 3;
constexpr int kCountedPlace = 4;  // of fingerprints alone

void add_simulation_options(command_line::Command& command, HopperReplayRequest& request) {
  command
      .add_option(
          "--engine", request.engine,
          "Which engine simulates: " + named_sentences(hopper::every_engine(), "{} ({})", " or "))
      .one_of(hopper::engine_names())
      .stated_elsewhere_as("engine", kCountedPlace);
  command
      .add_option("--limits", request.limits,
                  "What limits each drive: mor, its region at the voltage and temperature of the "
                  "instant; box, its peak torque at any speed up to no load")
      .one_of({"mor", "box"})
      .stated_elsewhere_as("limits", kCountedPlace);
  command.add_option("--step", request.step_s, "Time step of the engine, in s")
      .between(1e-6, 0.01)
      .stated_elsewhere_as("step_s", kCountedPlace);
  command
      .add_option(
          "--control-period", request.control_period_s,
          "Time between two looks of the controller, in s; rounded to whole steps of the engine")
      .between(1e-6, 0.1)
      .stated_elsewhere_as("control_period_s", kCountedPlace);
  command
      .add_option(
          "--latency", request.latency_s,
          "Time from a look at the robot to the torque that answers it, in s; rounded to steps")
      .between(0.0, 0.1)
      .stated_elsewhere_as("latency_s", kCountedPlace);
  command
      .add_option("--stand", request.stand_s,
                  "How long the robot is watched after the motion's end, in s")
      .between(0.0, 60.0)
      .stated_as("stand_s", kSurroundingsPlace);
  command
      .add_option("--ground-rise", request.ground_rise_m,
                  "How much higher the ground is than the motion believes, in m: contact comes "
                  "early; negative: late")
      .between(-1.0, 1.0)
      .stated_as("ground_rise_m", kSurroundingsPlace);
  command
      .add_option("--ground-time-constant", request.contact_time_constant_s,
                  "Time constant with which the ground gives, critically damped and giving nothing "
                  "back whatever contacts' restitution, in s; MuJoCo's solref")
      .between(1e-4, 1.0)
      .otherwise("rigid in the own engine, 0.001 in MuJoCo")
      .stated_as("ground_time_constant_s", kGroundPlace);
  command
      .add_option("--push", request.pushes,
                  "[BODY:]N_S@TIME: push a body's centre of mass (without BODY the base's) with an "
                  "impulse in N s at a time in s: 30@0.2 forwards, -5,0,10@0.2 by x, y and z")
      .otherwise("nobody pushes")
      .one_value_each()
      .stated_as("push", kSurroundingsPlace);
}

void add_tracking_options(command_line::Command& command, HopperReplayRequest& request) {
  command
      .add_option("--controller", request.controller,
                  "What follows the motion: " +
                      named_sentences(hopper::every_controller(), "{}, {}", "; ") +
                      "; all but osc feed the motion's own torques forward")
      .one_of(hopper::controller_names())
      .stated_elsewhere_as("controller", kCountedPlace);
  command
      .add_option("--tasks", request.tasks_file,
                  "Document of kind controller: what --controller osc weighs, and how much")
      .otherwise("centre of mass and base while it stands, joints in the air");
  command
      .add_option("--impact", request.impact,
                  "What is fed back of the error of velocities about an impact: default (all), "
                  "no_derivative (none), invariant (what no impulse of the contact can change)")
      .one_of({"default", "no_derivative", "invariant"})
      .stated_elsewhere_as("impact", kCountedPlace);
  command
      .add_option("--impact-metric", request.impact_metric,
                  "Metric in which --impact invariant splits the error: euclidean, as published, "
                  "or inertia")
      .one_of({"euclidean", "inertia"})
      .stated_as("impact_metric");
  command
      .add_option("--impact-contact", request.impact_contact,
                  "Which impulse --impact invariant means: of the points that the motion brings "
                  "down first, or of their whole foot")
      .one_of({"first", "foot"})
      .stated_as("impact_contact");
  command
      .add_flag("--fixed-clock", request.fixed_clock,
                "The motion goes on by the clock, whenever contact comes; else touch-down sets "
                "the clock")
      .stated_as("fixed_clock");
  command
      .add_option("--impact-window", request.impact_window_s,
                  "Half the width of the window about an impact, in s")
      .between(1e-4, 1.0)
      .stated_as("impact_window_s");
  command
      .add_option("--impact-blend", request.impact_blend_s,
                  "Time over which the window about an impact opens and closes, in s")
      .between(1e-5, 1.0)
      .stated_as("impact_blend_s");
}

void add_policy_options(command_line::Command& command, HopperReplayRequest& request) {
  command
      .add_option(
          "--task", request.task,
          "Task that a policy is judged by: a name as hopper train has it, or a document of "
          "kind training_task")
      .otherwise("the task that its document says");
  command
      .add_option(
          "--forward", request.forward_m_s,
          "Velocity that is commanded, in m/s: to a policy along x, to --controller stepping "
          "along the way that the robot faces")
      .otherwise("none")
      .between(-20.0, 20.0)
      .stated_as("forward_m_s", kSurroundingsPlace);
}

void add_verdict_options(command_line::Command& command, HopperReplayRequest& request) {
  hopper::DeedTolerances& deeds = request.deeds;
  command
      .add_option("--flight-tolerance", deeds.share,
                  "Share by which a flight's duration and the way to a place may be off, a rise by "
                  "twice that share")
      .between(0.001, 0.45)
      .stated_as("flight_tolerance", kTolerancesPlace);
  command
      .add_option("--place-tolerance", deeds.place_m,
                  "How far feet may be from where the motion puts them, in m, beside "
                  "--flight-tolerance of the way")
      .between(1e-4, 100.0)
      .stated_as("place_tolerance_m", kTolerancesPlace);
  command
      .add_option("--rotation-tolerance", deeds.turn_rad,
                  "By how much the base may have turned more or less than the motion's, in rad")
      .between(1e-3, 100.0)
      .stated_as("rotation_tolerance_rad", kTolerancesPlace);
  command
      .add_option("--heading-tolerance", deeds.heading_rad,
                  "How far from the motion's last heading the base may face at the end, in rad")
      .between(1e-3, 3.2)
      .stated_as("heading_tolerance_rad", kTolerancesPlace);
  command
      .add_option("--joint-tolerance", deeds.joint_rad,
                  "How far a joint may be from the motion's last posture, in rad")
      .between(1e-3, 100.0)
      .stated_as("joint_tolerance_rad", kTolerancesPlace);
  command
      .add_option("--slide-tolerance", deeds.slide_m,
                  "How far a slide may be from the motion's last posture, in m")
      .between(1e-4, 100.0)
      .stated_as("slide_tolerance_m", kTolerancesPlace);
  command
      .add_option("--speed-tolerance", deeds.speed_m_s,
                  "By how much hops may miss the speed --forward, in m/s")
      .between(1e-3, 100.0)
      .stated_as("speed_tolerance_m_s", kTolerancesPlace);
}

void add_trial_options(command_line::Command& command, HopperReplayRequest& request) {
  command
      .add_option("--trials", request.trials,
                  "How many randomised runs are made, beside the one as documented")
      .otherwise("none")
      .integer_between(1, 1000000)
      .stated_as("trials", kSurroundingsPlace);
  command
      .add_option("--randomise", request.randomise_file,
                  "Document of kind randomisation, which says what differs from trial to trial")
      .otherwise("what the robot is")
      .needs("--trials");
  command.add_option("--seed", request.seed, "Seed of the numbers that trials draw")
      .needs("--trials")
      .stated_elsewhere_as("seed", kCountedPlace);
  command.add_option("--trial", request.only_trial, "Run this one of the trials alone, from 0")
      .otherwise("all")
      .integer_between(0, 999999)
      .needs("--trials")
      .stated_as("trial", kSurroundingsPlace);
  command
      .add_option(
          "--success-rate", request.success_rate,
          "Share of the trials in which the robot must do the motion and stand, for exit code 0")
      .between(0.0, 1.0)
      .needs("--trials");
  command
      .add_flag("--no-filter", request.without_filter,
                "Show the controller noisy sensors as they are, without the filter of rates and "
                "positions")
      .needs("--trials")
      .stated_as("no_filter", kTolerancesPlace);
  command
      .add_flag("--explain", request.explains,
                "Run as many trials again for each thing that varies, alone: which one it is that "
                "the robot does not bear")
      .needs("--trials");
  command.add_option("--threads", request.threads, "How many threads run trials")
      .otherwise("as many as the processor runs at once")
      .integer_between(1, 256)
      .needs("--trials");
  add_point_options(command, request.points, "--trials");
  command.add_flag("--sweep-step", request.sweep,
                   "Run it with other steps of the engine too, and show what depends on the step");
}

void add_output_options(command_line::Command& command, HopperReplayRequest& request) {
  add_severity_option(command, request.motion.severity);
  command
      .add_option("--report", request.report_file,
                  "Write a page with both motions under a time cursor to this HTML")
      .names_a_file();
  command
      .add_option(
          "--series", request.series_file,
          "Write the run (with --trial that trial) by time, a motion that `hopper check` reads, to "
          "this CSV")
      .names_a_file();
  command.add_option("-o,--output", request.output_file, "Write the report as JSON to this file")
      .names_a_file();
  command.add_flag("--json", request.json, "Print the report as JSON");
}

}  // namespace

void add_hopper_replay_options(command_line::Command& command, HopperReplayRequest& request) {
  request.declared = &command.declared();
  command.add_option("robot", request.motion.robot_file, "Document of kind robot").required();
  command
      .add_option("motion", request.motion.trajectory_file,
                  "CSV as `hopper check` reads it, with the base's motion; or a policy, a document "
                  "(.json) of kind policy")
      .required();
  add_motion_options(command, request.motion);
  add_contact_options(command, request.motion.check.contact);
  add_operating_options(command, request.motion.operating);
  add_load_window(command, request.motion.check);
  add_simulation_options(command, request);
  add_tracking_options(command, request);
  add_policy_options(command, request);
  add_verdict_options(command, request);
  add_trial_options(command, request);
  add_output_options(command, request);
}

}  // namespace torquewright::cli
