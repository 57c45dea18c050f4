// SPDX-License-Identifier: Apache-2.0
// Cassie under operational-space control, its drives held to their regions: it stands in the first
// posture of its authors' jump, or (STAND_S 0) does the jump with the landing handled by default
// and by the projection. Prints the run by time.
//   study_cassie FOLDER STAND_S own|mujoco
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>

#include "hopper/check/hopper_check.hpp"
#include "hopper/engines/library.hpp"
#include "hopper/motion/motion_csv.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "hopper/replay/replay.hpp"
#include "hopper/tracking/operational/tasks_spec.hpp"
#include "tests/real_data/cassie/cassie.hpp"
#include "tests/real_data/cassie/cassie_jump.hpp"

namespace torquewright::bench {
namespace {

using hopper::ImpactHandling;

/// A motion as its file has it.
hopper::Motion read_back(const hopper::Robot& robot, const hopper::Motion& motion,
                         const std::filesystem::path& file) {
  std::ofstream(file) << hopper::motion_csv(robot, motion);
  return hopper::read_motion(robot, {file, {}, {}, {}});
}

void run_once(const hopper::Robot& robot, const hopper::Motion& motion,
              const hopper::HopperReport& report, const hopper::EngineKind& engine,
              ImpactHandling handling, double stand_s) {
  hopper::ReplayOptions options;
  options.engine = &engine;
  options.controller = &hopper::controllers::osc;
  options.impact.handling = handling;
  options.clock.resynchronise = false;
  options.run.stand_s = stand_s;
  options.tasks = std::make_shared<const hopper::OperationalTasks>(
      hopper::read_tasks(TORQUEWRIGHT_SOURCE_DIR "/specs/controller/cassie.json", robot).tasks);
  const hopper::ReplayedRun done = hopper::Replay(robot, motion, report, options).run({});
  const auto& outcome = done.result.outcome;
  fmt::print("{} {}: {} until {:.3f} s {}, {} of {} looks unsolved\n", engine.name,
             static_cast<int>(handling), hopper::name_of(outcome.verdict), outcome.end_s,
             outcome.reason, done.result.account.unsolved, done.result.account.looks);
  const std::size_t stride = std::max<std::size_t>(1, done.record.rows.size() / 24);
  for (std::size_t i = 0; i < done.record.rows.size(); i += stride) {
    const hopper::RecordRow& row = done.record.rows[i];
    fmt::print(
        "  {:.3f} s: base {:+.4f} {:+.4f} {:.4f} m, turned {:.3f}, speed {:.3f}, most {:.1f} "
        "Nm, touch {}\n",
        row.time_s, row.position[0], row.position[1], row.position[2],
        2.0 * row.position.segment<3>(4).norm(), row.velocity.norm(),
        row.torque_Nm.cwiseAbs().maxCoeff(), row.touches.count());
  }
  std::fflush(stdout);
}

/// Stands in the jump's first posture, or jumps with each handling (0 s).
void study(const std::filesystem::path& folder, double seconds, const char* engine) {
  const hopper::Robot robot = test::cassie();
  const test::PublishedJump jump = test::read_jump(test::published_jump_file());
  test::JumpClosure closure;
  hopper::Motion motion =
      seconds > 0.0
          ? read_back(robot, test::standing_motion(robot, jump, seconds), folder / "stand.csv")
          : read_back(robot, test::jump_motion(robot, jump, closure), folder / "jump.csv");
  fmt::print(
      "springs {:.4f} {:.4f}, slip {:.4f} m; legs {:.3f} flight {:.3f} m/s; {:.3f} {:.3f} "
      "Nm s\n",
      closure.bent_rad[0], closure.bent_rad[1], closure.foot_slip_m, closure.take_off_m_s.z(),
      closure.flight_m_s.z(), closure.take_off_Nm_s.y(), closure.flight_Nm_s.y());
  hopper::CheckOptions check;
  check.residual_share = 2.0;  // springs are rigid in the motion: what they need is left
  const hopper::HopperReport report = hopper::check_motion(robot, motion, check);
  const hopper::EngineKind& kind = hopper::engine_named(engine);
  run_once(robot, motion, report, kind, ImpactHandling::kDefault, 0.5);
  if (seconds > 0.0) return;
  run_once(robot, motion, report, kind, ImpactHandling::kInvariant, 0.5);
}

}  // namespace
}  // namespace torquewright::bench

int main(int count, char** arguments) {
  if (count != 4) {
    fmt::print(stderr, "study_cassie FOLDER STAND_S own|mujoco\n");
    return 2;
  }
  try {
    torquewright::bench::study(arguments[1], std::atof(arguments[2]), arguments[3]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
