// SPDX-License-Identifier: Apache-2.0
#include "io/files/kept_state.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "io/faults/refusal.hpp"
#include "io/files/file_limit.hpp"

namespace torquewright::io {

std::string read_kept_state(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) refuse_unreadable(file.string(), ENOENT);
  if (!std::filesystem::is_regular_file(status)) refuse(file.string(), "is no file");
  if (std::filesystem::file_size(file, error) > kMaxFileBytes) {
    refuse(file.string(), "is larger than any state that this program keeps");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_unreadable(file.string(), errno);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace torquewright::io
