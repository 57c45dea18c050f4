// SPDX-License-Identifier: Apache-2.0
#include "learning/training/saved_state.hpp"

#include <cstring>
#include <istream>
#include <ostream>
#include <stdexcept>

namespace torquewright::learning {
namespace {

constexpr const char* kFirstLine = "torquewright training state 1";
constexpr std::uint64_t kLongestText = 1 << 16;
constexpr std::uint64_t kMostActions = 1 << 28;

static_assert(std::endian::native == std::endian::little, "states are written lowest byte first");

/// Puts numbers into a stream; one function for each kind that a state has.
class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}

  void operator()(const std::int64_t& value) { put(&value, sizeof value); }
  void operator()(const std::uint64_t& value) { put(&value, sizeof value); }
  void operator()(const double& value) { put(&value, sizeof value); }
  template <typename Scalar>
  void operator()(const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& values) {
    put(values.data(), static_cast<std::size_t>(values.size()) * sizeof(Scalar));
  }
  void operator()(const std::vector<float>& values) {
    (*this)(static_cast<std::uint64_t>(values.size()));
    put(values.data(), values.size() * sizeof(float));
  }
  void operator()(const RunningMoments& moments) { (*this)(moments.state()); }

 private:
  void put(const void* bytes, std::size_t count) {
    out_.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
  }

  std::ostream& out_;
};

/// Takes them out again, into values of the same sizes.
class Reader {
 public:
  explicit Reader(std::istream& in) : in_(in) {}

  void operator()(std::int64_t& value) { take(&value, sizeof value); }
  void operator()(std::uint64_t& value) { take(&value, sizeof value); }
  void operator()(double& value) { take(&value, sizeof value); }
  template <typename Scalar>
  void operator()(Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& values) {
    take(values.data(), static_cast<std::size_t>(values.size()) * sizeof(Scalar));
    if (!values.allFinite()) throw std::invalid_argument("the training state is damaged");
  }
  void operator()(std::vector<float>& values) {
    std::uint64_t count = 0;
    (*this)(count);
    if (count > kMostActions) throw std::invalid_argument("the training state is damaged");
    values.resize(count);
    take(values.data(), count * sizeof(float));
  }
  void operator()(RunningMoments& moments) {
    Eigen::VectorXd state = moments.state();
    (*this)(state);
    moments.set_state(state);
  }

 private:
  void take(void* bytes, std::size_t count) {
    in_.read(static_cast<char*>(bytes), static_cast<std::streamsize>(count));
    if (!in_) throw std::invalid_argument("the training state ends too early");
  }

  std::istream& in_;
};

template <typename Visitor, typename ALearner>
void visit_learner(Visitor& visit, ALearner& learner) {
  visit(learner.network.parameters());
  visit(learner.adam.mean);
  visit(learner.adam.square);
  visit(learner.adam.steps);
}

/// Shows every number of a state to `visit`, in the order of the file.
template <typename Visitor, typename AState>
void visit_state(Visitor& visit, AState& state) {
  visit(state.iteration);
  visit(state.steps);
  auto& model = state.model;
  visit(model.actor_inputs.moments);
  visit(model.actor_inputs.mean);
  visit(model.actor_inputs.inverse_deviation);
  visit(model.critic_inputs.moments);
  visit(model.critic_inputs.mean);
  visit(model.critic_inputs.inverse_deviation);
  if (model.estimator) visit_learner(visit, *model.estimator);
  visit_learner(visit, model.actor);
  for (auto& critic : model.critics) visit_learner(visit, critic);
  visit(model.log_deviations);
  visit(model.deviations_adam.mean);
  visit(model.deviations_adam.square);
  visit(model.deviations_adam.steps);
  visit(model.returns);
  visit(model.rate);
  for (auto& copy : state.copies) {
    visit(copy.generator_state);
    visit(copy.episodes_begun);
    visit(copy.actions_taken);
    visit(copy.view);
  }
}

std::string line_of(std::istream& in) {
  std::string line;
  for (int byte = in.get(); byte != '\n' && in && line.size() < kLongestText; byte = in.get()) {
    line += static_cast<char>(byte);
  }
  return line;
}

}  // namespace

void write_state(std::ostream& out, const std::string& fingerprint, const SavedState& state) {
  out << kFirstLine << '\n' << fingerprint << '\n';
  Writer write(out);
  visit_state(write, state);
}

void read_state(std::istream& in, const std::string& fingerprint, SavedState& state) {
  if (line_of(in) != kFirstLine) {
    throw std::invalid_argument("this is no training state that this version wrote");
  }
  if (line_of(in) != fingerprint) {
    throw std::invalid_argument("the training state is one of other sizes, seed or options");
  }
  Reader read(in);
  visit_state(read, state);
  if (in.peek() != std::istream::traits_type::eof()) {
    throw std::invalid_argument("the training state goes on behind its end");
  }
}

}  // namespace torquewright::learning
