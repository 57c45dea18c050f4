// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/episode/hopper_environment.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "hopper/replay/fall.hpp"
#include "hopper/replay/free_rotors.hpp"
#include "hopper/training/episode/instant_builder.hpp"
#include "hopper/training/episode/moved_robot.hpp"
#include "hopper/training/episode/reward_sum.hpp"
#include "hopper/training/task/task_ends.hpp"
#include "hopper/trials/counted_random.hpp"
#include "hopper/trials/sensor_filter.hpp"
#include "hopper/trials/sensor_noise.hpp"
#include "hopper/trials/trial.hpp"
#include "hopper/trials/trial_start.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kTurnTolerance_rad = 0.5;  // as DeedTolerances has it

/// Whether the trial's bodies or contacts are others than the document's.
bool has_other_bodies(const Randomisation& from) {
  return from.total_mass_factor || !from.body_mass_factor.empty() ||
         !from.body_inertia_factor.empty() || !from.center_of_mass_shift_m.empty() ||
         from.friction_coefficient || from.restitution;
}

/// The voltage that the drives' document has without load times the drawn factor, asked for as a
/// condition: the same supply as a battery of that voltage, and regions made before still hold.
actuator::OperatingConditions voltage_as_condition(const Robot& robot, const Trial& trial,
                                                   actuator::OperatingConditions conditions) {
  if (trial.bus_voltage_factor == 1.0 || conditions.bus_voltage_V || trial.state_of_charge) {
    return conditions;
  }
  const actuator::Actuator& first = robot.drivetrains.front().actuators.front();
  conditions.bus_voltage_V = actuator::open_circuit_voltage_V(first, conditions);
  return conditions;
}

}  // namespace

class HopperEnvironment::Work {
 public:
  Work(const ReadyTask& ready, const EpisodeOptions& options)
      : ready_(ready),
        options_(&options),
        ends_(reference_of_ends(ready)),
        drives_(ready.robot, {options.limits, options.conditions, {}}),
        steps_per_control_(std::max(
            1L,
            static_cast<long>(std::ceil(ready.task.control_period_s / ready.task.step_s - 1e-9)))),
        step_s_(ready.task.control_period_s / static_cast<double>(steps_per_control_)),
        last_control_(std::lround(ready.task.duration_s / ready.task.control_period_s)),
        acting_(ready.robot, ready.skill) {}

  void go_by(const EpisodeOptions& options) { options_ = &options; }

  void begin(std::uint64_t seed, std::uint64_t episode) {
    trial_ = draw_trial(options_->randomisation, ready_.robot, seed, episode);
    key_ = mixed_in(mixed_in(seed, episode), "episode");
    noise_.emplace(options_->randomisation.noise, ready_.robot.tree, seed, episode);
    if (ready_.task.filters_sensors) {
      filter_.emplace(options_->randomisation.noise, ready_.robot.tree);
    }
    prepare();
    const MidState start = drawn_start();
    is_over_ = !moved_->start(start.position, start.velocity);
    latency_steps_ = std::lround(trial_.latency_s / step_s_);
    end_ = {};
    end_.episode = episode;
    end_.was_whole = start.control == 0;
    control_ = start.control;
    step_ = first_step_ = control_ * steps_per_control_;
    look_number_ = 0;
    cut_steps_ = 0;
    looks_.clear();
    acting_.start(command());
    builder_.emplace(ready_, moved_->body(), command());
    if (!end_.was_whole) builder_->begin_on_the_way(time_s(), start.turned_rad);
    look();
    look();
    acting_.see(time_s(), newest_look());
  }

  void observe(Eigen::Ref<VectorXd> actor, Eigen::Ref<VectorXd> critic) const {
    acting_.write(actor);
    critic.head(actor.size()) = actor;
    builder_->write_privileged(critic.tail(InstantBuilder::privileged_count(ready_.robot)), trial_);
  }

  learning::Outcome act(const Eigen::Ref<const VectorXd>& action) {
    acting_.act(action);
    builder_->begin(action);
    for (long i = 0; i < steps_per_control_ && !is_over_; ++i) advance();
    ++control_;
    builder_->follow(followed());
    const RewardInstant& at = builder_->finish(time_s(), is_over_, moved_->body(), ground_m());
    note(at);
    learning::Outcome outcome;
    outcome.rewards = rewards_of(ready_.rewards, at);
    require_gears(at);
    outcome.ended = is_over_;
    outcome.cut = !is_over_ && control_ >= last_control_;
    if (outcome.ended || outcome.cut) end_episode(at);
    acting_.see(time_s(), newest_look());
    return outcome;
  }

