// SPDX-License-Identifier: Apache-2.0
#include "tests/layers/circles.hpp"

#include <map>

namespace torquewright::layers {
namespace {

using Graph = std::map<std::string, std::set<std::string>>;

std::string without_extension(const std::string& name) { return name.substr(0, name.rfind('.')); }

Graph graph_of(const std::vector<SourceFile>& sources) {
  Graph graph;
  for (const SourceFile& source : sources) {
    const std::string from = without_extension(source.name);
    graph[from];
    for (const Include& include : source.includes) {
      const std::string to = without_extension(include.name);
      if (include.is_quoted && to != from) graph[from].insert(to);
    }
  }
  return graph;
}

Graph reversed(const Graph& graph) {
  Graph other;
  for (const auto& [from, targets] : graph) {
    other[from];
    for (const std::string& to : targets) other[to].insert(from);
  }
  return other;
}

/// What is left when, again and again, what leads nowhere is taken away.
Graph without_ends(Graph graph) {
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (auto node = graph.begin(); node != graph.end();) {
      std::erase_if(node->second, [&](const std::string& to) { return !graph.contains(to); });
      is_changed = is_changed || node->second.empty();
      node = node->second.empty() ? graph.erase(node) : std::next(node);
    }
  }
  return graph;
}

}  // namespace

std::set<std::string> files_in_circles(const std::vector<SourceFile>& sources) {
  std::set<std::string> names;
  for (const auto& [name, targets] : without_ends(reversed(without_ends(graph_of(sources))))) {
    names.insert(name);
  }
  return names;
}

}  // namespace torquewright::layers
