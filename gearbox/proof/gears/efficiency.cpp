// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/efficiency.hpp"

#include <utility>

#include "gearbox/proof/gears/contact_ratio.hpp"
#include "gearbox/proof/gears/tooth_path.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// x |x|, which grows everywhere; its slope is 2 |x|.
template <typename Number>
Number signed_square(const Number& x) {
  const Number low = x.lower();
  const Number high = x.upper();
  return hull(low * abs(low), high * abs(high));
}

/// B(e) + B(1 - e) for e >= 0: 2 (e - 1/2)^2 + 1/2 up to 1, then 2 e - 1. No e stands in it twice
/// with different signs, so that the enclosure stays tight.
template <typename Number>
Number double_contact_share(const Number& part) {
  const Number half = Number(1) / 2;
  return 2 * square(min(part, 1) - half) + half + 2 * max(part - 1, 0);
}

/// One end of the path: three pairs mesh over its last `triple`, two up to `twice`.
template <typename Number>
Number end_share(const Number& part, const Number& triple, const Number& twice) {
  const Number inner = signed_square<Number>(part - triple);
  return (signed_square(part) - inner) / 3 + (inner - signed_square<Number>(part - twice)) / 2;
}

template <typename Number>
struct Meshes {
  Number sun, fixed, output;  ///< Efficiencies with the carrier at rest.
  bool may_pass;              ///< Power through all of them, somewhere in the box.
  bool pass;                  ///< Everywhere.
};

