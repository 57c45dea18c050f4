// SPDX-License-Identifier: Apache-2.0
#include "python/run.hpp"

#include <mutex>
#include <optional>
#include <stdexcept>

#include "io/files/file_session.hpp"
#include "src/held_output.hpp"
#include "src/interrupt.hpp"
#include "src/program.hpp"
#include "src/report/parts/progress_line.hpp"

namespace torquewright::python {
namespace {

thread_local bool is_running = false;

struct Running {
  Running() {
    if (is_running) throw std::runtime_error("a progress function may ask no question itself");
    is_running = true;
  }
  ~Running() { is_running = false; }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
};

}  // namespace

// What a process of the program has once, this process has while a command runs.
Ended run(const std::vector<const char*>& words, Tell tell) {
  static std::mutex one_at_a_time;
  const Running running;
  const std::lock_guard turn(one_at_a_time);
  const io::FileSession session;
  const cli::HeldOutput output;
  const cli::ForwardedInterrupt interrupt;
  std::optional<report::ProgressListener> listener;
  if (tell != nullptr) {
    listener.emplace([tell](const std::string& text) {
      if (tell(text.c_str()) != 0) cli::interrupt_forwarded();
    });
  }
  std::vector<const char*> arguments{"torquewright"};
  arguments.insert(arguments.end(), words.begin(), words.end());
  Ended ended;
  try {
    ended.code = cli::run_program(static_cast<int>(arguments.size()), arguments.data());
  } catch (const cli::Interrupted&) {
    // Said below, as of work that ended with what it had.
  }
  ended.text = output.text();
  ended.is_interrupted = cli::is_interrupted();
  return ended;
}

}  // namespace torquewright::python
