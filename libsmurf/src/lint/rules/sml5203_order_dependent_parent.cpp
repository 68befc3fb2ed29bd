// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5203_order_dependent_parent_file {
namespace {

using Frames = std::array<std::optional<std::size_t>, 2>;

std::optional<std::size_t> instance_of(const Attachment& attachment) {
  if (attachment.kind != Attachment::Kind::link) return std::nullopt;
  return to_size(attachment.instance);
}

/// The instances that MARS creates once their references exist; the rest come last.
std::vector<bool> created_in_order(const LinkedScene& scene, const std::vector<Frames>& frames) {
  std::vector<bool> in_order(frames.size(), false);
  std::vector<std::size_t> waiting(frames.size(), 0);
  std::vector<std::vector<std::size_t>> dependents(frames.size());
  std::vector<std::size_t> ready;
  bool has_unnamed = false;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (const auto& frame : frames[i]) {
      if (!frame) continue;
      ++waiting[i];
      dependents[*frame].push_back(i);
    }
    if (waiting[i] > 0) continue;
    ready.push_back(i);
    has_unnamed = has_unnamed || scene.instances[i].name.empty();
  }
  while (!ready.empty()) {
    const std::size_t created = ready.back();
    ready.pop_back();
    in_order[created] = true;
    for (const std::size_t dependent : dependents[created]) {
      // The empty name of a missing reference exists once an unnamed entity is created.
      const bool is_complete = frames[dependent][0] && frames[dependent][1];
      if (--waiting[dependent] == 0 && (is_complete || has_unnamed)) ready.push_back(dependent);
    }
  }
  return in_order;
}

void check(const LinkedScene& scene, Findings& findings) {
  std::vector<Frames> frames;
  frames.reserve(scene.instances.size());
  for (const Instance& instance : scene.instances) {
    frames.push_back(
        {instance_of(instance.placement.parent), instance_of(instance.placement.anchor)});
  }
  const std::vector<bool> in_order = created_in_order(scene, frames);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Instance& instance = scene.instances[i];
    if (in_order[i] || !instance.X_WE) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      if (!frames[i][k] || *frames[i][k] <= i || in_order[*frames[i][k]]) continue;
      const Instance& target = scene.instances[*frames[i][k]];
      Diagnostic& diagnostic = findings.report(
          k == 0 ? parent_place(scene, instance) : scene.entity(instance).anchor.span,
          "MARS creates " + quoted(instance.name) + " before " + quoted(target.name) +
              " and does not find the link it refers to");
      diagnostic.label(place_of(scene.entity(target)), "created later");
      break;
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "waits for the entities named by `parent` and `anchor` only when both name one; those with one of the two are created last, in file order, and may end in the world frame",
     "MARS SMURFLoader.cpp:580-637, run"},
};

}  // namespace

extern constinit const Rule sml5203_order_dependent_parent{
    .id = "SML5203",
    .name = "order-dependent-parent",
    .severity = Severity::warning,
    .summary = "An entity refers to a later one in a way that MARS resolves only in file order.",
    .why = "An entity that is created before the one it refers to is misplaced.",
    .remedy =
        "Move the entity after the one it refers to, or give it both keys (`anchor: parent`).",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5203_order_dependent_parent_file
