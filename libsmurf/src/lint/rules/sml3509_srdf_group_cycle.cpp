// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <vector>

#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3509_srdf_group_cycle_file {
namespace {

using Numbers = std::vector<std::size_t>;

/// The groups in each group.
std::vector<Numbers> members_of(const srdf::Description& srdf) {
  std::vector<Numbers> members(srdf.groups.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    for (const srdf::Member& member : srdf.groups[i].members) {
      if (member.kind != srdf::Member::Kind::group || !member.name) continue;
      const auto inner = srdf.group_numbers.find(*member.name);
      if (inner != srdf.group_numbers.end()) members[i].push_back(inner->second);
    }
  }
  return members;
}

/// Finds the rings: the groups that contain each other (Tarjan). Not recursive, because groups may
/// be nested as deep as the file is long.
class Rings {
 public:
  explicit Rings(const std::vector<Numbers>& members)
      : members_(members), order_(members.size(), 0), lowest_(members.size(), 0) {
    is_open_.resize(members.size());
  }

  /// The first group of each ring, in document order.
  Numbers first_groups() {
    for (std::size_t i = 0; i < members_.size(); ++i) {
      if (order_[i] == 0) visit(i);
    }
    std::sort(firsts_.begin(), firsts_.end());
    return std::move(firsts_);
  }

 private:
  struct Step {
    std::size_t group = 0, next = 0;
  };

  void enter(std::size_t group) {
    order_[group] = lowest_[group] = ++count_;
    is_open_[group] = true;
    open_.push_back(group);
    steps_.push_back({group, 0});
  }

  void visit(std::size_t start) {
    enter(start);
    while (!steps_.empty()) {
      const std::size_t group = steps_.back().group;
      if (steps_.back().next < members_[group].size()) {
        const std::size_t inner = members_[group][steps_.back().next++];
        if (order_[inner] == 0) {
          enter(inner);
        } else if (is_open_[inner]) {
          lowest_[group] = std::min(lowest_[group], order_[inner]);
        }
        continue;
      }
      steps_.pop_back();
      if (!steps_.empty()) {
        std::size_t& above = lowest_[steps_.back().group];
        above = std::min(above, lowest_[group]);
      }
      if (lowest_[group] == order_[group]) close(group);
    }
  }

  /// The groups that were entered since `root` contain each other.
  void close(std::size_t root) {
    std::size_t first = root, size = 0, last = 0;
    do {
      last = open_.back();
      open_.pop_back();
      is_open_[last] = false;
      first = std::min(first, last);
      ++size;
    } while (last != root);
    const Numbers& inner = members_[root];
    const bool is_ring = size > 1 || std::find(inner.begin(), inner.end(), root) != inner.end();
    if (is_ring) firsts_.push_back(first);
  }

  const std::vector<Numbers>& members_;
  Numbers order_, lowest_;  ///< 0: not visited
  std::vector<bool> is_open_;
  Numbers open_, firsts_;
  std::vector<Step> steps_;
  std::size_t count_ = 0;
};

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    const std::vector<Numbers> members = members_of(srdf);
    for (const std::size_t i : Rings(members).first_groups()) {
      const srdf::Group& group = srdf.groups[i];
      findings
          .report(place_of(srdf, group.name, group.element),
                  title_of("group", group.name) + " contains itself")
          .help("remove one of the groups in it");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "reports an error and drops all groups of the ring",
     "srdfdom model.cpp loadGroups"},
};

}  // namespace

extern constinit const Rule sml3509_srdf_group_cycle{.id = "SML3509",
                                                     .name = "srdf-group-cycle",
                                                     .severity = Severity::error,
                                                     .summary =
                                                         "A group of an SRDF contains itself.",
                                                     .remedy = "Remove one of the groups in it.",
                                                     .check_companions = check,
                                                     .facts = kFacts};

}  // namespace smurf::rules::sml3509_srdf_group_cycle_file
