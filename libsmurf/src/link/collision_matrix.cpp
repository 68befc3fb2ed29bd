// SPDX-License-Identifier: BSD-3-Clause
#include "link/collision_matrix.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include "base/deadline.hpp"
#include "base/ranges.hpp"
#include "link/hull_contact.hpp"
#include "link/link_overlaps.hpp"
#include "link/shape_hulls.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostShapes = 2000;
constexpr std::size_t kMostLinks = 500;
/// The hull of a round shape has 16 corners on its circle, and lies inside: 0.98 of its radius.
constexpr double kMargin = 1.02;
/// As in MoveIt: the part of the samples from which on a pair touches always, and their number.
constexpr double kAlways = 0.95;
constexpr std::size_t kFewSamples = 200;

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

struct SweptShape {
  HullCorners hull;
  Pose X_LC;
};

/// A pair that is not decided yet.
struct OpenPair {
  std::size_t link = 0, other = 0;
  Vector3 axis{};           ///< in which two of their shapes were apart last
  std::size_t touched = 0;  ///< number of samples
  bool has_been_near = false;
};

/// Numbers that are the same on every machine.
class EvenNumbers {
 public:
  double between(double low, double high) {
    const double part = static_cast<double>(engine_() >> 11U) / 9007199254740992.0;  // 2^53
    return low + part * (high - low);
  }

 private:
  std::mt19937_64 engine_{20261129};
};

/// By link, the one that carries it, over all joints but floating and planar ones: where their two
/// ends are, nobody knows.
std::vector<std::size_t> roots_of(const LinkedModel& model) {
  std::vector<std::size_t> root(model.robot->links.size());
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = i;
  for (const LinkIndex link : model.tree.order) {
    const auto joint = model.tree.parent_joint[to_size(link)];
    if (!joint) continue;
    const urdf::JointType type = model.joint(*joint).type;
    if (type == urdf::JointType::floating || type == urdf::JointType::planar) continue;
    root[to_size(link)] = root[to_size(*model.tree.joint_parent[to_size(*joint)])];
  }
  return root;
}

class Sweep {
 public:
  explicit Sweep(const LinkedModel& model) : model_(model), shapes_(model.robot->links.size()) {
    for (const urdf::Joint& joint : model.robot->joints) {
      if (joint.name && joint.has_one_axis() && !joint.mimic) add_range(joint);
    }
  }

  CollisionMatrix run(std::size_t samples) {
    if (!read_shapes()) return std::move(found_);
    open_pairs();
    add_neighbours();
    try_at(rest_positions(model_), [&](OpenPair& pair, const auto& touches) {
      if (touches(1)) decide(pair, PairReason::at_start);
    });
    found_.samples = samples;
    if (samples > 0) find_always(std::min(kFewSamples, samples));
    for (std::size_t i = std::min(kFewSamples, samples); i < samples && !open_.empty(); ++i) {
      try_at(next_sample(),
             [](OpenPair& pair, const auto& touches) { pair.has_been_near = touches(kMargin); });
      std::erase_if(open_, [](const OpenPair& pair) { return pair.has_been_near; });
    }
    for (const OpenPair& pair : open_) {
      if (samples > 0) decide(pair, PairReason::never);
    }
    std::sort(found_.pairs.begin(), found_.pairs.end(), [](const LinkPair& a, const LinkPair& b) {
      return std::pair(a.link, a.other) < std::pair(b.link, b.other);
    });
    return std::move(found_);
  }

 private:
  struct Range {
    double* position;
    double low, high;
  };

  void add_range(const urdf::Joint& joint) {
    double low = -std::numbers::pi;
    double high = std::numbers::pi;
    if (joint.type != urdf::JointType::continuous) {
      low = joint.limit ? joint.limit->lower.value_or(0) : 0;
      high = joint.limit ? joint.limit->upper.value_or(0) : 0;
      if (!(low < high)) return;
    }
    ranges_.push_back({&positions_[*joint.name], low, high});
  }

