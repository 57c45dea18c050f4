// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/mutation.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

namespace torquewright::fuzz {
namespace {

using nlohmann::json;

/// 0 <= index < size. Not a std distribution: those differ between libraries.
std::size_t below(std::size_t size, Random& random) { return random() % size; }

template <typename Entry, std::size_t size>
const Entry& any_of(const Entry (&entries)[size], Random& random) {
  return entries[below(size, random)];
}

const std::string kTokens[] = {"NaN",
                               "-Infinity",
                               "1e400",
                               "1e-400",
                               "-0",
                               "9223372036854775808",
                               "1e308",
                               "\"\\ud800\"",
                               "\"\\u0000\"",
                               "\xFF",
                               "\xEF\xBB\xBF",
                               std::string(1, '\0'),
                               "[[[[[[[[",
                               "}}",
                               "{\"a\":",
                               "null",
                               ",",
                               "//",
                               "\"kind\": \"gearbox\",",
                               "\"assumed\": [\"/a/-\", \"\", \"/~2\", \"x\"],"};

void change_bytes(std::string& text, Random& random) {
  const std::size_t at = below(text.size() + 1, random);
  const std::size_t length = 1 + below(12, random);
  switch (below(5, random)) {
    case 0:
      if (at < text.size()) text[at] = static_cast<char>(random());
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, any_of(kTokens, random));
      break;
    case 3:
      text.insert(at, text.substr(at, length));
      break;
    default:
      text.resize(at);
  }
}

const json kValues[] = {
    nullptr,      true,      0,         -1,      1,      2.5,           1e300,          1e-300,
    4000000000,   "",        "3k",      "/kind", "\x01", json::array(), json::object(), {1, 1},
    {{"sun", 1}}, INT64_MIN, UINT64_MAX};

/// A container or a value somewhere in the document.
json& any_place(json& root, Random& random) {
  json* place = &root;
  while (place->is_structured() && !place->empty() && below(4, random) != 0) {
    place = &*std::next(place->begin(), static_cast<std::ptrdiff_t>(below(place->size(), random)));
  }
  return *place;
}

json& any_leaf(json& root, Random& random) {
  json* place = &root;
  while (place->is_structured() && !place->empty()) {
    place = &*std::next(place->begin(), static_cast<std::ptrdiff_t>(below(place->size(), random)));
  }
  return *place;
}

/// A value near the one that stands there, of the same type: what a schema lets pass.
void nudge(json& root, Random& random) {
  json& leaf = any_leaf(root, random);
  if (leaf.is_number_integer()) {
    // Unsigned, since that may run over.
    leaf = static_cast<std::int64_t>(leaf.get<std::uint64_t>() + below(5, random) - 2);
  } else if (leaf.is_number_float()) {
    const double factors[] = {1 + 1e-6, 1 - 1e-6, 0.99, 1.01, 0.5, 2, -1};
    leaf = leaf.get<double>() * any_of(factors, random);
  } else if (leaf.is_boolean()) {
    leaf = !leaf.get<bool>();
  } else if (leaf.is_string()) {
    const json& other = any_leaf(root, random);
    if (other.is_string()) leaf = std::string(other);
  }
}

void change_structure(json& root, Random& random) {
  json& place = any_place(root, random);
  const bool is_filled = place.is_structured() && !place.empty();
  switch (below(5, random)) {
    case 0:
      place = any_of(kValues, random);
      break;
    case 1: {
      const json elsewhere = any_place(root, random);
      place = elsewhere;
      break;
    }
    case 2:
      if (is_filled) place.erase(place.begin());
      break;
    case 3:
      if (place.is_object()) place["sunn"] = any_of(kValues, random);
      if (place.is_array()) place.push_back(any_of(kValues, random));
      break;
    default:
      for (std::size_t depth = below(300, random); depth > 0; --depth) {
        place = json::array({std::move(place)});
      }
  }
}

}  // namespace

std::string mutated(const std::vector<std::string>& corpus, Random& random) {
  std::string text = corpus[below(corpus.size(), random)];
  json root = json::parse(text, nullptr, false);
  if (!root.is_discarded() && below(3, random) != 0) {
    const bool gently = below(2, random) == 0;
    for (std::size_t count = 1 + below(gently ? 2 : 4, random); count > 0; --count) {
      gently ? nudge(root, random) : change_structure(root, random);
    }
    text = root.dump(-1, ' ', false, json::error_handler_t::replace);
    if (below(4, random) != 0) return text;
  }
  for (std::size_t count = 1 + below(6, random); count > 0; --count) change_bytes(text, random);
  return text;
}

}  // namespace torquewright::fuzz
