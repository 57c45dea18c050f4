// SPDX-License-Identifier: Apache-2.0
#include "src/report/turning/view_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <bit>
#include <tuple>

#include "src/report/parts/base64.hpp"
#include "src/report/parts/page_json.hpp"
#include "src/report/parts/page_parts.hpp"
#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

using Eigen::Vector3d;

std::string list(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ","));
}

std::string numbers(const Vector3d& point) {
  return fmt::format("{:.6g},{:.6g},{:.6g}", point.x(), point.y(), point.z());
}

std::string shape_keys(const BodyShape& shape) {
  std::vector<std::string> capsules;
  for (const DrawnCapsule& capsule : shape.capsules) {
    capsules.push_back(fmt::format("[{},{},{:.4g}]", numbers(capsule.from_m), numbers(capsule.to_m),
                                   capsule.radius_m));
  }
  std::vector<std::string> boxes;
  if (shape.box) {
    const DrawnBox& box = *shape.box;
    boxes.push_back(fmt::format("{{\"at\":[{}],\"half\":[{}],\"axes\":[{},{},{}]}}",
                                numbers(box.center_m), numbers(box.half_m),
                                numbers(box.axes.col(0)), numbers(box.axes.col(1)),
                                numbers(box.axes.col(2))));
  }
  return fmt::format("\"capsules\":{},\"boxes\":{}", list(capsules), list(boxes));
}

std::string told_list(const std::vector<ToldValue>& told) {
  std::vector<std::string> items;
  for (const ToldValue& value : told) {
    items.push_back(fmt::format("{{\"words\":{},\"column\":{},\"unit\":{}}}",
                                json_in_page(value.words), json_in_page(value.column),
                                json_in_page(value.unit)));
  }
  return list(items);
}

std::string bodies(const hopper::Robot& robot, const TurningView& view) {
  std::vector<std::string> items;
  for (std::size_t body = 0; body < view.shapes.size(); ++body) {
    items.push_back(fmt::format("{{\"name\":{},{},\"told\":{}}}",
                                json_in_page(robot.tree.bodies[body].name),
                                shape_keys(view.shapes[body]), told_list(view.told[body])));
  }
  return fmt::format("[{}]", fmt::join(items, ",\n"));
}

std::string contacts(const hopper::Robot& robot, const TurningView& view) {
  std::vector<std::string> items;
  for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
    const hopper::ContactPoint& contact = robot.contacts[i];
    const ForceColumns force = i < view.forces.size() ? view.forces[i] : ForceColumns{};
    items.push_back(fmt::format(
        "{{\"name\":{},\"body\":{},\"at\":[{}],\"ball_m\":{:.4g},\"x\":{},\"y\":{},\"z\":{}}}",
        json_in_page(contact.name), contact.point.body, numbers(contact.point.p_B_m),
        contact.radius_m, json_in_page(force.x), json_in_page(force.y), json_in_page(force.z)));
  }
  return list(items);
}

/// Numbers one after the other, each with its lowest byte first.
template <typename Matrix>
std::string packed(const Matrix& values) {
  using Scalar = typename Matrix::Scalar;
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(values.size()) * sizeof(Scalar));
  for (const Scalar value : values.reshaped()) {
    const auto all = std::bit_cast<std::array<char, sizeof(Scalar)>>(value);
    if constexpr (std::endian::native == std::endian::little) {
      bytes.append(all.begin(), all.end());
    } else {
      bytes.append(all.rbegin(), all.rend());
    }
  }
  return base64(bytes);
}

std::string poses(const BodyPoses& of) {
  return fmt::format("{{\"places\":\"{}\",\"turns\":\"{}\"}}", packed(of.places_m),
                     packed(of.turns));
}

/// Steps of the ground, where it has some.
std::string steps(const simulation::GroundProfile& profile) {
  if (profile.is_flat()) return "";
  return fmt::format("\"edges_m\":[{:.6g}],\"heights_m\":[{:.6g}],",
                     fmt::join(profile.edges_x_m, ","), fmt::join(profile.heights_m, ","));
}

std::string canvas(const std::string& robot_name) {
  std::string text = fmt::format(
      "<div class=\"view\" hidden>\n<canvas tabindex=\"0\" role=\"img\" aria-label=\"{} in three "
      "dimensions, at the time of the cursor. Arrow keys turn it, plus and minus zoom.\"></canvas>"
      "\n<div class=\"hover\" hidden></div>\n<div class=\"row\" role=\"group\" aria-label=\"Where "
      "one looks from\">\n",
      escaped(robot_name));
  for (const auto& [look, said, words] : {std::tuple{"turned", "Turned a little", "Turned"},
                                          {"side", "From the side", "Side"},
                                          {"front", "From the front", "Front"},
                                          {"above", "From above", "Above"},
                                          {"+", "Nearer", "+"},
                                          {"-", "Farther", "&#8722;"}}) {
    text += fmt::format("<button type=\"button\" data-look=\"{}\" aria-label=\"{}\">{}</button>\n",
                        look, said, words);
  }
  return text +
         "</div>\n</div>\n<p class=\"soft no-webgl\" hidden>This browser has no WebGL: the robot "
         "is "
         "shown from the side alone.</p>\n";
}

std::string view_words(const TurningView& view) {
  return fmt::format(
      "Drag to turn, click and roll the wheel to zoom, point at a body for its values. Lines on "
      "the "
      "ground: every {:g} m. How bodies look is not known: they are drawn as thick as their mass "
      "is "
      "at 2 kg a litre.",
      grid_m(view));
}

}  // namespace

std::string view_json(const hopper::Robot& robot, const TurningView& view) {
  return fmt::format(
      "{{\"bodies\":{},\n\"contacts\":{},\n\"ground_m\":{:.6g},{}\"grid_m\":{:.6g},\"size_m\":{:."
      "6g},"
      "\"radius_m\":{:.6g},\"centre_m\":[{}],\"follows\":{},\n\"is\":{}{}}}",
      bodies(robot, view), contacts(robot, view), view.ground_m, steps(view.profile), grid_m(view),
      view.size_m, view.radius_m, numbers(view.center_m), view.follows, poses(view.is),
      view.planned ? ",\n\"planned\":" + poses(*view.planned) : "");
}

std::string view_figure(const std::string& robot_name, const TurningView& view,
                        const std::string& from_the_side, const std::string& keys) {
  return "<figure class=\"turning\">\n" + canvas(robot_name) + from_the_side + legend(keys) +
         (view.follows ? "<p class=\"soft\">The view goes along with the robot.</p>\n" : "") +
         fmt::format("<p class=\"soft view-words\" hidden>{}</p>\n</figure>\n", view_words(view));
}

}  // namespace torquewright::report
