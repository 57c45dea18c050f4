// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/efficiency.hpp"

#include <utility>

#include "gearbox/proof/gears/contact_ratio.hpp"
#include "gearbox/proof/gears/tooth_path.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// x |x|, which grows everywhere; its slope is 2 |x|.
Interval signed_square(const Interval& x) {
  const Interval low = x.lower();
  const Interval high = x.upper();
  return hull(low * abs(low), high * abs(high));
}

/// B(e) + B(1 - e) for e >= 0: 2 (e - 1/2)^2 + 1/2 up to 1, then 2 e - 1. No e stands in it twice
/// with different signs, so that the enclosure stays tight.
Interval double_contact_share(const Interval& part) {
  const Interval half(Rational(1, 2));
  return 2 * square(min(part, 1) - half) + half + 2 * max(part - 1, 0);
}

/// One end of the path: three pairs mesh over its last `triple`, two up to `twice`.
Interval end_share(const Interval& part, const Interval& triple, const Interval& twice) {
  const Interval inner = signed_square(part - triple);
  return (signed_square(part) - inner) / 3 + (inner - signed_square(part - twice)) / 2;
}

struct Meshes {
  Interval sun, fixed, output;  ///< Efficiencies with the carrier at rest.
  bool may_pass;                ///< Power through all of them, somewhere in the box.
  bool pass;                    ///< Everywhere.
};

/// 1/z1 + 1/z2, or 1/P - 1/R. The latter grows with S (and with P1 in layer 2) and falls with the
/// mesh's own planet, so that the ends stand at corners.
Interval curvature(const TeethRange& range, int mesh) {
  if (mesh == 0) {
    const auto at = [](const Teeth& teeth) {
      return 1 / number(teeth.sun) + 1 / number(teeth.planet_1);
    };
    return hull(at(range.least), at(range.most));
  }
  const auto at = [mesh](const Teeth& teeth) {
    return 1 / number(planet(teeth, mesh)) - 1 / number(ring(teeth, mesh));
  };
  Teeth least = range.least;
  Teeth greatest = range.most;
  if (mesh == 1) {
    std::swap(least.planet_1, greatest.planet_1);
  } else {
    std::swap(least.planet_2, greatest.planet_2);
  }
  return hull(at(least), at(greatest));
}

struct Mesh {
  Interval efficiency;  ///< Clamped to what is at least 0.
  bool may_pass;        ///< Power, somewhere in the range.
  bool passes;          ///< Everywhere.
};

/// Power passes where the ring's tip lies outside its base circle, a tooth pair is always in
/// contact, and friction does not take all of it: docs/derivations/efficiency.md.
Mesh mesh_in(const Alternative& alternative, const TeethRange& range, int mesh) {
  const ContactPath path = contact_path(range, mesh);
  const Rational friction = alternative.problem->friction_coefficient.value_or(Rational(0));
  const Interval efficiency =
      1 - friction * pi() * curvature(range, mesh) * loss_integral(path.first, path.mate);
  const Interval excess = path.first + path.mate - 1;
  const bool may_pass = (mesh == 0 || has_tip_outside_base(ring(range.most, mesh))) &&
                        !excess.certainly_negative() && !efficiency.certainly_negative();
  const bool passes = (mesh == 0 || has_tip_outside_base(ring(range.least, mesh))) &&
                      excess.certainly_positive() && efficiency.certainly_positive();
  return {max(efficiency, 0), may_pass, passes};
}

Meshes meshes_in(const Alternative& alternative, const Box& box) {
  const TeethRange range = teeth_in(box);
  Meshes result{{}, {}, 1, true, true};
  Interval* const efficiencies[] = {&result.sun, &result.fixed, &result.output};
  for (int mesh = 0; mesh <= alternative.train->layers(); ++mesh) {
    const Mesh each = mesh_in(alternative, range, mesh);
    *efficiencies[mesh] = each.efficiency;
    result.may_pass = result.may_pass && each.may_pass;
    result.pass = result.pass && each.passes;
  }
  return result;
}

