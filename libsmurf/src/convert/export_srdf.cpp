// SPDX-License-Identifier: BSD-3-Clause
// Joint pose sets as group states, bitmasks and neighbours as pairs that do not collide.
#include <cstdint>
#include <map>
#include <set>

#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "convert/passes.hpp"
#include "link/kinematics.hpp"
#include "smurf/convert.hpp"

namespace smurf {
namespace {

class SrdfWriter {
 public:
  SrdfWriter(const LinkedModel& model, const std::string& prefix, std::uint64_t most)
      : model_(model), prefix_(prefix), most_(most) {}

  std::optional<std::string> write() {
    out_ = "<?xml version=\"1.0\"?>\n<robot name=\"" +
           escape_xml(model_.robot->name.value_or("robot")) + "\">\n";
    group_states();
    neighbours();
    bitmasks();
    excluded();
    out_ += "</robot>\n";
    if (is_full()) return std::nullopt;
    return std::move(out_);
  }

 private:
  bool is_full() const { return out_.size() > most_; }

  std::string name(const std::string& name) const { return escape_xml(prefix_ + name); }

  std::string link_name(const std::string& link) const {
    return passes::is_world(link) ? link : name(link);
  }

  /// A state belongs to a group, so there is one of all joints.
  void group_states() {
    if (model_.annotations.poses.empty()) return;
    out_ += "  <group name=\"all\">\n";
    for (const urdf::Joint& joint : model_.robot->joints) {
      if (!joint.name || !joint.has_one_axis()) continue;
      out_ += "    <joint name=\"" + name(*joint.name) + "\"/>\n";
    }
    out_ += "  </group>\n";
    std::set<std::string_view> seen;
    for (const JointPoseSet& pose : model_.annotations.poses) {
      if (!pose.name || !seen.insert(*pose.name).second) continue;
      out_ += "  <group_state name=\"" + escape_xml(*pose.name) + "\" group=\"all\">\n";
      for (const auto& [joint, position] : to_joint_positions(model_, pose)) {
        out_ +=
            "    <joint name=\"" + name(joint) + "\" value=\"" + format_number(position) + "\"/>\n";
      }
      out_ += "  </group_state>\n";
    }
  }

  static bool has_shapes(const urdf::Link& link) { return link.name && !link.collisions.empty(); }

  void disable(const urdf::Link& a, const urdf::Link& b, const char* reason) {
    out_ += "  <disable_collisions link1=\"" + link_name(*a.name) + "\" link2=\"" +
            link_name(*b.name) + "\" reason=\"" + reason + "\"/>\n";
  }

  void neighbours() {
    for (std::size_t i = 0; i < model_.robot->joints.size(); ++i) {
      const auto parent = model_.tree.joint_parent[i];
      const auto child = model_.tree.joint_child[i];
      if (!parent || !child || *parent == *child) continue;
      if (!has_shapes(model_.link(*parent)) || !has_shapes(model_.link(*child))) continue;
      if (!neighbours_.emplace(*parent, *child).second) continue;
      disable(model_.link(*parent), model_.link(*child), "Adjacent");
    }
  }

  /// Pairs that the file of another language keeps apart.
  void excluded() {
    std::set<std::pair<LinkIndex, LinkIndex>> known;
    for (const auto& [link, other] : model_.excluded) {
      const auto a = model_.link_names.find(link);
      const auto b = model_.link_names.find(other);
      if (!a || !b || is_full()) continue;
      const auto pair = std::minmax(static_cast<LinkIndex>(*a), static_cast<LinkIndex>(*b));
      const bool is_new = !neighbours_.contains(pair) &&
                          !neighbours_.contains({pair.second, pair.first}) &&
                          known.insert(pair).second;
      if (is_new) disable(model_.link(pair.first), model_.link(pair.second), "User");
    }
  }

  /// Two links can collide when any two of their collisions share a bit.
  void bitmasks() {
    std::map<std::string_view, std::uint32_t> masks;
    for (const CollisionAnnotation& entry : model_.annotations.collisions) {
      if (entry.name && entry.bitmask) {
        masks.emplace(*entry.name, static_cast<std::uint32_t>(*entry.bitmask) & 0xFFFFU);
      }
    }
    std::map<std::uint32_t, std::vector<LinkIndex>> by_mask;
    for (std::size_t i = 0; i < model_.robot->links.size(); ++i) {
      const urdf::Link& link = model_.robot->links[i];
      if (!has_shapes(link)) continue;
      std::uint32_t mask = 0;
      for (const urdf::Collision& collision : link.collisions) {
        const auto own = collision.name ? masks.find(*collision.name) : masks.end();
        mask |= own != masks.end() ? own->second : 0xFFFFU;  // MARS: 65535 unless written
      }
      by_mask[mask].push_back(static_cast<LinkIndex>(i));
    }
    for (auto one = by_mask.begin(); one != by_mask.end(); ++one) {
      for (auto other = one; other != by_mask.end(); ++other) {
        if ((one->first & other->first) == 0) disable_all(one->second, other->second);
      }
    }
  }

  void disable_all(const std::vector<LinkIndex>& some, const std::vector<LinkIndex>& others) {
    for (const LinkIndex a : some) {
      for (const LinkIndex b : others) {
        if (is_full()) return;
        if (&some == &others && !(a < b)) continue;
        if (neighbours_.contains({a, b}) || neighbours_.contains({b, a})) continue;
        disable(model_.link(a), model_.link(b), "Never");
      }
    }
  }

  const LinkedModel& model_;
  const std::string& prefix_;
  std::uint64_t most_;
  std::string out_;
  std::set<std::pair<LinkIndex, LinkIndex>> neighbours_;  ///< parent, child
};

}  // namespace

std::optional<std::string> export_srdf(const LinkedModel& model, const std::string& prefix,
                                       std::uint64_t most) {
  return SrdfWriter(model, prefix, most).write();
}

}  // namespace smurf
