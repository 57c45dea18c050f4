// SPDX-License-Identifier: Apache-2.0
// Samples a second of one core: forward, backward and Adam of a network, beside Eigen's products in
// a program for all processors; and steps a second of a trainer whose environment costs nothing.
#include <benchmark/benchmark.h>

#include <memory>

#include "learning/network/adam.hpp"
#include "learning/network/network.hpp"
#include "learning/training/trainer.hpp"

namespace torquewright::learning {
namespace {

constexpr int kBatch = 3200;
constexpr int kBlock = 256;  // as the trainer takes them

NetworkShape shape() { return {{18, 256, 128, 64, 2}, activation_of(ActivationKind::kLeakyRelu)}; }

template <typename Scalar>
void samples(benchmark::State& state) {
  Network<Scalar> network(shape());
  Generator generator(1, 0);
  network.draw(generator, 1.0);
  Adam<Scalar> adam(network.parameters().size());
  typename Network<Scalar>::Pass pass;
  pass.inputs = Network<Scalar>::Matrix::Random(18, kBlock);
  typename Network<Scalar>::Vector gradient(network.parameters().size());
  for ([[maybe_unused]] const auto _ : state) {
    gradient.setZero();
    for (int i = 0; i < kBatch; i += kBlock) {
      network.add_gradient(network.evaluate(pass), pass, gradient);
    }
    adam.step(gradient, 1e-6, network.parameters());
  }
  constexpr int kSamples = (kBatch + kBlock - 1) / kBlock * kBlock;
  state.counters["samples/s"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * kSamples, benchmark::Counter::kIsRate);
}

/// The four products of a layer and its gradient by Eigen alone: the peer.
void eigen_products(benchmark::State& state) {
  const std::vector<int> widths = shape().widths;
  std::vector<Eigen::MatrixXf> weights, values, errors, gradients;
  values.push_back(Eigen::MatrixXf::Random(widths[0], kBlock));
  errors.push_back(values.back());
  for (std::size_t i = 1; i < widths.size(); ++i) {
    weights.push_back(Eigen::MatrixXf::Random(widths[i], widths[i - 1]));
    gradients.push_back(weights.back());
    values.push_back(Eigen::MatrixXf::Random(widths[i], kBlock));
    errors.push_back(values.back());
  }
  for ([[maybe_unused]] const auto _ : state) {
    for (std::size_t i = 0; i < weights.size(); ++i) {
      values[i + 1].noalias() = weights[i] * values[i];
      values[i + 1] = values[i + 1].cwiseMax(0.01F * values[i + 1]);
    }
    for (std::size_t i = weights.size(); i-- > 0;) {
      gradients[i].noalias() = errors[i + 1] * values[i].transpose();
      if (i > 0) errors[i].noalias() = weights[i].transpose() * errors[i + 1];
    }
    benchmark::DoNotOptimize(gradients.front().data());
  }
  state.counters["samples/s"] = benchmark::Counter(static_cast<double>(state.iterations()) * kBlock,
                                                   benchmark::Counter::kIsRate);
}

/// Episodes of 200 steps in which nothing happens.
class Nothing : public Environment {
 public:
  void begin(std::uint64_t, std::uint64_t) override { step_ = 0; }
  void observe(Eigen::Ref<Eigen::VectorXd> actor,
               Eigen::Ref<Eigen::VectorXd> critic) const override {
    actor.setConstant(0.01 * step_);
    critic.setConstant(0.02 * step_);
  }
  Outcome act(const Eigen::Ref<const Eigen::VectorXd>& action) override {
    return {{-action.squaredNorm()}, false, ++step_ == 200};
  }

 private:
  int step_ = 0;
};

void trainer_steps(benchmark::State& state) {
  TrainerOptions options;
  options.threads = static_cast<int>(state.range(0));
  Trainer trainer(
      {18, 18, 2, 1}, [](int) { return std::make_unique<Nothing>(); }, options);
  trainer.iterate();
  std::int64_t steps = 0;
  for ([[maybe_unused]] const auto _ : state) {
    trainer.iterate();
    steps += options.copies * options.steps_per_iteration;
  }
  state.counters["steps/s"] =
      benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kIsRate);
}

BENCHMARK(samples<float>);
BENCHMARK(samples<double>);
BENCHMARK(eigen_products);
BENCHMARK(trainer_steps)->Arg(1)->Arg(2)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace torquewright::learning

BENCHMARK_MAIN();