/// 0 where no power passes, `value` where it does; no train gives more power than it takes.
Interval transmitted(const Meshes& mesh, const Interval& value) {
  if (!mesh.may_pass) return 0;
  const Interval share = min(max(value, 0), 1);
  return mesh.pass ? share : hull(share, 0);
}

/// 1/(1 + I1) = S / (2 (S + P1)): the carrier's speed per input, grows with S, falls with P1.
Interval carrier_share(const Box& box) {
  const auto at = [](std::int64_t sun, std::int64_t first) {
    return number(sun) / number(2 * (sun + first));
  };
  return hull(at(box.lower[0], box.upper[1]), at(box.upper[0], box.lower[1]));
}

/// 1/(1 - I2) = i/(1 + I1): carrier's speed per output's. Directly P1/d (1 + P2/(S + P1)), whose
/// factors grow with P1 and fall with S and d.
Interval carrier_per_output(const Box& box, const Interval& ratio) {
  const TeethRange range = teeth_in(box);
  const Interval from_ratio = ratio * carrier_share(box);
  const Interval least = max(number(box.lower[1]) / number(box.upper[2]), 1) *
                         (1 + number(range.least.planet_2) / number(box.upper[0] + box.upper[1]));
  const Interval most = number(box.upper[1]) / number(box.lower[2]) *
                        (1 + number(range.most.planet_2) / number(box.lower[0] + box.upper[1]));
  return intersection(from_ratio, hull(least, most));
}

}  // namespace

Interval loss_integral(const Interval& approach, const Interval& recess) {
  const Interval length = approach + recess;
  if ((2 - length).certainly_positive()) {
    return (double_contact_share(approach) + double_contact_share(recess)) / 2;
  }
  const Interval twice = min(1, length - 1);
  const Interval triple = max(length - 2, 0);
  const Interval middle = signed_square(1 - recess) + signed_square(1 - approach);
  return end_share(approach, triple, twice) + end_share(recess, triple, twice) + max(middle, 0) +
         max(-middle, 0) / 3;
}

Interval forward_efficiency(const Alternative& alternative, const Box& box, const Interval& ratio) {
  const Meshes mesh = meshes_in(alternative, box);
  // (1 + eta_a eta_b I1)/(1 + I1) = 1 - (1 - eta_a eta_b) I1/(1 + I1)
  const Interval first_stage = 1 - (1 - mesh.sun * mesh.fixed) * (1 - carrier_share(box));
  if (!alternative.train->is_stepped()) return transmitted(mesh, first_stage);
  // (1 - I2)/(1 - e I2) = 1/(1 + (1 - e)(1/(1 - I2) - 1)), e = eta_b eta_c
  const Interval loss = 1 - mesh.fixed * mesh.output;
  return transmitted(mesh, first_stage / (1 + loss * (carrier_per_output(box, ratio) - 1)));
}

Interval backward_efficiency(const Alternative& alternative, const Box& box,
                             const Interval& ratio) {
  const Meshes mesh = meshes_in(alternative, box);
  const Interval share = carrier_share(box);
  const Interval product = mesh.sun * mesh.fixed;
  // planetary: (1 + I)/(1 + I/(eta_a eta_b)) = eta_a eta_b / (1 - (1 - eta_a eta_b)/(1 + I))
  const Interval first_stage = 1 - (1 - product) * share;
  if (!alternative.train->is_stepped()) return transmitted(mesh, product / first_stage);
  // (e - I2)/(1 - I2) = 1 - (1 - e)/(1 - I2)
  const Interval loss = 1 - mesh.fixed * mesh.output;
  const Interval second_stage = 1 - loss * carrier_per_output(box, ratio);
  return transmitted(mesh, mesh.sun * second_stage / (mesh.output * first_stage));
}

}  // namespace torquewright::gearbox::proof
