// SPDX-License-Identifier: Apache-2.0
// What python/torquewright/_core.py calls, by ctypes: functions of C, so that one library serves
// every version of Python. What a call said is kept for its thread until the thread's next call.
#include <cstddef>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "actuator/mor/clip_table.hpp"
#include "io/documents/document.hpp"
#include "io/documents/provenance.hpp"
#include "io/documents/schema.hpp"
#include "io/faults/json_text.hpp"
#include "io/faults/spec_error.hpp"
#include "python/run.hpp"

#define TORQUEWRIGHT_ENTRY extern "C" __attribute__((visibility("default")))

namespace torquewright::python {
namespace {

/// How calls end beside the program's own exit codes, as _core.py has them.
constexpr int kRefused = -1;      // texts: file, path and message of each fault
constexpr int kFailed = -2;       // text: why
constexpr int kInterrupted = -3;  // no text
constexpr int kAnswered = 0;

thread_local std::vector<std::string> said;

/// No exception may pass into C: it becomes a code, and what it says texts.
template <typename Work>
int guarded(const Work& work) {
  said.clear();
  try {
    return work();
  } catch (const io::SpecError& error) {
    for (const io::Fault& fault : error.faults()) {
      said.insert(said.end(), {fault.file, fault.path, fault.message});
    }
    return kRefused;
  } catch (const std::exception& error) {
    said = {error.what()};
    return kFailed;
  }
}

int run_words(const std::vector<const char*>& words, Tell tell) {
  Ended ended = run(words, tell);
  if (ended.is_interrupted) return kInterrupted;
  said = {std::move(ended.text)};
  return static_cast<int>(ended.code);
}

}  // namespace
}  // namespace torquewright::python

using namespace torquewright;
using namespace torquewright::python;

/// Runs a command of the program: its exit code, and as text what it printed.
TORQUEWRIGHT_ENTRY int torquewright_run(const char* const* words, std::size_t count, Tell tell) {
  return guarded([&] { return run_words({words, words + count}, tell); });
}

/// Text: a document of any kind, checked, as JSON.
TORQUEWRIGHT_ENTRY int torquewright_read(const char* file) {
  return guarded([&] {
    said = {io::json_text(io::read_any_document(file).root)};
    return kAnswered;
  });
}

/// The texts of this thread's last call: how many, and the bytes of each.
TORQUEWRIGHT_ENTRY std::size_t torquewright_text_count() { return said.size(); }
TORQUEWRIGHT_ENTRY const char* torquewright_text(std::size_t index, std::size_t* length) {
  *length = said[index].size();
  return said[index].data();
}

TORQUEWRIGHT_ENTRY const char* torquewright_version() {
  static const std::string version(io::tool_version());
  return version.c_str();
}

/// The region's table, ready to clip arrays, to be freed; null, with a text, where speeds do not
/// ascend or are fewer than two. `error_Nm` is by how much lines between the rows may be off: both
/// bounds are drawn in by it, as in the files for simulators.
TORQUEWRIGHT_ENTRY actuator::ClipTable* torquewright_new_table(const double* speeds_rad_s,
                                                               const double* least_Nm,
                                                               const double* greatest_Nm,
                                                               std::size_t count, double error_Nm) {
  std::unique_ptr<actuator::ClipTable> table;
  guarded([&] {
    const actuator::ClipPoints points{{speeds_rad_s, speeds_rad_s + count},
                                      {least_Nm, least_Nm + count},
                                      {greatest_Nm, greatest_Nm + count}};
    table = std::make_unique<actuator::ClipTable>(actuator::drawn_in(points, error_Nm));
    return kAnswered;
  });
  return table.release();
}
TORQUEWRIGHT_ENTRY void torquewright_free_table(actuator::ClipTable* table) { delete table; }

/// Cuts off `count` torques at their speeds.
TORQUEWRIGHT_ENTRY void torquewright_clip(const actuator::ClipTable* table,
                                          const double* speeds_rad_s, const double* torques_Nm,
                                          double* clipped_Nm, std::size_t count) {
  actuator::clip(table->view(), speeds_rad_s, torques_Nm, clipped_Nm, count);
}
