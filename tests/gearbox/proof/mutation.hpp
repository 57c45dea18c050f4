// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace torquewright::gearbox::proof_test {

/// One change of one field of a document.
struct Mutation {
  std::string pointer;  ///< Of the field that is changed.
  std::string kind;     ///< "add 1", "drop element", ...
};

/// Changes the document in every way in turn, calls `visit` with each changed document, and leaves
/// it as it was. Every number: plus and minus one, one millionth more, zero, negated. Every
/// null: 1. Every flag: flipped. Every string: each of `words` that fits its place. Every array
/// element: dropped, doubled, swapped with the next. Every key: removed. Every object: a key added.
void for_each_mutation(nlohmann::json& document, const std::vector<std::string>& words,
                       const std::function<void(const Mutation&)>& visit);

}  // namespace torquewright::gearbox::proof_test
