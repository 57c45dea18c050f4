// SPDX-License-Identifier: Apache-2.0
// A program that sweeps nothing but numbers: point K has the row {"square": K^2, "third": K/3}.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "io/faults/spec_error.hpp"
#include "src/command_line/command_line.hpp"
#include "src/command_line/exit_status.hpp"
#include "src/interrupt.hpp"
#include "src/sweep/sweep.hpp"
#include "src/sweep/worker_channel.hpp"

namespace torquewright {
namespace {

struct Toy {
  int points = 10;
  int jobs = 1;
  std::string journal;
  std::string request = "toy";
  bool is_fickle = false;  ///< Every process reads other inputs.
  int killed = -1;         ///< The point whose process is killed.
  int thrown = -1;         ///< The point that throws.
  int refuses = -1;        ///< Exit code with which processes end before they begin.
  int slow_ms = 0;
  int dies = -1;      ///< The rank of mpirun that is killed by its worker, at its first point.
  std::string diary;  ///< A file: each point that is done, on a line.
};

/// In a worker, whose parent the rank is. MPI has begun there: one that dies before leaves the
/// others to wait within MPI.
bool is_in_rank(int number) {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  return rank != nullptr && std::atoi(rank) == number;
}

std::string row_of(const Toy& toy, std::size_t point) {
  const int number = static_cast<int>(point);
  if (!toy.diary.empty()) {
    std::ofstream(toy.diary, std::ios::app) << fmt::format("{}\n", number) << std::flush;
  }
  if (number == toy.killed) ::raise(SIGKILL);
  if (is_in_rank(toy.dies)) ::kill(::getppid(), SIGKILL);
  if (number == toy.thrown) throw std::runtime_error("point of trouble");
  std::this_thread::sleep_for(std::chrono::milliseconds(toy.slow_ms));
  return fmt::format(R"({{ "square": {}, "third": {} }})", number * number, number / 3.0);
}

cli::ExitCode run(const Toy& toy) {
  cli::catch_interrupt();
  if (toy.refuses >= 0 && sweep::is_silent()) std::exit(toy.refuses);
  sweep::Request request;
  for (int i = 0; i < toy.points; ++i) request.points.push_back(fmt::format("number={}", i));
  request.fingerprint = toy.is_fickle ? std::to_string(::getpid()) : toy.request;
  request.journal_file = toy.journal;
  request.jobs = static_cast<std::size_t>(toy.jobs);
  const auto outcome = sweep::run_sweep(
      request, [&](std::size_t point) { return row_of(toy, point); }, {cli::is_interrupted, {}});
  if (!outcome) return cli::ExitCode::kPasses;
  bool is_whole = true;
  for (std::size_t i = 0; i < outcome->answers.size(); ++i) {
    const auto& answer = outcome->answers[i];
    const std::string text = !answer           ? "not done"
                             : answer->is_lost ? "lost: " + answer->why
                                               : answer->row;
    is_whole = is_whole && answer && !answer->is_lost;
    std::printf("%s %s\n", request.points[i].c_str(), text.c_str());
  }
  return is_whole ? cli::ExitCode::kPasses : cli::ExitCode::kUndecided;
}

int toy_main(int argc, char** argv) {
  Toy toy;
  command_line::Program program("toy_sweep", "Sweeps numbers");
  command_line::Command& top = program.top();
  top.add_option("--points", toy.points, "");
  top.add_option("--jobs", toy.jobs, "");
  top.add_option("--journal", toy.journal, "");
  top.add_option("--request", toy.request, "");
  top.add_flag("--fickle", toy.is_fickle, "");
  top.add_option("--killed", toy.killed, "");
  top.add_option("--thrown", toy.thrown, "");
  top.add_option("--refuses", toy.refuses, "");
  top.add_option("--slow", toy.slow_ms, "");
  top.add_option("--dies", toy.dies, "");
  top.add_option("--diary", toy.diary, "");
  top.works([&toy] { return run(toy); });
  return command_line::exit_status([&] { return program.run(argc, argv); });
}

}  // namespace
}  // namespace torquewright

int main(int argc, char** argv) { return torquewright::toy_main(argc, argv); }
