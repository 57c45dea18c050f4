// SPDX-License-Identifier: Apache-2.0
#include "io/files/table_bytes.hpp"

#include <string>
#include <utility>

#include "io/files/plain_bytes.hpp"
#include "io/table_forms/gzip_bytes.hpp"
#include "io/table_forms/matlab_file.hpp"
#include "io/table_forms/numpy_archive.hpp"

namespace torquewright::io {

std::unique_ptr<ByteSource> table_bytes(const std::filesystem::path& file) {
  auto bytes = std::make_unique<PlainBytes>(file);
  const std::string first(bytes->first_bytes());
  if (begins_as_gzip(first)) return gzip_bytes(std::move(bytes), file.string());
  // These are read from many places at once.
  if (!bytes->is_plain_file()) return bytes;
  if (begins_as_numpy_archive(first)) return numpy_archive(std::move(bytes), file.string());
  if (begins_as_matlab_file(first)) return matlab_file(std::move(bytes), file.string());
  return bytes;
}

}  // namespace torquewright::io
