// SPDX-License-Identifier: Apache-2.0
#include "io/files/given_once.hpp"

#include <fmt/format.h>

#include <set>

#include "io/faults/refusal.hpp"

namespace torquewright::io {

void require_each_once(const std::string& option, const std::vector<std::string>& values,
                       char mark) {
  std::set<std::string> names;
  for (const std::string& value : values) {
    const std::string name = value.substr(0, value.find(mark));
    if (!names.insert(name).second) refuse(option, fmt::format("\"{}\" is given twice", name));
  }
}

}  // namespace torquewright::io