/// 1/z1 + 1/z2, or 1/P - 1/R. The latter grows with S (and with P1 in layer 2) and falls with the
/// mesh's own planet, so that the ends stand at corners.
template <typename Number>
Number curvature(const TeethRange& range, int mesh) {
  if (mesh == 0) {
    const auto at = [](const Teeth& teeth) {
      return 1 / number<Number>(teeth.sun) + 1 / number<Number>(teeth.planet_1);
    };
    return hull(at(range.least), at(range.most));
  }
  const auto at = [mesh](const Teeth& teeth) {
    return 1 / number<Number>(planet(teeth, mesh)) - 1 / number<Number>(ring(teeth, mesh));
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

template <typename Number>
struct Mesh {
  Number efficiency;  ///< Clamped to what is at least 0.
  bool may_pass;      ///< Power, somewhere in the range.
  bool passes;        ///< Everywhere.
};

/// Power passes where the ring's tip lies outside its base circle, a tooth pair is always in
/// contact, and friction does not take all of it: docs/derivations/efficiency.md.
template <typename Number>
Mesh<Number> mesh_in(const Alternative& alternative, const TeethRange& range, int mesh) {
  static const Number half_turn = pi();
  const ContactPath<Number> path = contact_path<Number>(range, mesh);
  const Number friction = alternative.problem->friction_coefficient.value_or(Rational(0));
  const Number efficiency = 1 - friction * half_turn * curvature<Number>(range, mesh) *
                                    loss_integral(path.first, path.mate);
  const Number excess = path.first + path.mate - 1;
  const bool may_pass = (mesh == 0 || has_tip_outside_base(ring(range.most, mesh))) &&
                        !excess.certainly_negative() && !efficiency.certainly_negative();
  const bool passes = (mesh == 0 || has_tip_outside_base(ring(range.least, mesh))) &&
                      excess.certainly_positive() && efficiency.certainly_positive();
  return {max(efficiency, 0), may_pass, passes};
}

template <typename Number>
Meshes<Number> meshes_in(const Alternative& alternative, const Box& box) {
  const TeethRange range = teeth_in(box);
  Meshes<Number> result{{}, {}, 1, true, true};
  Number* const efficiencies[] = {&result.sun, &result.fixed, &result.output};
  for (int mesh = 0; mesh <= alternative.train->layers(); ++mesh) {
    const auto each = mesh_in<Number>(alternative, range, mesh);
    *efficiencies[mesh] = each.efficiency;
    result.may_pass = result.may_pass && each.may_pass;
    result.pass = result.pass && each.passes;
  }
  return result;
}

/// 0 where no power passes, `value` where it does; no train gives more power than it takes.
template <typename Number>
Number transmitted(const Meshes<Number>& mesh, const Number& value) {
  if (!mesh.may_pass) return 0;
  const Number share = min(max(value, 0), 1);
  return mesh.pass ? share : hull(share, 0);
}

/// 1/(1 + I1) = S / (2 (S + P1)): the carrier's speed per input, grows with S, falls with P1.
template <typename Number>
Number carrier_share(const Box& box) {
  const auto at = [](std::int64_t sun, std::int64_t first) {
    return number<Number>(sun) / number<Number>(2 * (sun + first));
  };
  return hull(at(box.lower[0], box.upper[1]), at(box.upper[0], box.lower[1]));
}

/// 1/(1 - I2) = i/(1 + I1): carrier's speed per output's. Directly P1/d (1 + P2/(S + P1)), whose
/// factors grow with P1 and fall with S and d.
template <typename Number>
Number carrier_per_output(const Box& box, const Number& ratio) {
  const TeethRange range = teeth_in(box);
  const auto of = [](std::int64_t value) { return number<Number>(value); };
  const Number from_ratio = ratio * carrier_share<Number>(box);
  const Number least = max(of(box.lower[1]) / of(box.upper[2]), 1) *
                       (1 + of(range.least.planet_2) / of(box.upper[0] + box.upper[1]));
  const Number most = of(box.upper[1]) / of(box.lower[2]) *
                      (1 + of(range.most.planet_2) / of(box.lower[0] + box.upper[1]));
  return intersection(from_ratio, hull(least, most));
}

}  // namespace

template <typename Number>
Number loss_integral(const Number& approach, const Number& recess) {
  const Number length = approach + recess;
  if ((2 - length).certainly_positive()) {
    return (double_contact_share(approach) + double_contact_share(recess)) / 2;
  }
  const Number twice = min(1, length - 1);
  const Number triple = max(length - 2, 0);
  const Number middle = signed_square<Number>(1 - recess) + signed_square<Number>(1 - approach);
  return end_share(approach, triple, twice) + end_share(recess, triple, twice) + max(middle, 0) +
         max(-middle, 0) / 3;
}

template <typename Number>
Number forward_efficiency(const Alternative& alternative, const Box& box, const Number& ratio) {
  const auto mesh = meshes_in<Number>(alternative, box);
  // (1 + eta_a eta_b I1)/(1 + I1) = 1 - (1 - eta_a eta_b) I1/(1 + I1)
  const Number first_stage = 1 - (1 - mesh.sun * mesh.fixed) * (1 - carrier_share<Number>(box));
  if (!alternative.train->is_stepped()) return transmitted(mesh, first_stage);
  // (1 - I2)/(1 - e I2) = 1/(1 + (1 - e)(1/(1 - I2) - 1)), e = eta_b eta_c
  const Number loss = 1 - mesh.fixed * mesh.output;
  return transmitted<Number>(mesh, first_stage / (1 + loss * (carrier_per_output(box, ratio) - 1)));
}

template <typename Number>
Number backward_efficiency(const Alternative& alternative, const Box& box, const Number& ratio) {
  const auto mesh = meshes_in<Number>(alternative, box);
  const Number share = carrier_share<Number>(box);
  const Number product = mesh.sun * mesh.fixed;
  // planetary: (1 + I)/(1 + I/(eta_a eta_b)) = eta_a eta_b / (1 - (1 - eta_a eta_b)/(1 + I))
  const Number first_stage = 1 - (1 - product) * share;
  if (!alternative.train->is_stepped()) return transmitted<Number>(mesh, product / first_stage);
  // (e - I2)/(1 - I2) = 1 - (1 - e)/(1 - I2)
  const Number loss = 1 - mesh.fixed * mesh.output;
  const Number second_stage = 1 - loss * carrier_per_output(box, ratio);
  return transmitted<Number>(mesh, mesh.sun * second_stage / (mesh.output * first_stage));
}

template Interval loss_integral(const Interval&, const Interval&);
template RoughInterval loss_integral(const RoughInterval&, const RoughInterval&);
template Interval forward_efficiency(const Alternative&, const Box&, const Interval&);
template RoughInterval forward_efficiency(const Alternative&, const Box&, const RoughInterval&);
template Interval backward_efficiency(const Alternative&, const Box&, const Interval&);
template RoughInterval backward_efficiency(const Alternative&, const Box&, const RoughInterval&);

}  // namespace torquewright::gearbox::proof
