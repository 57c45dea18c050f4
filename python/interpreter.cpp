// SPDX-License-Identifier: Apache-2.0
#include "python/interpreter.hpp"

#include <pybind11/pybind11.h>

#include <mutex>

#include "io/faults/refusal.hpp"
#include "io/files/file_session.hpp"
#include "src/held_output.hpp"
#include "src/interrupt.hpp"
#include "src/program.hpp"

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

struct Ended {
  Answer answer;
  bool is_interrupted = false;
};

/// What a process of the program has once, this process has while a command runs.
Ended run_alone(const std::vector<const char*>& arguments) {
  static std::mutex one_at_a_time;
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

Answer run(const std::vector<std::string>& words) {
  require_no_end(words);
  std::vector<const char*> arguments{"torquewright"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  Ended ended;
  {
    const pybind11::gil_scoped_release others_go_on;
    ended = run_alone(arguments);
  }
  if (ended.is_interrupted) raise_interrupt();
  return ended.answer;
}

}  // namespace torquewright::python
