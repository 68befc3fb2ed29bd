// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo does not let a body touch its neighbours, unless a neighbour is fixed to the world. These
// pairs of bodies have to be excluded by name.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace smurf {

/// Bodies that are fixed to each other.
class WeldedBodies {
 public:
  WeldedBodies(bool is_world, std::size_t instance, const WeldedBodies* neighbour)
      : is_world_(is_world), instance_(instance), neighbour_(neighbour) {}

  bool is_world() const { return is_world_; }
  /// Adds a body of an instance that can touch others.
  void add(std::size_t instance, std::string body) {
    bodies_.emplace_back(instance, std::move(body));
  }

 private:
  friend class MjcfExcludes;
  bool is_world_;
  std::size_t instance_;           ///< of the joint that moves them
  const WeldedBodies* neighbour_;  ///< fixed to the world, and connected to these by a joint
  std::vector<std::pair<std::size_t, std::string>> bodies_;
};

class MjcfExcludes {
 public:
  WeldedBodies* add_tree(bool is_fixed) { return add(is_fixed, 0, nullptr); }
  /// Those that a joint of an instance moves relative to `outer`.
  WeldedBodies* add_moving(std::size_t instance, const WeldedBodies& outer) {
    return add(false, instance, outer.is_world() ? &outer : nullptr);
  }

  /// Calls `exclude(body, other)` for all pairs of an instance, until it returns false.
  template <class Exclude>
  void for_each(Exclude exclude) const {
    for (const std::unique_ptr<WeldedBodies>& moving : all_) {
      if (moving->neighbour_ == nullptr) continue;
      for (const auto& [owner, body] : moving->neighbour_->bodies_) {
        if (owner != moving->instance_) continue;
        for (const auto& [other_owner, other] : moving->bodies_) {
          if (other_owner == owner && !exclude(body, other)) return;
        }
      }
    }
  }

 private:
  WeldedBodies* add(bool is_world, std::size_t instance, const WeldedBodies* neighbour) {
    return all_.emplace_back(std::make_unique<WeldedBodies>(is_world, instance, neighbour)).get();
  }

  std::vector<std::unique_ptr<WeldedBodies>> all_;
};

}  // namespace smurf
