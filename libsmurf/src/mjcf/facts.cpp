// SPDX-License-Identifier: BSD-3-Clause
// What actuators and equalities say about joints; what a URDF cannot say of them is a loss at its
// place.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "mjcf/robot.hpp"

namespace smurf::mjcf {
namespace {

class Facts {
 public:
  Facts(const Model& model, Reporter& reporter)
      : model_(model), reporter_(reporter), parts_(model) {}

  JointFacts run() {
    for (const Reference& one : model_.sections) {
      const std::string_view section = one.section;
      if (section == "equality") equality(one);
      if (section == "actuator") actuator(one);
      if (section == "tendon") lost(one.element, "tendons", "lost tendons");
      if (section == "deformable") lost(one.element, "soft bodies", "lost soft bodies");
    }
    contacts();
    return std::move(facts_);
  }

 private:
  void lost(View element, const std::string& what, std::string_view others) {
    reporter_.lose(element.name_span(), "a URDF has no " + what + ", so this one is lost", others)
        .help("keep the MJCF for it");
  }

  /// All of them are one finding, since there are often hundreds.
  void contacts() {
    std::size_t pairs = 0;
    View first_excluded, first_pair;
    for (const Reference& one : model_.sections) {
      if (one.section != "contact") continue;
      if (one.element.name() == "pair" && pairs++ == 0) first_pair = one.element;
      if (one.element.name() != "exclude") continue;
      const auto first = parts_.body(one.element.attribute("body1"), one.around);
      const auto second = parts_.body(one.element.attribute("body2"), one.around);
      if (!first || !second) continue;
      if (facts_.excluded.empty()) first_excluded = one.element;
      facts_.excluded.emplace_back(model_.bodies[*first].name, model_.bodies[*second].name);
    }
    const auto said = [](std::size_t count) {
      return count == 1 ? "this one is" : "these " + std::to_string(count) + " are";
    };
    if (!facts_.excluded.empty()) {
      reporter_
          .report(rules::sml9304_lost_in_urdf, first_excluded.name_span(),
                  "a URDF has no pairs of links that do not touch, so " +
                      said(facts_.excluded.size()) + " lost in it")
          .help("write an SRDF as well: --srdf; urdf2smurf does");
    }
    if (pairs == 0) return;
    reporter_
        .report(rules::sml9304_lost_in_urdf, first_pair.name_span(),
                "a URDF has no contacts of two shapes, so " + said(pairs) + " lost")
        .help("keep the MJCF for them");
  }

  /// Copies of a joint take the references to it with them.
  std::vector<const Joint*> copies(const Attribute& name, const Surroundings& around) const {
    std::vector<const Joint*> all;
    for (const Body& body : model_.bodies) {
      for (const Joint& one : body.joints) {
        const Attribute* own = one.settings.element().attribute("name");
        if (own != nullptr && own->value() == name.value() && one.file == around.file &&
            one.name.starts_with(around.prefix))
          all.push_back(&one);
      }
    }
    return all;
  }

  void equality(const Reference& one) {
    const View element = one.element;
    const DefaultClass* of_class = one.around.file->find_class("main");
    if (const Attribute* written = element.attribute("class"))
      of_class = one.around.file->find_class(written->value());
    bool is_active = true;
    if (of_class != nullptr) {
      const auto found = of_class->elements.find("equality");
      if (found != of_class->elements.end()) {
        for (const Attribute* attribute : found->second) {
          if (attribute->name() == "active") is_active = attribute->value() != "false";
        }
      }
    }
    if (const Attribute* active = element.attribute("active"))
      is_active = truth_of(*active, reporter_).value_or(true);
    if (!is_active) return;
    if (element.name() == "connect" || element.name() == "weld") {
      if (auto loop = closed_loop(model_, parts_, one, Settings(element, of_class), reporter_)) {
        facts_.loops.push_back(std::move(*loop));
        return;
      }
      const std::string ends = end_of(element, "1") + " and " + end_of(element, "2");
      reporter_
          .report(rules::sml9304_lost_in_urdf, element.name_span(),
                  "a URDF is a tree, and " + quoted(element.name()) + " of " + ends +
                      " closes a loop whose ends do not meet at zero, so it is lost")
          .help("keep the MJCF for it");
      return;
    }
    if (element.name() != "joint") {
      return lost(element, "equality of this kind", "lost equalities");
    }
    const Attribute* first = element.attribute("joint1");
    const Joint* follower = parts_.joint(first, one.around);
    if (follower == nullptr) return;
    std::array<double, 5> coefficients{0, 1, 0, 0, 0};
    const Settings s(element, of_class);
    s.numbers("polycoef", coefficients, 1, reporter_);
    const Attribute* second = element.attribute("joint2");
    const Joint* leader = parts_.joint(second, one.around);
    if (second != nullptr && leader == nullptr) return;
    if (leader == nullptr) {
      reporter_
          .lose(element.name_span(), "a joint of a URDF cannot be held at a value, so this is lost",
                "held joints")
          .help("delete the joint, so that its body is fixed");
      return;
    }
    if (coefficients[2] != 0 || coefficients[3] != 0 || coefficients[4] != 0) {
      reporter_
          .report(
              rules::sml9304_lost_in_urdf, s.place({"polycoef"}).origin,
              "a joint of a URDF follows another in proportion, so the other coefficients, and the coupling, are lost")
          .help("write two coefficients if the difference does not matter");
      return;
    }
    Follower result;
    result.leader = leader->name;
    result.multiplier = coefficients[1];
    result.offset = follower->reference + coefficients[0] - coefficients[1] * leader->reference;
    result.element = element;
    facts_.followers.emplace(follower->name, result);
  }

  static std::string end_of(View element, std::string_view number) {
    for (const std::string_view kind : {"body", "site"}) {
      const Attribute* name = element.attribute(std::string(kind) + std::string(number));
      if (name != nullptr) return quoted(name->value());
    }
    return "the world";
  }

  void actuator(const Reference& one) {
    const Attribute* name = one.element.attribute("joint");
    if (name == nullptr) name = one.element.attribute("jointinparent");
    if (name == nullptr) {
      for (const std::string_view target : {"tendon", "site", "body", "slidersite", "cranksite"}) {
        if (one.element.attribute(target) == nullptr) continue;
        reporter_
            .lose(one.element.name_span(),
                  "a motor of SMURF moves a joint, not a " + std::string(target) +
                      ", so this actuator is lost",
                  "lost actuators")
            .help("keep the MJCF for it");
        return;
      }
      if (one.element.name() != "plugin")
        reporter_.refuse(one.element.name_span(), "the actuator moves nothing", "write `joint`");
      return;
    }
    std::vector<const Joint*> moved;
    if (const Joint* single = parts_.joint(name, one.around)) {
      moved.push_back(single);
    } else {
      moved = copies(*name, one.around);
    }
    const Settings s = settings_of_actuator(one);
    const auto range = effort_range_of(s, reporter_);
    if (!range) return;
    const double effort = std::max(std::fabs((*range)[0]), std::fabs((*range)[1]));
    for (const Joint* each : moved)
      facts_.efforts.emplace(each->name,
                             std::pair{effort, s.place({"forcerange", "ctrlrange", "gear"})});
  }

  const Model& model_;
  Reporter& reporter_;
  PartsByName parts_;
  JointFacts facts_;
};

}  // namespace

JointFacts facts_of_joints(const Model& model, Reporter& reporter) {
  return Facts(model, reporter).run();
}

}  // namespace smurf::mjcf
