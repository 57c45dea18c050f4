// SPDX-License-Identifier: Apache-2.0
#include "hopper/skill/policy_controller.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

using Eigen::VectorXd;

class PolicyController final : public Controller {
 public:
  PolicyController(const Robot& robot, const Skill& skill, const learning::Policy& policy,
                   const Command& command)
      : skill_(skill),
        acting_(robot, skill),
        evaluation_(policy),
        command_(command),
        inputs_(VectorXd::Zero(policy.inputs())) {
    std::size_t drives = 0;
    for (const Drivetrain& drivetrain : robot.drivetrains) drives += drivetrain.actuators.size();
    fed_forward_Nm_ = VectorXd::Zero(static_cast<Eigen::Index>(drives));
  }

  std::string_view name() const override { return "policy"; }

  void start() override {
    looks_ = 0;
    acting_.start(command_);
  }

  void control(const Observation& seen, VectorXd& torque_Nm) override {
    const long every = std::max(1L, std::lround(skill_.control_period_s / seen.hold_s));
    if (looks_ % every == 0) {
      const long periods = looks_ / every;
      acting_.see(static_cast<double>(periods) * skill_.control_period_s, seen);
      acting_.write(inputs_);
      acting_.act(evaluation_.action(inputs_));
    }
    ++looks_;
    acting_.torque(seen, torque_Nm);
  }

  const VectorXd& fed_forward_Nm() const override { return fed_forward_Nm_; }

 private:
  const Skill& skill_;
  ActingSkill acting_;
  learning::PolicyEvaluation evaluation_;
  Command command_;
  VectorXd inputs_;
  VectorXd fed_forward_Nm_;
  long looks_ = 0;
};

class ReadyPolicy final : public ReadyController {
 public:
  ReadyPolicy(const Robot& robot, const Skill& skill, const learning::Policy& policy,
              const Command& command)
      : robot_(robot), skill_(skill), policy_(policy), command_(command) {}

  std::unique_ptr<Controller> make() const override {
    return std::make_unique<PolicyController>(robot_, skill_, policy_, command_);
  }

 private:
  const Robot& robot_;
  Skill skill_;
  learning::Policy policy_;
  Command command_;
};

}  // namespace

const ControllerKind policy_kind = {.name = "policy", .sentence = "a learned policy"};

std::unique_ptr<const ReadyController> policy_controller(const Robot& robot, const Skill& skill,
                                                         const learning::Policy& policy,
                                                         const Command& command) {
  return std::make_unique<const ReadyPolicy>(robot, skill, policy, command);
}

}  // namespace torquewright::hopper
