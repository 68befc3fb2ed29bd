// SPDX-License-Identifier: BSD-3-Clause
// Joints as they are written, before they become links of a URDF.
#include <algorithm>
#include <cmath>

#include "base/findings/rules.hpp"
#include "base/numbers/vectors.hpp"
#include "base/text/quoted.hpp"
#include "mjcf/model.hpp"

namespace smurf::mjcf {
namespace {

/// Whether a range is a limit: written, or because there is one.
bool is_limited(const Settings& settings, std::string_view switch_name, std::string_view range_name,
                const std::array<double, 2>& range, const Compiler& compiler, Reporter& reporter) {
  const Attribute* written = settings.find(switch_name);
  const Auto limited = written != nullptr ? auto_of(*written, reporter) : Auto::automatic;
  if (limited != Auto::automatic) return limited == Auto::yes;
  const Attribute* attribute = settings.find(range_name);
  if (!compiler.autolimits) {
    if (attribute != nullptr && (range[0] != 0 || range[1] != 0)) {
      reporter.refuse(attribute->value_span(),
                      quoted(range_name) + " without " + quoted(switch_name) +
                          ", and the compiler has `autolimits=\"false\"`",
                      "write `" + std::string(switch_name) + "=\"true\"`");
    }
    return false;
  }
  if (attribute != nullptr && range[0] > range[1]) {
    reporter
        .report(rules::sml9305_range_without_limit, attribute->value_span(),
                quoted(range_name) + " begins above its end, so it is no limit")
        .help("write the smaller number first");
  }
  return range[0] < range[1];
}

}  // namespace

Joint read_joint(View element, const Surroundings& around, Reporter& reporter) {
  Joint joint;
  const ModelFile& file = *around.file;
  joint.file = &file;
  joint.frame = around.frame;
  const Attribute* name = element.attribute("name");
  joint.has_name = name != nullptr && !name->value().empty();
  if (joint.has_name) joint.name = around.prefix + std::string(name->value()) + around.suffix;
  if (element.name() == "freejoint") {
    joint.type = Joint::Type::free;
    joint.settings = Settings(element, nullptr);
    const Attribute* align = element.attribute("align");
    const Auto wanted = align != nullptr ? auto_of(*align, reporter) : Auto::automatic;
    joint.is_aligned =
        wanted == Auto::yes || (wanted == Auto::automatic && file.compiler().alignfree);
    return joint;
  }
  joint.settings = Settings(element, file.class_of(element, around.childclass));
  const Settings& s = joint.settings;
  if (const Attribute* type = s.find("type")) {
    constexpr std::string_view kTypes[] = {"free", "ball", "slide", "hinge"};
    joint.type = static_cast<Joint::Type>(word_of(*type, kTypes, reporter).value_or(3));
  }
  if (joint.type == Joint::Type::free) joint.is_aligned = file.compiler().alignfree;
  s.numbers("pos", joint.position, 3, reporter);
  s.numbers("axis", joint.axis, 3, reporter);
  const double size = std::sqrt(dot(joint.axis, joint.axis));
  const bool has_axis = joint.type == Joint::Type::hinge || joint.type == Joint::Type::slide;
  if (has_axis && !(size > 1e-14)) {
    reporter.refuse(s.place({"axis"}).origin, "the axis of the joint is zero",
                    "write the direction of the axis, such as `0 0 1`");
    joint.axis = {0, 0, 1};
  } else if (has_axis) {
    joint.axis = {joint.axis[0] / size, joint.axis[1] / size, joint.axis[2] / size};
  }
  const double unit = file.compiler().is_degree ? kDegree : 1;
  const double turn_unit = joint.type == Joint::Type::hinge ? unit : 1;
  joint.reference = s.number("ref", 0, reporter) * turn_unit;
  joint.springref = s.number("springref", 0, reporter) * turn_unit;
  s.numbers("range", joint.range, 2, reporter);
  if (joint.type != Joint::Type::free)
    joint.is_limited = is_limited(s, "limited", "range", joint.range, file.compiler(), reporter);
  if (joint.is_limited && joint.type == Joint::Type::ball && joint.range[0] != 0) {
    reporter.refuse(s.place({"range"}).origin, "the range of a ball joint begins at 0",
                    "write 0 and the largest angle");
  } else if (joint.is_limited && !(joint.range[0] < joint.range[1])) {
    reporter.refuse(s.place({"range"}).origin, "the joint is limited, and its range is empty",
                    "write the smaller number first, or `limited=\"false\"`");
  }
  if (joint.type == Joint::Type::hinge || joint.type == Joint::Type::ball) {
    for (double& one : joint.range) one *= unit;
  }
  std::array<double, 3> polynomial{};
  s.numbers("damping", polynomial, 1, reporter);
  joint.damping = polynomial[0];
  if (polynomial[1] != 0 || polynomial[2] != 0) {
    reporter
        .report(rules::sml9304_lost_in_urdf, s.place({"damping"}).origin,
                "a URDF has a linear damping only, so the other coefficients are lost")
        .help("write one number if the difference does not matter");
  }
  polynomial = {};
  s.numbers("stiffness", polynomial, 1, reporter);
  joint.stiffness = polynomial[0];
  if (polynomial[1] != 0 || polynomial[2] != 0) {
    reporter
        .report(rules::sml9304_lost_in_urdf, s.place({"stiffness"}).origin,
                "a spring of a URDF is linear, so the other coefficients are lost")
        .help("write one number if the difference does not matter");
  }
  joint.friction = s.number("frictionloss", 0, reporter);
  joint.armature = s.number("armature", 0, reporter);
  std::array<double, 2> force{};
  s.numbers("actuatorfrcrange", force, 2, reporter);
  if (is_limited(s, "actuatorfrclimited", "actuatorfrcrange", force, file.compiler(), reporter))
    joint.force_range = force;
  return joint;
}

}  // namespace smurf::mjcf
