// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/own_contacts.hpp"

#include <algorithm>
#include <set>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "link/disabled_pairs.hpp"
#include "link/link_overlaps.hpp"

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

}  // namespace

OwnContacts own_contacts(const SceneRequest& request, const LinkedScene& scene,
                         const FlatScene& flat, const FileReader& files, const Limits& limits,
                         DiagnosticSink& losses) {
  OwnContacts contacts{.choice = request.self_collision, .left_out = {}};
  const bool reads_srdf = request.self_collision == SelfCollision::as_usual ||
                          request.self_collision == SelfCollision::srdf;
  const bool excludes = request.excludes_overlaps || request.motors.kind == MotorKind::automatic;
  for (const LinkedModel& model : scene.models) {
    if (!model.robot || model.tree.roots.empty()) continue;
    const Span place{model.robot->document.source, 0, 0};
    DisabledPairs disabled;
    if (reads_srdf) disabled = disabled_pairs(model, request.srdf, files, limits);
    Pairs& pairs = disabled.pairs;
    if (reads_srdf && disabled.file.empty()) {
      for (const auto& [link, other] : model.excluded) {
        const auto a = model.link_names.find(link);
        const auto b = model.link_names.find(other);
        if (a && b && *a != *b) pairs.insert(std::minmax<std::size_t>(*a, *b));
      }
      disabled.file = model.urdf_path;
    }
    if (!pairs.empty()) {
      losses.report(rules::sml8212_chosen_value, place,
                    counted(pairs.size(), "pair") + " of links of " + quoted(model.path) +
                        " cannot touch: " + quoted(disabled.file) + " disables them");
    }
    if (request.self_collision != SelfCollision::none &&
        request.self_collision != SelfCollision::all) {
      std::vector<LinkOverlap> overlaps = overlaps_at_start(model, scene, flat);
      std::erase_if(overlaps, [&](const LinkOverlap& one) {
        return pairs.contains({one.link, one.other});
      });
      if (!overlaps.empty()) {
        const bool is_one = overlaps.size() == 1;
        Diagnostic& said = losses.report(
            rules::sml8212_chosen_value, place,
            counted(overlaps.size(), "pair") + " of links of " + quoted(model.path) +
                (is_one ? " overlaps" : " overlap") + " at the start" +
                (excludes ? ", and cannot touch: " : ", and push each other apart: ") +
                list(model, overlaps));
        if (!excludes) said.help("--exclude-overlaps leaves out their contacts");
        for (const LinkOverlap& one : overlaps) {
          if (excludes) pairs.emplace(one.link, one.other);
        }
      }
    }
    if (!pairs.empty()) contacts.left_out[&model] = {pairs.begin(), pairs.end()};
  }
  return contacts;
}

}  // namespace smurf
