// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "tests/gearbox/proof/plain_gearbox.hpp"

namespace torquewright::gearbox::proof_test {

using Json = nlohmann::json;

struct PlainDesign {
  Gears gears;
  long planet_count;
  double module_mm;
};

/// A claim in plain words (docs/certificate.md).
struct PlainClaim {
  const Problem* problem;
  std::string kind;
  std::vector<std::string> hypotheses;
  std::string quantity;  ///< Empty: none.
  std::optional<PlainDesign> reference;
  std::vector<PlainDesign> listed;
  std::string key;                   ///< Of a least relaxation.
  long ring_limit = 0;               ///< 0: the rotor's bore sets it.
  std::optional<double> bound = {};  ///< Of open leaves.
};

/// sun, planet_1, difference; planetary: sun, planet, 0.
using PlainPoint = std::array<long, 3>;
struct PlainBox {
  PlainPoint lower, upper;
  long size() const;
};

Choice choice_of(const PlainDesign& design, const Problem& problem);
Gears gears_at(const PlainPoint& point);
std::vector<std::string> variables(const Problem& problem);
PlainBox root_box(const PlainClaim& claim, const Choice& choice);

/// -1, 0, 1: worse than, as good as, better than the reference.
int against_reference(const PlainClaim& claim, const Choice& choice, const Gears& gears);

/// Whether the claim lets the point be.
bool allowed(const PlainClaim& claim, const Choice& choice, const PlainPoint& point);

/// The concave h_c of docs/certificate.md in doubles, at a real point of a box.
double concave_form(const std::string& condition, const PlainClaim& claim, const Choice& choice,
                    const PlainBox& box, const std::array<double, 3>& x);

struct ProofStyle {
  long leaf_points = 64;
  bool root_cuts = true;
  bool relaxations = false;  ///< Tries random multipliers on boxes before splitting them.
};

/// A proof found without any cleverness: split the widest variable until a box is refuted by one
/// condition at all its corners, or is small. `alternatives` of the claim.
Json naive_alternatives(const PlainClaim& claim, const ProofStyle& style);

/// The whole claim as JSON.
Json naive_claim(const PlainClaim& claim, const ProofStyle& style);

Json design_json(const PlainDesign& design, const Problem& problem);

}  // namespace torquewright::gearbox::proof_test
