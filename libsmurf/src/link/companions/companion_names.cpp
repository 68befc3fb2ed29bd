// SPDX-License-Identifier: BSD-3-Clause
// Sources: srdfdom model.cpp; ros2_controllers *_parameters.yaml; moveit2 robot_model_loader.cpp,
// moveit_simple_controller_manager.cpp, planning_context_manager.cpp.
#include "link/companions/companion_names.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/text/words.hpp"
#include "link/companions/parameter_names.hpp"
#include "link/reference_finder.hpp"

namespace smurf {
namespace {

void add_text(const Naming& naming, const srdf::Text& text, xml::ElementId element,
              ReferenceFinder& finder) {
  if (!text || text->empty()) return;
  finder.add(naming, *text,
             {Reference::Notation::xml_attribute, static_cast<std::uint32_t>(element), text.span,
              text.span});
}

/// All names in one SRDF.
class SrdfNames {
 public:
  SrdfNames(const srdf::Description& srdf, ReferenceFinder& finder)
      : srdf_(srdf), finder_(finder) {}

  void run() {
    for (const srdf::VirtualJoint& one : srdf_.virtual_joints) link(one.child_link, one.element);
    for (const srdf::Group& one : srdf_.groups) group(one);
    for (const srdf::GroupState& one : srdf_.states) {
      add_text({NameKind::group}, one.group, one.element, finder_);
      for (const srdf::StateJoint& value : one.joints) joint(value.name, value.element);
    }
    for (const srdf::EndEffector& one : srdf_.end_effectors) {
      link(one.parent_link, one.element);
      add_text({NameKind::group}, one.group, one.element, finder_);
      add_text({NameKind::group}, one.parent_group, one.element, finder_);
    }
    for (const srdf::PassiveJoint& one : srdf_.passive_joints) joint(one.name, one.element);
    for (const srdf::LinkPair& one : srdf_.pairs) {
      link(one.link1, one.element);
      link(one.link2, one.element);
    }
    for (const srdf::JointProperty& one : srdf_.properties) joint(one.joint, one.element);
    for (const srdf::LinkEntry& one : srdf_.links) link(one.link, one.element);
  }

 private:
  void link(const srdf::Text& name, xml::ElementId element) {
    add_text({NameKind::link}, name, element, finder_);
  }

  void joint(const srdf::Text& name, xml::ElementId element) {
    if (name && srdf_.find_virtual_joint(*name) != nullptr) return;  // not one of the URDF
    add_text({NameKind::joint}, name, element, finder_);
  }

  void group(const srdf::Group& one) {
    add_text(defines(NameKind::group), one.name, one.element, finder_);
    for (const srdf::Member& member : one.members) {
      switch (member.kind) {
      case srdf::Member::Kind::link: link(member.name, member.element); break;
      case srdf::Member::Kind::joint: joint(member.name, member.element); break;
      case srdf::Member::Kind::group:
        add_text({NameKind::group}, member.name, member.element, finder_);
        break;
      case srdf::Member::Kind::chain:
        link(member.base, member.element);
        link(member.tip, member.element);
        break;
      }
    }
  }

  const srdf::Description& srdf_;
  ReferenceFinder& finder_;
};

/// Elements that srdfdom does not read, such as `gripper` of HPP: what equals a name is one.
void add_others(const srdf::Description& srdf, ReferenceFinder& finder) {
  constexpr std::string_view kRead[] = {"virtual_joint",
                                        "group",
                                        "group_state",
                                        "end_effector",
                                        "disable_collisions",
                                        "enable_collisions",
                                        "passive_joint",
                                        "joint_property",
                                        "disable_default_collisions",
                                        "link_sphere_approximation"};
  const xml::View root = srdf.document.view();
  if (!root) return;
  for (const xml::View child : root) {
    if (std::find(std::begin(kRead), std::end(kRead), child.name()) == std::end(kRead)) {
      finder.read_extension(child);
    } else if (child.name() == "group") {
      for (const xml::View inner : child) {
        if (inner.name() == "passive_joint") finder.read_extension(inner);
      }
    }
  }
}

}  // namespace

void ReferenceFinder::read_companion(const Companion& companion) {
  if (companion.srdf) {
    add_groups(*companion.srdf);
    SrdfNames(*companion.srdf, *this).run();
    if (keeps_all()) add_others(*companion.srdf, *this);
  }
  if (companion.document) add_parameter_names(companion, *this);
}

std::vector<CompanionName> part_names(const Companion& companion) {
  const LinkedModel nothing;  // so that names count whether a robot has them or not
  std::vector<CompanionName> names;
  std::set<std::pair<NameKind, std::string_view>> seen;
  for (const Reference& one : names_in_companion(nothing, companion)) {
    const bool is_link = one.kinds.contains(NameKind::link);
    if (!is_link && !one.kinds.contains(NameKind::joint)) continue;
    const bool is_expression = one.name.find_first_of("$<{") != std::string_view::npos;
    const NameKind kind = is_link ? NameKind::link : NameKind::joint;
    if (one.is_vague || is_expression || !seen.insert({kind, one.name}).second) continue;
    names.push_back({kind, std::string(one.name)});
  }
  return names;
}

void count_names(const LinkedModel& model, Companion& companion) {
  NameScore score = score_of(part_names(companion), model);
  companion.known_names = score.known;
  companion.names = score.names;
  companion.near_names = std::move(score.near);
  companion.lost_prefix = std::move(score.lost_prefix);
}

std::vector<Reference> companion_references(const LinkedModel& model,
                                            const Companions& companions) {
  ReferenceFinder finder(model, ReferenceFinder::Keep::all);
  for (const Companion& one : companions.files) {
    if (one.srdf) finder.add_groups(*one.srdf);
  }
  for (const Companion& one : companions.files) finder.read_companion(one);
  return finder.take();
}

void ReferenceFinder::add_groups(const srdf::Description& srdf) {
  for (const srdf::Group& group : srdf.groups) {
    if (group.name) groups_.add(*group.name, static_cast<std::uint32_t>(groups_.names().size()));
  }
}

std::vector<Reference> names_in_companion(const LinkedModel& model, const Companion& companion) {
  ReferenceFinder finder(model, ReferenceFinder::Keep::all);
  finder.read_companion(companion);
  return finder.take();
}

}  // namespace smurf
