// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/own_contacts.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "link/link_overlaps.hpp"
#include "write/parts/contacts.hpp"
#include "write/parts/gazebo_elements.hpp"
#include "write/parts/scene_parts.hpp"

namespace smurf {
namespace {

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

std::string name_of(const LinkedModel& model, std::size_t link) {
  return model.robot->links[link].name.value_or("a link without name");
}

/// "`a` and `b` by 12 mm, ..." and the number of more.
std::string list(const LinkedModel& model, std::vector<LinkOverlap> overlaps) {
  constexpr std::size_t kListed = 5;
  std::stable_sort(overlaps.begin(), overlaps.end(),
                   [](const LinkOverlap& a, const LinkOverlap& b) { return a.depth > b.depth; });
  std::vector<std::string> all;
  for (const LinkOverlap& one : overlaps) {
    all.push_back(quoted(name_of(model, one.link)) + " and " + quoted(name_of(model, one.other)) +
                  " by " + format_rounded(1000 * one.depth, 3) + " mm");
  }
  return shortlist(all, kListed, "more pair", "more pairs");
}

/// The overlaps at the start poses of all instances of a model.
std::vector<LinkOverlap> overlaps_at_start(const LinkedModel& model, const LinkedScene& scene,
                                           const FlatScene& flat) {
  constexpr double kLeast = 1e-4;  // m
  constexpr std::size_t kMostPoses = 20;
  std::set<JointPoseIndex> poses;
  for (std::size_t i = 0; i < flat.instances.size(); ++i) {
    if (scene.model(scene.instances[i]) == &model) poses.insert(flat.instances[i].joint_pose);
  }
  LinkOverlaps finder(model);
  std::map<std::pair<std::size_t, std::size_t>, LinkOverlap> deepest;
  std::size_t count = 0;
  for (const JointPoseIndex pose : poses) {
    if (++count > kMostPoses) break;
    for (const LinkOverlap& one : finder.find(flat.joint_poses[to_size(pose)], kLeast)) {
      const auto [known, is_new] = deepest.try_emplace({one.link, one.other}, one);
      if (!is_new && known->second.depth < one.depth) known->second = one;
    }
  }
  std::vector<LinkOverlap> overlaps;
  for (const auto& [links, overlap] : deepest) overlaps.push_back(overlap);
  return overlaps;
}

/// The links whose collisions share no bit. Shapes without a bitmask touch all that have one, as in
/// MARS.
Pairs separated_by_bits(const LinkedModel& model) {
  constexpr std::int64_t kAllBits = 0x7fffffff;
  const CollisionContacts contacts(model);
  std::map<std::size_t, std::vector<std::int64_t>> masks;
  bool has_masks = false;
  for (std::size_t i = 0; i < model.robot->links.size(); ++i) {
    const urdf::Link& link = model.robot->links[i];
    for (const urdf::Collision& collision : link.collisions) {
      const std::optional<std::int64_t> mask = contacts.of(collision, link).bitmask;
      has_masks = has_masks || mask;
      masks[i].push_back(mask.value_or(kAllBits) & kAllBits);
    }
  }
  Pairs pairs;
  if (!has_masks) return pairs;
  const auto share_bits = [](const auto& some, const auto& others) {
    return ranges::any_of(some, [&](std::int64_t one) {
      return ranges::any_of(others, [&](std::int64_t other) { return (one & other) != 0; });
    });
  };
  for (auto one = masks.begin(); one != masks.end(); ++one) {
    for (auto other = std::next(one); other != masks.end(); ++other) {
      if (!share_bits(one->second, other->second)) pairs.emplace(one->first, other->first);
    }
  }
  return pairs;
}

/// Links that are one body with a neighbour, or neighbours of such links, but that no joint
/// connects: readers keep only those apart that a joint connects.
Pairs distant_neighbours(const LinkedModel& model) {
  const std::vector<std::size_t> bodies = bodies_of(model);
  const KinematicTree& tree = model.tree;
  Pairs joined;
  for (std::size_t i = 0; i < tree.joint_parent.size(); ++i) {
    const auto child = carried_link(model, i);
    if (!tree.joint_parent[i] || !child) continue;
    joined.insert(std::minmax<std::size_t>(to_size(*tree.joint_parent[i]), *child));
  }
  const auto& links = model.robot->links;
  Pairs pairs;
  for (std::size_t a = 0; a < links.size(); ++a) {
    if (links[a].collisions.empty()) continue;
    for (std::size_t b = a + 1; b < links.size(); ++b) {
      if (links[b].collisions.empty() || joined.contains({a, b})) continue;
      if (!are_apart(model, bodies, a, b)) pairs.emplace(a, b);
    }
  }
  return pairs;
}

/// What one request says about the robots of a scene.
class ContactFinder {
 public:
  ContactFinder(const SceneRequest& request, const LinkedScene& scene, const FlatScene& flat,
                DiagnosticSink& losses)
      : request_(request),
        scene_(scene),
        flat_(flat),
        losses_(losses),
        choice_(request.self_collision == SelfCollision::as_usual ? request.format.usual_contacts
                                                                  : request.self_collision) {}

  SelfCollision choice() const { return choice_; }

