// SPDX-License-Identifier: Apache-2.0
#include "robot/mjcf/mjcf_include.hpp"

#include <fmt/format.h>

#include <set>

namespace torquewright::hopper {
namespace {

namespace fs = std::filesystem;

class Includer {
 public:
  Includer(const fs::path& main, Faults& faults) : folder_(main.parent_path()), faults_(&faults) {
    seen_.insert(main.lexically_normal());
  }

  void expand(Element& element) {
    std::vector<Element> expanded;
    for (Element& held : element.children) {
      if (held.name == "include") {
        insert(held, expanded);
      } else {
        expand(held);
        expanded.push_back(std::move(held));
      }
    }
    element.children = std::move(expanded);
  }

 private:
  void insert(const Element& include, std::vector<Element>& out) {
    const std::string name = faults_->needed(include, "file");
    if (name.empty()) return;
    if (fs::path(name).is_absolute()) {
      faults_->report(include, fmt::format("file=\"{}\" must be a relative path", name));
      return;
    }
    const fs::path file = place_of(include, name);
    std::error_code unknown;
    if (!fs::is_regular_file(file, unknown)) {
      faults_->report(include, fmt::format("the file \"{}\" is not there", file.string()));
    } else if (!seen_.insert(file).second) {
      faults_->report(include, fmt::format("\"{}\" is included already", file.string()));
    } else {
      Element root = read_element(file);
      expand(root);
      for (Element& held : root.children) out.push_back(std::move(held));
    }
  }

  fs::path place_of(const Element& include, const std::string& name) const {
    const fs::path from_main = (folder_ / name).lexically_normal();
    std::error_code unknown;
    if (fs::exists(from_main, unknown)) return from_main;
    return (fs::path(*include.file).parent_path() / name).lexically_normal();
  }

  fs::path folder_;
  Faults* faults_;
  std::set<fs::path> seen_;
};

}  // namespace

Element read_with_includes(const fs::path& file, Faults& faults) {
  Element root = read_root(file, "mujoco");
  Includer(file, faults).expand(root);
  return root;
}

}  // namespace torquewright::hopper
