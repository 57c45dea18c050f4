// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/io/scratch_folder.hpp"

namespace torquewright::test {

/// Runs a program of Debian's Python in the folder, for files that another writer has written.
inline void run_python(const ScratchFolder& folder, const std::string& program) {
  folder.write("program.py", program);
  const std::string command =
      "cd '" + folder.path().string() + "' && /usr/bin/python3 -B program.py";
  ASSERT_EQ(std::system(command.c_str()), 0) << program;
}

}  // namespace torquewright::test
