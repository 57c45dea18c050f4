// SPDX-License-Identifier: Apache-2.0
#include "python/interpreter.hpp"

#include <exception>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "io/faults/refusal.hpp"
#include "io/files/file_session.hpp"
#include "src/held_output.hpp"
#include "src/interrupt.hpp"
#include "src/program.hpp"
#include "src/report/parts/progress_line.hpp"

namespace torquewright::python {
namespace {

/// The program takes words that end where the first such character stands.
void require_no_end(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word.find('\0') != std::string::npos) {
      io::refuse(word.substr(0, word.find('\0')), "holds the character U+0000; must be a text");
    }
  }
}

/// Tells a function of Python how far the work is, until it raises.
class Told {
 public:
  explicit Told(const pybind11::object& progress) : progress_(progress) {
    if (!progress.is_none()) listener_.emplace([this](const std::string& text) { tell(text); });
  }

  /// Raises what the function raised.
  void raise() const {
    if (raised_) std::rethrow_exception(raised_);
  }

 private:
  void tell(const std::string& text) {
    const pybind11::gil_scoped_acquire its_turn;
    if (raised_) return;
    try {
      progress_(text);
    } catch (const pybind11::error_already_set&) {
      raised_ = std::current_exception();
      cli::interrupt_forwarded();
    }
  }

  const pybind11::object& progress_;
  std::exception_ptr raised_;
  std::optional<report::ProgressListener> listener_;
};

struct Ended {
  Answer answer;
  bool is_interrupted = false;
};

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

/// What a process of the program has once, this process has while a command runs.
Ended run_alone(const std::vector<const char*>& arguments) {
  static std::mutex one_at_a_time;
  const Running running;
  const std::lock_guard turn(one_at_a_time);
  const io::FileSession session;
  const cli::HeldOutput output;
  const cli::ForwardedInterrupt interrupt;
  Ended ended{{cli::ExitCode::kUndecided, ""}};
  try {
    ended.answer.code = cli::run_program(static_cast<int>(arguments.size()), arguments.data());
  } catch (const cli::Interrupted&) {
    // Said below, as of work that ended with what it had.
  }
  ended.answer.text = output.text();
  ended.is_interrupted = cli::is_interrupted();
  return ended;
}

/// The interpreter's own handler was called as well: it says what Ctrl-C means, in its main thread.
[[noreturn]] void raise_interrupt() {
  if (PyErr_CheckSignals() == 0) PyErr_SetNone(PyExc_KeyboardInterrupt);
  throw pybind11::error_already_set();
}

}  // namespace

Answer run(const std::vector<std::string>& words, const pybind11::object& progress) {
  require_no_end(words);
  std::vector<const char*> arguments{"torquewright"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  const Told told(progress);
  Ended ended;
  {
    const pybind11::gil_scoped_release others_go_on;
    ended = run_alone(arguments);
  }
  told.raise();
  if (ended.is_interrupted) raise_interrupt();
  return ended.answer;
}

}  // namespace torquewright::python
