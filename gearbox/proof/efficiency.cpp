// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/efficiency.hpp"

#include "gearbox/proof/contact_ratio.hpp"

namespace torquewright::gearbox::proof {
namespace {

Interval number(std::int64_t value) { return Interval(static_cast<long>(value)); }

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
};

/// 1/z1 + 1/z2, or 1/P - 1/R: grows with S and falls with the mesh's own planet (in layer 2 grows
/// with P1), so the ends stand at corners.
Interval curvature(const Box& box, int mesh) {
  const auto at = [mesh](const Point& corner) {
    if (mesh == 0) return Interval(1) / number(corner[0]) + Interval(1) / number(corner[1]);
    return Interval(1) / number(planet(corner, mesh)) - Interval(1) / number(ring(corner, mesh));
  };
  if (mesh == 0) return hull(at(box.lower), at(box.upper));
  Point least = box.lower;
  Point greatest = box.upper;
  const auto own = static_cast<std::size_t>(mesh);
  least[own] = box.upper[own];
  greatest[own] = box.lower[own];
  return hull(at(least), at(greatest));
}

Interval mesh_efficiency(const Alternative& alternative, const Box& box, int mesh) {
  const ContactPath path = contact_path(box, mesh);
  const Rational friction = alternative.problem->friction_coefficient.value_or(Rational(0));
  return 1 - friction * pi() * curvature(box, mesh) * loss_integral(path.first, path.mate);
}

Meshes mesh_efficiencies(const Alternative& alternative, const Box& box) {
  return {mesh_efficiency(alternative, box, 0), mesh_efficiency(alternative, box, 1),
          alternative.planetary ? Interval(1) : mesh_efficiency(alternative, box, 2)};
}

/// 1/(1 + I1) = S / (2 (S + P1)): the carrier's speed per input, grows with S, falls with P1.
Interval carrier_share(const Box& box) {
  const auto at = [](std::int64_t sun, std::int64_t first) {
    return number(sun) / number(2 * (sun + first));
  };
  return hull(at(box.lower[0], box.upper[1]), at(box.upper[0], box.lower[1]));
}

/// 1/(1 - I2) = i/(1 + I1): carrier's speed per output's.
Interval carrier_per_output(const Box& box, const Interval& ratio) {
  const Interval from_ratio = ratio * carrier_share(box);
  const std::int64_t least_difference = box.lower[1] - box.upper[2];
  if (least_difference <= 0) return from_ratio;
  // P1 O / ((P1 - P2)(S + P1)) = (1 + P2/(S + P1)) / (1 - P2/P1): falls with S and P1.
  const auto at = [](std::int64_t sun, std::int64_t first, std::int64_t second) {
    return number(first) * number(sun + first + second) /
           (number(first - second) * number(sun + first));
  };
  const Interval direct = hull(at(box.upper[0], box.upper[1], box.lower[2]),
                               at(box.lower[0], box.lower[1], box.upper[2]));
  return intersection(from_ratio, direct);
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
  const Meshes mesh = mesh_efficiencies(alternative, box);
  // (1 + eta_a eta_b I1)/(1 + I1) = 1 - (1 - eta_a eta_b) I1/(1 + I1)
  const Interval first_stage = 1 - (1 - mesh.sun * mesh.fixed) * (1 - carrier_share(box));
  if (alternative.planetary) return first_stage;
  // (1 - I2)/(1 - e I2) = 1/(1 + (1 - e)(1/(1 - I2) - 1)), e = eta_b eta_c
  const Interval loss = 1 - mesh.fixed * mesh.output;
  return first_stage / (1 + loss * (carrier_per_output(box, ratio) - 1));
}

Interval backward_efficiency(const Alternative& alternative, const Box& box,
                             const Interval& ratio) {
  const Meshes mesh = mesh_efficiencies(alternative, box);
  const Interval share = carrier_share(box);
  const Interval product = mesh.sun * mesh.fixed;
  // planetary: (1 + I)/(1 + I/(eta_a eta_b)) = eta_a eta_b / (1 - (1 - eta_a eta_b)/(1 + I))
  const Interval first_stage = 1 - (1 - product) * share;
  if (alternative.planetary) return product / first_stage;
  // (e - I2)/(1 - I2) = 1 - (1 - e)/(1 - I2)
  const Interval loss = 1 - mesh.fixed * mesh.output;
  const Interval second_stage = 1 - loss * carrier_per_output(box, ratio);
  return max(mesh.sun * second_stage / (mesh.output * first_stage), 0);
}

}  // namespace torquewright::gearbox::proof