  std::vector<EpisodeEnd> take_ended() { return std::exchange(ended_, {}); }
  const Engine& engine() const { return moved_->engine(); }

 private:
  double ground_m() const { return trial_.ground_height_m; }
  double time_s() const { return static_cast<double>(control_) * ready_.task.control_period_s; }

  /// What the reference has now, behind its end what it had there; null: there is none.
  const MidState* followed() const {
    const auto& states = options_->mid_states;
    if (!states || states->empty()) return nullptr;
    return &(*states)[std::min(static_cast<std::size_t>(control_), states->size() - 1)];
  }

  /// Where the task begins, or a state on the way through its reference.
  MidState drawn_start() const {
    const auto& on_the_way = options_->mid_states;
    if (on_the_way && !on_the_way->empty() &&
        uniform_of(mixed_in(key_, "on the way")) < options_->mid_share) {
      const double place =
          uniform_of(mixed_in(key_, "where")) * static_cast<double>(on_the_way->size());
      MidState start =
          (*on_the_way)[std::min(static_cast<std::size_t>(place), on_the_way->size() - 1)];
      start.position[moved_robot_.tree.base == dynamics::BaseKind::kPlanar ? 1 : 2] += ground_m();
      return start;
    }
    RunStart start = start_of(moved_robot_, ends_, trial_);
    return {0, std::move(start.position), std::move(start.velocity), 0.0, {}};
  }

  Command command() const {
    Command command;
    if (!ready_.task.forward_m_s) return command;
    const auto& [least, greatest] = *ready_.task.forward_m_s;
    command.forward_m_s = least + (greatest - least) * uniform_of(mixed_in(key_, "forward"));
    return command;
  }

  /// Robot, engine and drives of the episode; those of the one before where nothing differs.
  void prepare() {
    const bool is_fresh = !moved_ || has_other_bodies(options_->randomisation);
    Trial bodies = trial_;
    bodies.bus_voltage_factor = 1.0;
    PoweredDriveOptions powered{
        options_->limits,
        conditions_of(trial_, voltage_as_condition(ready_.robot, trial_, options_->conditions)),
        trial_.further_friction_Nm, trial_.motor_strength_factor};
    if (is_fresh) {
      moved_.reset();
      moved_robot_ = without_free_rotors(perturbed(ready_.robot, bodies));
    } else if (!options_->randomisation.ground_height_m && !differs_in_drives()) {
      return;
    }
    EngineOptions on;
    on.ground_height_m = ground_m();
    moved_.emplace(moved_robot_, *options_->engine, on, drives_.under(powered));
  }

  bool differs_in_drives() const {
    const Randomisation& from = options_->randomisation;
    return !from.further_friction_Nm.empty() || !from.motor_strength_factor.empty() ||
           from.state_of_charge || from.bus_voltage_factor || from.winding_temperature_K;
  }

  void look() {
    Observation seen;
    seen.time_s = static_cast<double>(step_) * step_s_;
    seen.latency_s = static_cast<double>(latency_steps_) * step_s_;
    seen.hold_s = step_s_;
    seen.position = moved_->engine().position();
    seen.velocity = moved_->engine().velocity();
    noise_->disturb(look_number_++, seen.position, seen.velocity);
    if (filter_) filter_->estimate(seen.time_s, seen.position, seen.velocity);
    looks_.push_back({step_, std::move(seen)});
  }

  /// The youngest that is old enough, as run.cpp takes it.
  const Observation& newest_look() {
    const long newest = step_ - latency_steps_;
    while (looks_.size() > 1 && looks_[1].first <= newest) looks_.pop_front();
    return looks_.front().second;
  }

  void advance() {
    acting_.torque(newest_look(), wanted_Nm_);
    if (trial_.controller_gain_factor.size() > 0) {
      wanted_Nm_ = trial_.controller_gain_factor.cwiseProduct(wanted_Nm_).eval();
    }
    if (!moved_->step(wanted_Nm_, step_s_)) {
      is_over_ = true;
      end_.reason = moved_->why();
      return;
    }
    ++step_;
    look();
    builder_->note_step(*moved_, step_s_);
    if ((moved_->made().cut_off_Nm.array() != 0.0).any()) ++cut_steps_;
    const simulation::GroundProfile flat;
    if (auto fall = fallen(moved_robot_, moved_->body().state(), {ground_m(), flat})) {
      is_over_ = true;
      end_.reason = std::move(*fall);
    }
  }

