// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/problem.hpp"
#include "gearbox/search/ranking.hpp"
#include "gearbox/search/search.hpp"
#include "gearbox/verification/verification_json.hpp"
#include "io/documents/document.hpp"
#include "src/options/optimize_request.hpp"

namespace torquewright::cli {

/// A problem, and the document that it was read from.
struct ReadProblem {
  io::Document document;
  gearbox::Problem problem;
};

/// What `gearbox optimize` found, as a document of kind gearbox_result.
std::string optimization_json(const OptimizeRequest& request, const ReadProblem& read,
                              const gearbox::DesignSearchResult& found, double seconds);

/// What is so of one design, as a document of the same kind.
std::string evaluation_json(const ReadProblem& read, const gearbox::DesignReport& report,
                            const gearbox::Standing& standing);

/// What `gearbox verify` would find of a result of a synthesis.
gearbox::Verification verified_result(const std::string& text);

/// A result as it is printed after a check: a file does not vouch for itself, what is printed does.
std::string with_verdict(const std::string& result, const gearbox::Verification& check);

/// Reads a result of `gearbox optimize`. Throws io::SpecError, for one of `gearbox evaluate` too:
/// it claims nothing that could be proved.
io::Document read_result(const std::string& file);

}  // namespace torquewright::cli
