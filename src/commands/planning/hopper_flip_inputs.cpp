// SPDX-License-Identifier: Apache-2.0
#include "src/commands/planning/hopper_flip_inputs.hpp"

#include <fmt/format.h>

#include <utility>

#include "hopper/planning/tasks/library.hpp"
#include "io/faults/refusal.hpp"
#include "src/commands/robot/hopper_check_inputs.hpp"

namespace torquewright::cli {
namespace {

void require_repeat(const hopper::PlanOptions& plan) {
  if (plan.repeat > 1 && !plan.task->takes_repeat) {
    io::refuse("--repeat", "is for jumps and hops: a flip comes down from a single turn");
  }
  if (plan.has_alike_hops && plan.repeat < 2) {
    io::refuse("--alike", "is of hops that follow each other: --repeat 2 or more");
  }
  if (plan.repeat > 1 && !plan.stances.empty()) {
    io::refuse("--repeat", "and --contacts both say how often it flies: leave out one of them");
  }
}

/// A speed goes where the stride goes.
void require_speed(const HopperFlipRequest& request) {
  if (!request.speed_m_s) return;
  if (*request.speed_m_s == 0.0) {
    io::refuse("--speed", "of 0 goes nowhere: --task jump lands where it began");
  }
  if (request.stride_m && *request.stride_m * *request.speed_m_s <= 0.0) {
    io::refuse("--speed", fmt::format("of {:g} m/s does not go where a --stride of {:g} m goes",
                                      *request.speed_m_s, *request.stride_m));
  }
}

/// What only some tasks have.
void set_distances(const HopperFlipRequest& request, hopper::PlanOptions& plan) {
  if (request.rise_m && !plan.task->takes_rise) {
    io::refuse("--rise", "a flip rises as far as it has to; --task jump and --task hop take it");
  }
  if (request.stride_m && !plan.task->takes_stride) {
    io::refuse("--stride", "only --task hop takes it; a jump lands where it began");
  }
  for (const auto& [option, is_given] : {std::pair{"--speed", request.speed_m_s.has_value()},
                                         {"--land-at", !request.plan.landings_m.empty()}}) {
    if (is_given && !plan.task->takes_stride) {
      io::refuse(option, "only --task hop takes it; a jump lands where it began");
    }
  }
  require_speed(request);
  require_repeat(plan);
  plan.rise_m = request.rise_m.value_or(plan.rise_m);
  plan.stride_m = request.stride_m;
  plan.speed_m_s = request.speed_m_s;
}

/// Heights and speeds tell what touches where the motion does not.
void require_search_for_contacts(const HopperFlipRequest& request, const hopper::Motion& motion) {
  if (!motion.has_touching && !motion.has_forces) return;
  const hopper::ContactRule& contact = request.warm.check.contact;
  for (const auto& [option, is_given] :
       {std::pair{"--contact-height", contact.height_m.has_value()},
        {"--contact-speed", contact.speed_m_s.has_value()}}) {
    if (!is_given) continue;
    io::refuse(option,
               fmt::format("is for motions that do not say what touches, and {} has columns "
                           "for contacts",
                           request.warm.trajectory_file));
  }
}

std::unique_ptr<hopper::Motion> read_warm(const HopperFlipRequest& request,
                                          HopperFlipInputs& inputs) {
  if (request.warm.trajectory_file.empty()) return nullptr;
  if (request.plan.guess_noise_rad > 0.0) {
    io::refuse("--guess-noise",
               "moves the guess that a plan begins from on its own; --warm begins "
               "from a motion: leave out one of them");
  }
  const hopper::MotionFile source = motion_file(request.warm);
  inputs.columns = source.documents;
  auto motion = std::make_unique<hopper::Motion>(motion_in(source, inputs.robot.robot));
  require_search_for_contacts(request, *motion);
  return motion;
}

}  // namespace

void set_margins(const HopperFlipRequest& request, hopper::PlanOptions& plan) {
  plan.margins = hopper::with_reserve(plan.reserve);
  for (std::size_t i = 0; i < request.margins.size(); ++i) {
    if (request.margins[i]) plan.margins.*hopper::margin_parts()[i].margin = *request.margins[i];
  }
}

HopperFlipInputs read_flip_inputs(const HopperFlipRequest& request) {
  HopperFlipInputs inputs;
  hopper::PlanOptions& plan = inputs.plan;
  plan = request.plan;
  plan.task = &hopper::task_named(request.task);
  set_distances(request, plan);
  set_margins(request, plan);
  plan.limits = request.limits == "box" ? hopper::DriveLimits::kBox : hopper::DriveLimits::kMor;
  plan.objectives = read_objectives(request.objectives);
  plan.guess_seed = static_cast<unsigned>(request.guess_seed);
  inputs.robot = hopper::read_robot(request.warm.robot_file);
  plan.check = check_options(request.warm, inputs.robot);
  plan.check.keep_traces = !request.report_file.empty();
  inputs.warm = read_warm(request, inputs);
  plan.warm = inputs.warm.get();
  plan.warm_file = request.warm.trajectory_file;
  return inputs;
}

}  // namespace torquewright::cli
