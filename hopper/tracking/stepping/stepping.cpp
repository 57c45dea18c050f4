// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/stepping/stepping.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "hopper/motion/landing.hpp"
#include "hopper/tracking/every_controller.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::VectorXd;

/// The modes that a landing begins.
std::vector<std::size_t> landings_of(const Reference& reference) {
  std::vector<std::size_t> landings;
  for (std::size_t i = 1; i < reference.modes().size(); ++i) {
    const bool has_flown = !reference.modes()[i - 1].touches.any();
    if (has_flown && reference.modes()[i].touches.any()) landings.push_back(i);
  }
  return landings;
}

class Stepping final : public Controller {
 public:
  Stepping(const Robot& robot, const Reference& reference, const ClockOptions& clock,
           double forward_m_s, std::unique_ptr<Controller> regulator)
      : tree_(&robot.tree),
        reference_(&reference),
        clock_(reference, clock),
        forward_m_s_(forward_m_s),
        planned_m_s_(hopping_speed_m_s(robot, reference)),
        last_landing_(landings_of(reference).back()),
        regulator_(std::move(regulator)) {}

  std::string_view name() const override { return "stepping"; }
  void start() override {
    regulator_->start();
    clock_.start();
    mode_ = 0;
    faster_m_s_ = 0.0;
    last_.reset();
  }

  void control(const Observation& seen, VectorXd& torque_Nm) override {
    const std::size_t mode = reference_->mode_at(clock_.read(seen.time_s, seen.touches).time_s);
    for (; mode_ < mode; ++mode_) {
      if (!reference_->modes()[mode_].touches.any()) land(mode_ + 1, seen);
    }
    if (faster_m_s_ == 0.0) return regulator_->control(seen, torque_Nm);
    Observation shown = seen;
    const Eigen::Vector2d faster_m_s =
        faster_m_s_ * landing_at(*tree_, seen.time_s, seen.position).forward;
    const Eigen::Index along = tree_->base == dynamics::BaseKind::kSpatial ? 2 : 1;
    shown.velocity.head(along) -= faster_m_s.head(along);
    regulator_->control(shown, torque_Nm);
  }

  const VectorXd& fed_forward_Nm() const override { return regulator_->fed_forward_Nm(); }

 private:
  void land(std::size_t mode, const Observation& seen) {
    const Landing here = landing_at(*tree_, seen.time_s, seen.position);
    faster_m_s_ +=
        kSpeedShare * (forward_m_s_ - (last_ ? hop_speed_m_s(*last_, here) : planned_m_s_));
    last_ = here;
    if (mode >= last_landing_) faster_m_s_ = 0.0;
  }

  const dynamics::Tree* tree_;
  const Reference* reference_;
  ReferenceClock clock_;
  double forward_m_s_;
  double planned_m_s_;
  std::size_t last_landing_;  ///< The mode that it begins.
  std::unique_ptr<Controller> regulator_;
  std::size_t mode_ = 0;
  double faster_m_s_ = 0.0;
  std::optional<Landing> last_;
};

}  // namespace

double hopping_speed_m_s(const Robot& robot, const Reference& reference) {
  const std::vector<std::size_t> landings = landings_of(reference);
  if (landings.size() < 2) return 0.0;
  const auto landing = [&](std::size_t mode) {
    ReferenceInstant at;
    reference.at(reference.modes()[mode].from_s, at);
    return landing_at(robot.tree, reference.modes()[mode].from_s, at.position);
  };
  return hop_speed_m_s(landing(landings.front()), landing(landings.back()));
}

std::unique_ptr<Controller> stepping_controller(const Robot& robot, const Reference& reference,
                                                const ClockOptions& clock, double forward_m_s,
                                                std::unique_ptr<Controller> regulator) {
  return std::make_unique<Stepping>(robot, reference, clock, forward_m_s, std::move(regulator));
}

}  // namespace torquewright::hopper

namespace torquewright::hopper::controllers {
namespace {

class ReadyStepping final : public ReadyController {
 public:
  ReadyStepping(const Robot& robot, const Reference& reference, const TrackingOptions& options)
      : robot_(robot),
        reference_(reference),
        clock_(options.clock),
        forward_m_s_(*options.forward_m_s),
        regulator_(weighing.prepare(robot, reference, options)) {}

  std::unique_ptr<Controller> make() const override {
    return stepping_controller(robot_, reference_, clock_, forward_m_s_, regulator_->make());
  }

 private:
  const Robot& robot_;
  const Reference& reference_;
  ClockOptions clock_;
  double forward_m_s_;
  std::unique_ptr<const ReadyController> regulator_;
};

std::unique_ptr<const ReadyController> prepare_stepping(const Robot& robot,
                                                        const Reference& reference,
                                                        const TrackingOptions& options) {
  if (!options.forward_m_s) {
    io::refuse("--controller", "stepping follows a speed: --forward says which, in m/s");
  }
  if (landings_of(reference).size() < 2) {
    io::refuse("--controller",
               fmt::format("stepping corrects each hop by the one before, and the motion lands {}: "
                           "`hopper flip --task hop --repeat 2 --alike` plans hops, --hops "
                           "repeats them",
                           landings_of(reference).empty() ? "never" : "once"));
  }
  const double planned_m_s = hopping_speed_m_s(robot, reference);
  if (std::abs(*options.forward_m_s - planned_m_s) > kFarthestSpeed_m_s) {
    io::refuse(
        "--forward",
        fmt::format(
            "{:g} m/s is {:.3g} m/s from the {:.3g} m/s at which the motion hops, "
            "and its steps follow up to {:g} m/s from it: `hopper flip --task hop "
            "--speed {:g} --repeat 2 --alike` plans a nearer one, or says what keeps the robot "
            "from it",
            *options.forward_m_s, std::abs(*options.forward_m_s - planned_m_s), planned_m_s,
            kFarthestSpeed_m_s, *options.forward_m_s));
  }
  return std::make_unique<const ReadyStepping>(robot, reference, options);
}

}  // namespace

const ControllerKind stepping = {.name = "stepping",
                                 .sentence = "weighing, its hops at the speed --forward",
                                 .has_speed = true,
                                 .prepare = prepare_stepping};

}  // namespace torquewright::hopper::controllers