  /// False if there are too many.
  bool read_shapes() {
    const auto poses = forward_kinematics(model_, {});
    std::size_t count = 0;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const urdf::Link& link = model_.robot->links[i];
      count += link.collisions.size();
      if (link.collisions.empty() || !poses[i]) continue;
      for (const urdf::Collision& collision : link.collisions) {
        const auto hull = hull_of(model_, collision.geometry);
        if (!hull) continue;
        shapes_[i].push_back({hull_corners(hull->corners), urdf::to_pose(collision.origin)});
      }
      if (shapes_[i].size() == link.collisions.size()) {
        links_.push_back(i);
      } else {
        ++found_.unknown;
        shapes_[i].clear();
      }
    }
    found_.is_complete = count <= kMostShapes && links_.size() <= kMostLinks;
    return found_.is_complete;
  }

  void open_pairs() {
    const std::vector<std::size_t> roots = roots_of(model_);
    for (std::size_t i = 0; i < links_.size(); ++i) {
      for (std::size_t k = i + 1; k < links_.size(); ++k) {
        ++found_.all;
        if (roots[links_[i]] == roots[links_[k]]) {
          open_.push_back({links_[i], links_[k]});
        } else {
          ++found_.floating;
        }
      }
    }
  }

  /// A link without shapes connects all that are connected to it.
  void add_neighbours() {
    std::vector<std::set<std::size_t>> near(shapes_.size());
    for (std::size_t i = 0; i < model_.robot->joints.size(); ++i) {
      const auto& parent = model_.tree.joint_parent[i];
      const auto& child = model_.tree.joint_child[i];
      if (!parent || !child || *parent == *child) continue;
      near[to_size(*parent)].insert(to_size(*child));
      near[to_size(*child)].insert(to_size(*parent));
    }
    for (std::size_t empty = 0; empty < near.size(); ++empty) {
      if (!model_.robot->links[empty].collisions.empty()) continue;
      for (const std::size_t a : near[empty]) {
        near[a].erase(empty);
        for (const std::size_t b : near[empty]) {
          if (a != b) near[a].insert(b);
        }
      }
      near[empty].clear();
    }
    for (OpenPair& pair : open_) {
      if (near[pair.link].contains(pair.other)) decide(pair, PairReason::adjacent);
    }
    close();
  }

  void decide(const OpenPair& pair, PairReason reason) {
    found_.pairs.push_back({pair.link, pair.other, reason});
    decided_.emplace(pair.link, pair.other);
  }

  /// Forgets pairs that are decided.
  void close() {
    std::erase_if(open_, [&](const OpenPair& pair) {
      return decided_.contains({pair.link, pair.other});
    });
  }

  /// Leaves the pairs that have not been near each other.
  void find_always(std::size_t samples) {
    for (std::size_t i = 0; i < samples; ++i) {
      try_at(next_sample(), [](OpenPair& pair, const auto& touches) {
        const bool is_near = touches(kMargin);
        pair.has_been_near = pair.has_been_near || is_near;
        if (is_near && touches(1)) ++pair.touched;
      });
    }
    for (const OpenPair& pair : open_) {
      const bool is_usual =
          static_cast<double>(pair.touched) >= kAlways * static_cast<double>(samples);
      if (is_usual) decide(pair, PairReason::always);
    }
    std::erase_if(open_, [](const OpenPair& pair) { return pair.has_been_near; });
    close();
  }

  const JointPositions& next_sample() {
    for (const Range& range : ranges_) *range.position = numbers_.between(range.low, range.high);
    return positions_;
  }

  /// Calls take(pair, touches) for all open pairs; touches(size) tells whether shapes that are
  /// `size` times as large touch each other.
  template <class Take>
  void try_at(const JointPositions& positions, const Take& take) {
    const auto poses = forward_kinematics(model_, positions);
    std::vector<std::vector<PlacedHull>> placed(shapes_.size());
    for (const std::size_t link : links_) {
      for (const SweptShape& shape : shapes_[link]) {
        placed[link].emplace_back(shape.hull, *poses[link] * shape.X_LC);
      }
    }
    for (OpenPair& pair : open_) {
      const auto& some = placed[pair.link];
      const auto& others = placed[pair.other];
      Deadline::look(some.size() * others.size());
      take(pair, [&](double size) {
        return ranges::any_of(some, [&](const PlacedHull& one) {
          return ranges::any_of(others, [&](const PlacedHull& other) {
            return are_touching(one, other, size, pair.axis);
          });
        });
      });
    }
    close();
  }

  const LinkedModel& model_;
  std::vector<std::vector<SweptShape>> shapes_;  ///< by link
  std::vector<std::size_t> links_;               ///< with shapes that can be read
  std::vector<OpenPair> open_;
  Pairs decided_;
  JointPositions positions_;
  std::vector<Range> ranges_;
  EvenNumbers numbers_;
  CollisionMatrix found_;
};

}  // namespace

std::string_view name_of(PairReason reason) {
  switch (reason) {
  case PairReason::adjacent: return "Adjacent";
  case PairReason::at_start: return "Default";
  case PairReason::always: return "Always";
  case PairReason::never: break;
  }
  return "Never";
}

CollisionMatrix collision_matrix(const LinkedModel& model, std::size_t samples) {
  return model.robot ? Sweep(model).run(samples) : CollisionMatrix();
}

}  // namespace smurf