  Pairs pairs_of(const LinkedModel& model, const RobotSrdf& srdf) {
    Pairs pairs;
    if (choice_ == SelfCollision::srdf || choice_ == SelfCollision::as_usual) {
      add_disabled(model, srdf, pairs);
    }
    const SceneFormat& format = request_.format;
    if (format.has_link_pairs && !format.has_bitmasks && !names_models() &&
        choice_ != SelfCollision::none) {
      add_separated(model, pairs);
    }
    const bool keeps_neighbours =
        choice_ == SelfCollision::srdf || choice_ == SelfCollision::neighbours;
    if (format.has_link_pairs && !format.welds_links && !names_models() && keeps_neighbours) {
      const Pairs distant = distant_neighbours(model);
      pairs.insert(distant.begin(), distant.end());
    }
    const bool can_touch = choice_ == SelfCollision::srdf || choice_ == SelfCollision::neighbours ||
                           (choice_ == SelfCollision::as_usual && touches_itself(model));
    if (can_touch && format.has_contacts && !names_models()) add_overlaps(model, pairs);
    if (choice_ == SelfCollision::all && !request_.format.has_neighbours) {
      losses_.report(rules::sml8211_lost_part, place_of(model),
                     "contacts of links of " + quoted(model.path) +
                         " that a joint connects are not in the result: " +
                         std::string(format.name) + " has none");
    }
    return pairs;
  }

 private:
  static Span place_of(const LinkedModel& model) { return {model.robot->document.source, 0, 0}; }

  /// Whether the contacts are those that a reader of the URDF computes.
  bool names_models() const {
    return request_.form == SceneForm::reference && request_.format.has_expanded_form;
  }

  void add_disabled(const LinkedModel& model, const RobotSrdf& srdf, Pairs& pairs) {
    pairs = srdf.pairs;
    if (srdf.file.empty()) {
      for (const auto& [link, other] : model.excluded) {
        const auto a = model.link_names.find(link);
        const auto b = model.link_names.find(other);
        if (a && b && *a != *b) pairs.insert(std::minmax<std::size_t>(*a, *b));
      }
    }
    const std::string& file = srdf.file.empty() ? model.urdf_path : srdf.file;
    if (pairs.empty() && !request_.srdf.empty()) {
      losses_.report(rules::sml8212_chosen_value, place_of(model),
                     quoted(request_.srdf) + " disables no pair of links of " + quoted(model.path));
    }
    if (pairs.empty() || !request_.format.has_link_pairs) return;
    if (names_models()) {
      losses_.report(rules::sml8211_lost_part, place_of(model),
                     counted(pairs.size(), "pair") + " of links of " + quoted(model.path) +
                         " can touch, which " + quoted(file) +
                         " disables: the result names the URDF; --form expand keeps them apart");
      return;
    }
    losses_.report(rules::sml8212_chosen_value, place_of(model),
                   counted(pairs.size(), "pair") + " of links of " + quoted(model.path) +
                       " cannot touch: " + quoted(file) + " disables them");
  }

  void add_separated(const LinkedModel& model, Pairs& pairs) {
    const Pairs separated = separated_by_bits(model);
    if (separated.empty()) return;
    losses_.report(rules::sml8212_chosen_value, place_of(model),
                   counted(separated.size(), "pair") + " of links of " + quoted(model.path) +
                       " cannot touch: their bitmasks share no bit");
    pairs.insert(separated.begin(), separated.end());
  }

  void add_overlaps(const LinkedModel& model, Pairs& pairs) {
    const bool has_pairs = request_.format.has_link_pairs;
    const bool excludes =
        has_pairs && (request_.excludes_overlaps || request_.motors.kind == MotorKind::automatic);
    std::vector<LinkOverlap> overlaps = overlaps_at_start(model, scene_, flat_);
    std::erase_if(overlaps, [&](const LinkOverlap& one) {
      return pairs.contains({one.link, one.other});
    });
    if (overlaps.empty()) return;
    const bool is_one = overlaps.size() == 1;
    Diagnostic& said =
        losses_.report(rules::sml8212_chosen_value, place_of(model),
                       counted(overlaps.size(), "pair") + " of links of " + quoted(model.path) +
                           (is_one ? " overlaps" : " overlap") + " at the start" +
                           (excludes ? ", and cannot touch: " : ", and push each other apart: ") +
                           list(model, overlaps));
    if (has_pairs && !excludes) said.help("--exclude-overlaps leaves out their contacts");
    if (!excludes) return;
    for (const LinkOverlap& one : overlaps) pairs.emplace(one.link, one.other);
  }

  const SceneRequest& request_;
  const LinkedScene& scene_;
  const FlatScene& flat_;
  DiagnosticSink& losses_;
  SelfCollision choice_;
};

}  // namespace

OwnContacts own_contacts(const SceneRequest& request, const LinkedScene& scene,
                         const FlatScene& flat, const SrdfsOfRobots& srdfs,
                         DiagnosticSink& losses) {
  ContactFinder finder(request, scene, flat, losses);
  OwnContacts contacts{.choice = finder.choice(), .left_out = {}};
  for (const LinkedModel& model : scene.models) {
    const auto srdf = srdfs.find(&model);
    if (srdf == srdfs.end()) continue;
    const Pairs pairs = finder.pairs_of(model, srdf->second);
    if (!pairs.empty()) contacts.left_out[&model] = {pairs.begin(), pairs.end()};
  }
  return contacts;
}

}  // namespace smurf
