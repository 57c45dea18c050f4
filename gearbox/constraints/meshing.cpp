// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/meshing.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearbox/constraints/condition.hpp"
#include "gearbox/teeth/profile_shift.hpp"

namespace torquewright::gearbox {

namespace {

bool has_mesh(std::int64_t planet, std::int64_t ring) {
  return ring > planet && ring_tip_margin(static_cast<double>(ring)) > 0.0;
}

/// Why an internal mesh does not exist.
std::string missing_mesh(std::int64_t planet, std::int64_t ring) {
  if (ring <= planet) {
    return fmt::format(
        "does not exist, a planet of {} teeth does not fit into a ring of {}; needs a "
        "larger ring.",
        planet, ring);
  }
  return fmt::format(
      "does not exist, the tip circle of a ring of {} teeth lies inside its base "
      "circle; needs at least 34 teeth or profile shift.",
      ring);
}

/// A margin of interference, which has to be at least 0.
ConstraintReport interference(DesignCondition condition, double margin, std::int64_t planet,
                              std::int64_t ring) {
  if (!has_mesh(planet, ring)) return violated_without_value(condition, missing_mesh(planet, ring));
  if (!std::isfinite(margin)) {
    return violated_without_value(
        condition,
        "does not exist, the tip circles of planet and ring do not cross; "
        "needs a ring at least 9 teeth larger than the planet.");
  }
  condition.value = fraction_of(margin);
  return judge(condition);
}

}  // namespace

ConstraintReport involute_interference(std::string_view mesh, std::int64_t planet,
                                       std::int64_t ring) {
  DesignCondition condition{fmt::format("interference.involute.{}", mesh), "", "1"};
  condition.meaning = "of the ring's size from its tip to the end of the planet's involute";
  condition.remedy = "needs a larger planet, a larger ring or a shorter ring tooth";
  return interference(
      condition,
      involute_interference_margin(static_cast<double>(planet), static_cast<double>(ring)), planet,
      ring);
}

ConstraintReport trochoid_interference(std::string_view mesh, std::int64_t planet,
                                       std::int64_t ring) {
  DesignCondition condition{fmt::format("interference.trochoid.{}", mesh), "", "rad"};
  condition.meaning = "between the tips of planet and ring where they leave each other";
  condition.remedy = fmt::format(
      "needs about 9 teeth between planet and ring, there are {}, or "
      "profile shift",
      ring - planet);
  return interference(
      condition,
      trochoid_interference_margin(static_cast<double>(planet), static_cast<double>(ring)), planet,
      ring);
}

ContactPath<double> external_path_of(std::int64_t teeth_1, std::int64_t teeth_2) {
  return external_path(static_cast<double>(teeth_1), static_cast<double>(teeth_2));
}

ContactPath<double> internal_path_of(std::int64_t planet, std::int64_t ring) {
  if (!has_mesh(planet, ring)) return {0.0, 0.0};
  return internal_path(static_cast<double>(planet), static_cast<double>(ring));
}

ConstraintReport contact_ratio_limit(const Problem& problem, std::string_view mesh, MeshKind kind,
                                     const ContactPath<double>& path) {
  DesignCondition condition{fmt::format("contact_ratio.{}", mesh), "/min_contact_ratio", "1"};
  condition.limit = problem.min_contact_ratio;
  if (path.approach == 0.0 && path.recess == 0.0) {
    return violated_without_value(condition, "does not exist: the gears do not mesh.");
  }
  condition.value = fraction_of(contact_ratio(path));
  condition.meaning = "pairs of teeth in contact on average";
  const bool is_beyond_all =
      kind == MeshKind::kExternal && problem.min_contact_ratio >= kSupremumOfExternalContactRatio;
  condition.remedy = is_beyond_all ? fmt::format(
                                         "no pair of external gears reaches {:.4f}, however many "
                                         "teeth, without longer teeth or another pressure angle",
                                         kSupremumOfExternalContactRatio)
                                   : "needs more teeth or longer teeth";
  return judge(condition);
}

ConstraintReport coaxiality(std::string_view ring_name, std::int64_t planet, std::int64_t ring,
                            std::int64_t teeth_between_centres) {
  const std::int64_t excess = ring - planet - teeth_between_centres;
  DesignCondition condition{fmt::format("coaxial.{}", ring_name), "", "teeth", Sense::kAtMost};
  condition.value = Rational(std::abs(excess));
  condition.limit = 0;
  condition.meaning = "between this ring and the coaxial one without profile shift";
  const ShiftedPair pair{MeshKind::kInternal, static_cast<double>(planet),
                         static_cast<double>(ring), 0.0, 0.0};
  const auto shift = ring > planet
                         ? closing_shift(pair, static_cast<double>(teeth_between_centres) / 2.0)
                         : std::nullopt;
  condition.remedy =
      shift ? fmt::format(
                  "needs the ring shifted by {:.4g} modules more than the planet, or {} teeth",
                  *shift, ring - excess)
            : fmt::format("no profile shift closes it, needs {} teeth", ring - excess);
  return judge(condition);
}

}  // namespace torquewright::gearbox
