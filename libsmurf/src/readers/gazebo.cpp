// SPDX-License-Identifier: BSD-3-Clause
// Gazebo, which reads URDF with sdformat, which reads it with urdfdom.
#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::readers::gazebo_file {
namespace {

/// Joints to links that sdformat drops, names of links that it drops or merges, and numbers that it
/// computes with because it merges links.
class Sight {
 public:
  explicit Sight(const LinkedModel& model)
      : model_(model),
        links_(links_of_sdformat(model)),
        count_(links_.size(), 0),
        is_dropped_(links_.size()) {
    for (const auto& top : links_) {
      if (top) ++count_[to_size(*top)];
    }
    for (const LinkIndex link : model.tree.order) {  // not those in a ring, at which it crashes
      const std::size_t i = to_size(link);
      is_dropped_[i] = !links_[i] && model.link(link).name.value_or("") != "world";
    }
  }

  /// Whether sdformat drops every link. Another rule reports that.
  bool is_empty() const {
    return std::none_of(links_.begin(), links_.end(),
                        [](const auto& top) { return top.has_value(); });
  }

  void see(Diagnostic& finding) {
    const std::vector<PlaceName> place = place_of(finding);
    if (contains(place, at("robot/joint"))) {
      const urdf::Joint* joint = part_at(model_.robot->joints, finding.span.begin);
      if (joint != nullptr) see_joint(index_in(model_.robot->joints, *joint), place, finding);
    } else if (contains(place, at("robot/link"))) {
      const urdf::Link* link = part_at(model_.robot->links, finding.span.begin);
      if (link != nullptr) see_link(index_in(model_.robot->links, *link), place, finding);
    }
  }

 private:
  using Place = std::vector<PlaceName>;

  bool is_merged(std::size_t link) const { return links_[link] && to_size(*links_[link]) != link; }

  void see_joint(std::size_t index, const Place& place, Diagnostic& finding) const {
    const auto child = model_.tree.joint_child[index];
    if (!child) return;
    const auto above = model_.tree.parent_joint[to_size(*child)];
    const bool is_above = above && to_size(*above) == index;
    // The joint of merged links has no name any more.
    const bool is_about_name = finding.rule == &rules::sml1307_reserved_name;
    if (is_above &&
        (is_dropped_[to_size(*child)] || (is_about_name && is_merged(to_size(*child))))) {
      finding.when(kDroppedByGazebo);
    }
    see_number(to_size(*child), place, finding);
  }

  void see_link(std::size_t link, const Place& place, Diagnostic& finding) {
    const bool is_about_name = finding.rule == &rules::sml1307_reserved_name;
    if (is_about_name && (is_merged(link) || is_dropped_[link])) finding.when(kDroppedByGazebo);
    if (contains(place, at("inertial/inertia"))) {
      if (near_zero_.empty()) near_zero_ = near_zero_together(model_);
      if (near_zero_[link]) finding.when(kUncertain);
    }
    see_number(link, place, finding);
  }

  /// sdformat computes with such a number. Whether it can read the result depends on the other
  /// numbers.
  void see_number(std::size_t link, const Place& place, Diagnostic& finding) const {
    if (!finding.cases.contains(cases::kSubnormal)) return;
    const bool is_moved = contains(place, at("origin/@xyz")) || contains(place, at("inertia"));
    const bool is_rotated = contains(place, at("origin/@rpy"));
    const bool is_joined = links_[link] && count_[to_size(*links_[link])] > 1;
    if (is_rotated || (is_moved && is_joined)) finding.when(kUncertain);
  }

  const LinkedModel& model_;
  std::vector<std::optional<LinkIndex>> links_;
  std::vector<std::size_t> count_;  ///< of links that become one, by the topmost
  std::vector<bool> is_dropped_;
  std::vector<bool> near_zero_;  ///< by link; computed when it is needed
};

/// sdformat adds the masses of links that are fixed to each other.
void see_added_masses(const LinkedModel& model, std::span<Diagnostic* const> found) {
  std::vector<bool> alone;
  for (Diagnostic* finding : found) {
    if (!finding->cases.contains(cases::kTooLarge)) continue;
    if (!contains(place_of(*finding), at("link/inertial/mass/@value"))) continue;
    const urdf::Link* link = part_at(model.robot->links, finding->span.begin);
    if (link == nullptr) continue;
    if (alone.empty()) alone = alone_in_motion(model);
    if (!alone[index_in(model.robot->links, *link)]) finding->when(kUncertain);
  }
}

void see(const LinkedModel& model, std::span<Diagnostic* const> found) {
  see_added_masses(model, found);
  Sight sight(model);
  if (sight.is_empty()) return;
  for (Diagnostic* finding : found) sight.see(*finding);
}

constexpr ReaderVersion kInFortress[] = {{&gazebo, {12, 3}}};
constexpr ReaderVersion kInGarden[] = {{&gazebo, {13, 0}}};
constexpr ReaderVersion kInHarmonic[] = {{&gazebo, {14, 0}}};
constexpr ReaderVersion kInIonic[] = {{&gazebo, {15, 0}}};
constexpr ReaderVersion kInJetty[] = {{&gazebo, {16, 0}}};

constexpr Reader kFortress{.name = "gazebo:fortress",
                           .title = "Gazebo Fortress",
                           .basis = "sdformat 12.3.0, executed",
                           .like = &gazebo,
                           .parts = kInFortress};
constexpr Reader kGarden{.name = "gazebo:garden",
                         .title = "Gazebo Garden",
                         .basis = "sdformat 13, not executed",
                         .like = &gazebo,
                         .parts = kInGarden};
constexpr Reader kHarmonic{.name = "gazebo:harmonic",
                           .title = "Gazebo Harmonic",
                           .basis = "sdformat 14, not executed",
                           .like = &gazebo,
                           .parts = kInHarmonic};
constexpr Reader kIonic{.name = "gazebo:ionic",
                        .title = "Gazebo Ionic",
                        .basis = "sdformat 15, not executed",
                        .like = &gazebo,
                        .parts = kInIonic};
constexpr Reader kJetty{.name = "gazebo:jetty",
                        .title = "Gazebo Jetty",
                        .basis = "sdformat 16, not executed",
                        .like = &gazebo,
                        .parts = kInJetty};
constexpr const Reader* kReleases[] = {&kFortress, &kGarden, &kHarmonic, &kIonic, &kJetty};

}  // namespace

extern constinit const Reader gazebo{.name = "gazebo",
                                     .title = "Gazebo",
                                     .basis = "sdformat 12.3.0, executed; 17 (2ace536) read",
                                     .like = &urdfdom,
                                     .version = "sdformat 12.3",
                                     .number = {12, 3},
                                     .releases = kReleases,
                                     .see = see,
                                     .drops = &kDroppedByGazebo};

}  // namespace smurf::readers::gazebo_file
