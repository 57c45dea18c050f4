// SPDX-License-Identifier: Apache-2.0
#include "io/faults/refusal.hpp"

#include <cerrno>
#include <system_error>

#include "io/faults/spec_error.hpp"

namespace torquewright::io {

void refuse(const std::string& file, const std::string& message) {
  throw SpecError({{file, "", message}});
}

void refuse_unreadable(const std::string& file, int error) {
  if (error == ENOENT) refuse(file, "no such file");
  refuse(file, "cannot be read: " + std::generic_category().message(error));
}

void refuse_output(const std::filesystem::path& file, const std::string& why) {
  refuse(file.string(), "cannot be written: " + why);
}

}  // namespace torquewright::io
