// SPDX-License-Identifier: Apache-2.0
#include "src/standard_output.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "io/spec_error.hpp"

namespace torquewright::cli {
namespace {

std::string* held = nullptr;  ///< Of the HeldOutput that lives.

}  // namespace

HeldOutput::HeldOutput() { held = &text_; }
HeldOutput::~HeldOutput() { held = nullptr; }

void print_result(const std::string& text) {
  if (held != nullptr) {
    *held += text;
    return;
  }
  // A full disk may show as late as when the buffer is emptied.
  if (std::fputs(text.c_str(), stdout) != EOF && std::fflush(stdout) == 0) return;
  const std::string reason = std::generic_category().message(errno);
  throw io::SpecError({{"standard output", "", "cannot be written: " + reason}});
}

void deliver_result(const std::string& text, const std::string& file,
                    std::vector<io::FileContent> beside) {
  if (!file.empty()) beside.push_back({file, text});
  io::write_whole_files(beside);
  if (file.empty()) print_result(text);
}

}  // namespace torquewright::cli