  void note(const RewardInstant& at) {
    if (!at.is_in_air()) return;
    end_.peak_cam_Nm_s = std::max(end_.peak_cam_Nm_s, at.momentum_Nm_s.y());
    end_.peak_cav_rad_s = std::max(end_.peak_cav_rad_s, at.rotation_rad_s.y());
  }

  /// A gear that is loaded beyond its limit ends the episode with a probability.
  void require_gears(const RewardInstant& at) {
    if (is_over_ || !(ready_.task.overload_probability > 0.0)) return;
    Index drive = 0;
    for (const Drivetrain& drivetrain : ready_.robot.drivetrains) {
      for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i, ++drive) {
        if (!drivetrain.transmission_limit) continue;
        const double ratio = std::abs(drivetrain.actuators[i].transmission.ratio);
        const auto& [limit_Nm, side, source] = *drivetrain.transmission_limit;
        const double most_Nm = side == GearSide::kJoint ? limit_Nm / ratio : limit_Nm;
        if (at.load_Nm[drive] <= most_Nm) continue;
        const auto step = static_cast<std::uint64_t>(control_);
        if (uniform_of(mixed_in(mixed_in(key_, "overload"), step)) >=
            ready_.task.overload_probability) {
          continue;
        }
        is_over_ = true;
        end_.reason = drivetrain.actuator_names[i] + ": its gear is overloaded by the ground";
        return;
      }
    }
  }

  void end_episode(const RewardInstant& at) {
    const Goal& goal = ready_.task.goal;
    end_.fell = is_over_;
    end_.time_s = at.time_s;
    end_.turned_rad = at.turned_rad;
    end_.flights = at.flights;
    end_.clipped_share = step_ > first_step_ ? static_cast<double>(cut_steps_) /
                                                   static_cast<double>(step_ - first_step_)
                                             : 0.0;
    end_.did = !is_over_ && std::abs(at.turned_rad - goal.turn_rad) <= kTurnTolerance_rad &&
               end_.flights >= goal.least_flights && end_.flights <= goal.most_flights;
    ended_.push_back(end_);
  }

  const ReadyTask& ready_;
  const EpisodeOptions* options_;
  Reference ends_;
  PoweredDrives drives_;
  long steps_per_control_;
  double step_s_;
  long last_control_;
  ActingSkill acting_;
  Robot moved_robot_;
  std::optional<MovedRobot> moved_;
  std::optional<InstantBuilder> builder_;
  Trial trial_;
  std::optional<SensorNoise> noise_;
  std::optional<SensorFilter> filter_;
  std::uint64_t key_ = 0;
  std::deque<std::pair<long, Observation>> looks_;
  std::uint64_t look_number_ = 0;
  long latency_steps_ = 0;
  long step_ = 0;
  long first_step_ = 0;
  long control_ = 0;
  long cut_steps_ = 0;
  bool is_over_ = false;
  VectorXd wanted_Nm_;
  EpisodeEnd end_;
  std::vector<EpisodeEnd> ended_;
};

HopperEnvironment::HopperEnvironment(const ReadyTask& ready, const EpisodeOptions& options)
    : work_(std::make_unique<Work>(ready, options)) {}
HopperEnvironment::~HopperEnvironment() = default;

learning::Sizes HopperEnvironment::sizes(const ReadyTask& ready) {
  const auto inputs = static_cast<int>(ready.skill.inputs.size());
  return {inputs, inputs + static_cast<int>(InstantBuilder::privileged_count(ready.robot)),
          static_cast<int>(ready.skill.outputs.size()), kRewardHeads};
}

void HopperEnvironment::go_by(const EpisodeOptions& options) { work_->go_by(options); }

void HopperEnvironment::begin(std::uint64_t seed, std::uint64_t episode) {
  work_->begin(seed, episode);
}

void HopperEnvironment::observe(Eigen::Ref<VectorXd> actor, Eigen::Ref<VectorXd> critic) const {
  work_->observe(actor, critic);
}

learning::Outcome HopperEnvironment::act(const Eigen::Ref<const VectorXd>& action) {
  return work_->act(action);
}

std::vector<EpisodeEnd> HopperEnvironment::take_ended() { return work_->take_ended(); }
const VectorXd& HopperEnvironment::position() const { return work_->engine().position(); }
const VectorXd& HopperEnvironment::velocity() const { return work_->engine().velocity(); }

}  // namespace torquewright::hopper
