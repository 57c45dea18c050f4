// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/run/staged_copy.hpp"

#include <utility>

namespace torquewright::hopper {
namespace {

class StagedEnvironment final : public learning::Environment {
 public:
  StagedEnvironment(std::shared_ptr<StagedCopy> copy, const std::vector<EpisodeOptions>& stages)
      : copy_(std::move(copy)), stages_(stages) {}

  void begin(std::uint64_t seed, std::uint64_t episode) override {
    copy_->stage = copy_->asked_stage;
    copy_->environment->go_by(stages_[copy_->stage]);
    copy_->environment->begin(seed, episode);
  }
  void observe(Eigen::Ref<Eigen::VectorXd> actor,
               Eigen::Ref<Eigen::VectorXd> critic) const override {
    copy_->environment->observe(actor, critic);
  }
  learning::Outcome act(const Eigen::Ref<const Eigen::VectorXd>& action) override {
    return copy_->environment->act(action);
  }

 private:
  std::shared_ptr<StagedCopy> copy_;
  const std::vector<EpisodeOptions>& stages_;
};

}  // namespace

std::unique_ptr<learning::Environment> staged_environment(
    std::shared_ptr<StagedCopy> copy, const std::vector<EpisodeOptions>& stages) {
  return std::make_unique<StagedEnvironment>(std::move(copy), stages);
}

}  // namespace torquewright::hopper
