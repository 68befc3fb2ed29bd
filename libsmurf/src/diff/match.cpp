// SPDX-License-Identifier: BSD-3-Clause
#include "diff/match.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "base/files/path.hpp"
#include "base/numbers/bits.hpp"
#include "base/ranges.hpp"

namespace smurf {
namespace {

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t hash =
      (a ^ (b + 0x9E3779B97F4A7C15U + (a << 6U) + (a >> 2U))) * 0xBF58476D1CE4E5B9U;
  return hash ^ (hash >> 31U);
}

std::uint64_t hash_of_text(std::string_view text) { return std::hash<std::string_view>{}(text); }

/// A name that may still be renamed matches every name.
std::uint64_t hash_of_name(std::string_view text, Span place, const Renames& names) {
  return names.is_open(place) ? 1 : hash_of_text(names.translate(text, place));
}

std::uint64_t hash_of_numbers(const std::vector<double>& numbers) {
  std::uint64_t hash = numbers.size();
  for (const double number : numbers) hash = mixed(hash, bit_cast<std::uint64_t>(number + 0.0));
  return hash;
}

std::uint64_t hash_of_texts(const std::vector<Spanned<std::string_view>>& texts,
                            const Renames& names) {
  std::uint64_t hash = 0;
  for (const auto& [text, place] : texts) hash = mixed(hash, hash_of_name(text, place, names));
  return hash;
}

std::uint64_t hash_of_members(const Property& property, const Renames& names) {
  std::uint64_t hash = 0;
  for (const Property& member : property.members) {
    const std::uint64_t own = hash_of(member, names);
    const bool is_item = property.form == Property::Form::list && member.key.empty();
    if (is_item) hash = mixed(hash, own);
    if (is_item || own == 0) continue;
    hash += mixed(hash_of_name(member.key, member.key_span, names), own);
  }
  return property.form == Property::Form::choice ? mixed(hash, hash_of_text(property.text)) : hash;
}

class Matcher {
 public:
  Matcher(const Things& before, const Things& after, Renames& renames)
      : before_(before), after_(after), renames_(renames), names_after_(after.references) {
    matching_.to_new.assign(before.all.size(), kNone);
    matching_.to_old.assign(after.all.size(), kNone);
    count_parts(before, parts_before_);
    count_parts(after, parts_after_);
    sort_by_kind(before, kinds_before_);
    sort_by_kind(after, kinds_after_);
  }

  Matching run() {
    match_by_name(of_kind(NameKind::link, 0));
    match_by_name(of_kind(NameKind::joint, 0));
    match_roots();
    follow_tree();
    match_by_content(of_kind(NameKind::link, 0));
    follow_tree();
    match_by_content(of_kind(NameKind::joint, 0));
    follow_tree();
    close(NameKind::link);
    close(NameKind::joint);
    match_entities();
    for (const NameKind kind :
         {NameKind::material, NameKind::visual, NameKind::collision, NameKind::motor,
          NameKind::sensor, NameKind::node, NameKind::pose}) {
      match_kind(kind);
    }
    for (const NameKind kind : {NameKind::group, NameKind::extension}) close(kind);
    match_kind(std::nullopt);
    return std::move(matching_);
  }

 private:
  using Kind = std::optional<NameKind>;
  using Parts = std::unordered_map<std::size_t, std::vector<std::size_t>>;  ///< hash of the whole
  /// Ordered by kind and depth, so that a thing is matched before its parts.
  using Kinds = std::map<std::pair<Kind, std::size_t>, std::vector<std::size_t>>;
  /// Things of one kind that are matched together.
  struct Candidates {
    const std::vector<std::size_t>& before;
    const std::vector<std::size_t>& after;
  };
  /// Things of both versions that may be counterparts.
  struct Bucket {
    std::vector<std::size_t> before, after;
  };

  void close(NameKind kind) {
    renames_.close(kind);
    names_after_.close(kind);
  }

  /// Matches scene files that matched entities include.
  void match_scenes(std::size_t old_scene, std::size_t new_scene) {
    if (old_scene == kNone || new_scene == kNone) return;
    if (!is_free_before(old_scene) || !is_free_after(new_scene)) return;
    pair(old_scene, new_scene);
    scenes_.emplace_back(old_scene, new_scene);
  }

  /// Matches entities scene by scene, from the outermost.
  void match_entities() {
    const auto first = [](const Things& things) {
      const auto found = ranges::find(things.all, true, &Thing::is_scene);
      return found == things.all.end() ? kNone
                                       : static_cast<std::size_t>(found - things.all.begin());
    };
    match_scenes(first(before_), first(after_));
    while (!scenes_.empty()) {
      const auto scenes = scenes_.front();
      scenes_.pop_front();
      const std::vector<std::size_t> before = entities_in(before_, parts_before_, scenes.first);
      const std::vector<std::size_t> after = entities_in(after_, parts_after_, scenes.second);
      match_by_name({before, after});
      match_by_content({before, after});
    }
    close(NameKind::entity);
  }

  static std::vector<std::size_t> entities_in(const Things& things, const Parts& parts,
                                              std::size_t scene) {
    const auto found = parts.find(scene);
    if (found == parts.end()) return {};
    std::vector<std::size_t> entities = found->second;
    std::erase_if(entities, [&](std::size_t i) { return things.all[i].names != NameKind::entity; });
    return entities;
  }

  static void count_parts(const Things& things, Parts& parts) {
    for (std::size_t i = 0; i < things.all.size(); ++i) {
      if (things.all[i].parent != kNone) parts[things.all[i].parent].push_back(i);
    }
  }

  static void sort_by_kind(const Things& things, Kinds& kinds) {
    std::vector<std::size_t> depths;
    for (std::size_t i = 0; i < things.all.size(); ++i) {
      const Thing& thing = things.all[i];
      if (thing.is_scene) {
        depths.push_back(0);
        continue;
      }
      depths.push_back(thing.parent == kNone ? 0 : depths[thing.parent] + 1);
      kinds[{thing.names, depths[i]}].push_back(i);
    }
  }

  Candidates of_kind(Kind kind, std::size_t depth) const {
    static const std::vector<std::size_t> kNothing;
    const auto find = [&](const Kinds& kinds) -> const std::vector<std::size_t>& {
      const auto found = kinds.find({kind, depth});
      return found == kinds.end() ? kNothing : found->second;
    };
    return {find(kinds_before_), find(kinds_after_)};
  }

  void pair(std::size_t old_thing, std::size_t new_thing) {
    matching_.to_new[old_thing] = new_thing;
    matching_.to_old[new_thing] = old_thing;
    const std::optional<NameKind> kind = before_.all[old_thing].names;
    if (kind == NameKind::link || kind == NameKind::joint) queue_.push_back(old_thing);
    match_scenes(before_.all[old_thing].brings, after_.all[new_thing].brings);
    const Thing& before = before_.all[old_thing];
    const Thing& after = after_.all[new_thing];
    if (before.names && before.name != after.name && !before.name.empty() && !after.name.empty()) {
      renames_.add(*before.names, before.name, after.name);
    }
  }

  bool is_free_before(std::size_t i) const { return matching_.to_new[i] == kNone; }
  bool is_free_after(std::size_t i) const { return matching_.to_old[i] == kNone; }

  /// The key of a bucket: the kind, the parent, and a further criterion.
  static std::string key_of(const Thing& thing, std::size_t new_parent, std::string_view more) {
    return thing.kind + '\0' + std::to_string(new_parent) + '\0' + std::string(more);
  }

  /// Calls `visit` with all buckets of unmatched things of a kind, in the order of the old
  /// version. `more` returns the further criterion for a thing and its index, or none to skip the
  /// thing.
  template <class More, class Visit>
  void for_each_bucket(const Candidates& candidates, const More& more, const Visit& visit) {
    std::map<std::string, std::size_t> places;
    std::vector<Bucket> buckets;
    const auto bucket_of = [&](const std::string& key) -> Bucket& {
      const auto [place, is_new] = places.try_emplace(key, buckets.size());
      if (is_new) buckets.emplace_back();
      return buckets[place->second];
    };
    for (const std::size_t i : candidates.before) {
      const Thing& thing = before_.all[i];
      if (!is_free_before(i)) continue;
      const std::size_t parent = thing.parent == kNone ? kNone : matching_.to_new[thing.parent];
      if (parent == kNone && thing.parent != kNone) continue;
      if (const auto decides = more(thing, i, true)) {
        bucket_of(key_of(thing, parent, *decides)).before.push_back(i);
      }
    }
    for (const std::size_t i : candidates.after) {
      const Thing& thing = after_.all[i];
      if (!is_free_after(i)) continue;
      if (const auto decides = more(thing, i, false)) {
        bucket_of(key_of(thing, thing.parent, *decides)).after.push_back(i);
      }
    }
    for (const Bucket& bucket : buckets) visit(bucket);
  }

  void match_kind(Kind kind) {
    for (auto level = kinds_before_.lower_bound({kind, 0});
         level != kinds_before_.end() && level->first.first == kind; ++level) {
      match_by_name(of_kind(kind, level->first.second));
      match_by_content(of_kind(kind, level->first.second));
    }
    if (kind) close(*kind);
  }

  void match_by_name(const Candidates& candidates) {
    const auto name = [&](const Thing& thing, std::size_t, bool is_before) {
      const bool is_reference = is_before && !thing.names;
      return std::optional(is_reference ? renames_.translate(thing.name, thing.place) : thing.name);
    };
    for_each_bucket(candidates, name, [&](const Bucket& bucket) { match_bucket(bucket); });
  }

  /// Matches things of one name, or without name: equal ones first, the others in order.
  void match_bucket(const Bucket& bucket) {
    if (bucket.before.size() > 1 || bucket.after.size() > 1) {
      std::unordered_map<std::uint64_t, std::deque<std::size_t>> equal;
      for (const std::size_t i : bucket.after) equal[hash_after(i)].push_back(i);
      for (const std::size_t i : bucket.before) {
        std::deque<std::size_t>& found = equal[hash_before(i)];
        if (found.empty()) continue;
        pair(i, found.front());
        found.pop_front();
      }
    }
    pair_in_order(bucket);
  }

  void pair_in_order(const Bucket& bucket) {
    auto next = bucket.after.begin();
    for (const std::size_t i : bucket.before) {
      if (!is_free_before(i)) continue;
      while (next != bucket.after.end() && !is_free_after(*next)) ++next;
      if (next == bucket.after.end()) return;
      pair(i, *next);
    }
  }

  /// Matches renamed things by content. A thing without content matches nothing.
  void match_by_content(const Candidates& candidates) {
    const auto content = [&](const Thing& thing, std::size_t i, bool is_before) {
      const std::uint64_t hash = is_before ? hash_before(i) : hash_after(i);
      const bool says_nothing = hash == hash_of_text(thing.kind) && thing.brings == kNone;
      return says_nothing ? std::nullopt : std::optional(std::to_string(hash));
    };
    for_each_bucket(candidates, content, [&](const Bucket& bucket) { pair_in_order(bucket); });
  }

  std::uint64_t hash_before(std::size_t i) const {
    return hash_with_parts(before_.all, i, parts_before_, renames_);
  }
  std::uint64_t hash_after(std::size_t i) const {
    return hash_with_parts(after_.all, i, parts_after_, names_after_);
  }
  static std::uint64_t hash_with_parts(const std::vector<Thing>& things, std::size_t i,
                                       const Parts& parts, const Renames& names) {
    std::uint64_t hash = hash_of_text(things[i].kind);
    if (const std::uint64_t own = hash_of(things[i].properties, names); own != 0)
      hash = mixed(hash, own);
    const auto found = parts.find(i);
    if (found == parts.end()) return hash;
    std::uint64_t sum = 0;
    for (const std::size_t part : found->second) {
      sum += mixed(hash_of_text(things[part].kind), hash_of(things[part].properties, names));
    }
    return mixed(hash, sum);
  }

  // Links and joints.

  static std::size_t thing_of(const std::vector<std::size_t>& things,
                              std::optional<LinkIndex> link) {
    return link ? things[to_size(*link)] : kNone;
  }

  /// The index of a link or joint by its thing.
  static std::unordered_map<std::size_t, std::size_t>
  numbers_of(const std::vector<std::size_t>& things) {
    std::unordered_map<std::size_t, std::size_t> numbers;
    for (std::size_t i = 0; i < things.size(); ++i) numbers.emplace(things[i], i);
    return numbers;
  }

  /// Matches links that have a matched joint above or below, and joints between matched links, and
  /// repeats this from every new pair.
  void follow_tree() {
    if (before_.tree == nullptr || after_.tree == nullptr) return queue_.clear();
    if (links_before_.empty()) {
      links_before_ = numbers_of(before_.links);
      joints_before_ = numbers_of(before_.joints);
      links_after_ = numbers_of(after_.links);
      joints_after_ = numbers_of(after_.joints);
    }
    while (!queue_.empty()) {
      const std::size_t next = queue_.front();
      queue_.pop_front();
      if (before_.all[next].names == NameKind::joint) {
        match_ends(joints_before_.at(next), joints_after_.at(matching_.to_new[next]));
      } else {
        match_joints_at(links_before_.at(next), links_after_.at(matching_.to_new[next]));
      }
    }
  }

  void match_in_tree(std::size_t old_thing, std::size_t new_thing) {
    if (old_thing == kNone || new_thing == kNone) return;
    if (!is_free_before(old_thing) || !is_free_after(new_thing)) return;
    pair(old_thing, new_thing);
  }

  void match_roots() {
    if (before_.tree == nullptr || after_.tree == nullptr) return;
    if (before_.tree->roots.size() != 1 || after_.tree->roots.size() != 1) return;
    const std::size_t old_root = before_.links[to_size(before_.tree->roots[0])];
    const std::size_t new_root = after_.links[to_size(after_.tree->roots[0])];
    if (hash_before(old_root) == hash_after(new_root)) match_in_tree(old_root, new_root);
  }

  void match_ends(std::size_t old_joint, std::size_t new_joint) {
    const KinematicTree& before = *before_.tree;
    const KinematicTree& after = *after_.tree;
    match_in_tree(thing_of(before_.links, before.joint_child[old_joint]),
                  thing_of(after_.links, after.joint_child[new_joint]));
    match_in_tree(thing_of(before_.links, before.joint_parent[old_joint]),
                  thing_of(after_.links, after.joint_parent[new_joint]));
  }

  /// Matches the joint above a link if its parents match, and equal joints below.
  void match_joints_at(std::size_t old_link, std::size_t new_link) {
    const auto old_joint = before_.tree->parent_joint[old_link];
    const auto new_joint = after_.tree->parent_joint[new_link];
    if (old_joint && new_joint) {
      const std::size_t parent =
          thing_of(before_.links, before_.tree->joint_parent[to_size(*old_joint)]);
      const std::size_t new_parent =
          thing_of(after_.links, after_.tree->joint_parent[to_size(*new_joint)]);
      if (parent != kNone && matching_.to_new[parent] == new_parent) {
        match_in_tree(before_.joints[to_size(*old_joint)], after_.joints[to_size(*new_joint)]);
      }
    }
    std::unordered_map<std::uint64_t, std::deque<std::size_t>> equal;
    for (const JointIndex joint : after_.tree->child_joints[new_link]) {
      const std::size_t thing = after_.joints[to_size(joint)];
      if (is_free_after(thing)) equal[hash_after(thing)].push_back(thing);
    }
    if (equal.empty()) return;
    for (const JointIndex joint : before_.tree->child_joints[old_link]) {
      const std::size_t thing = before_.joints[to_size(joint)];
      if (!is_free_before(thing)) continue;
      std::deque<std::size_t>& found = equal[hash_before(thing)];
      if (found.empty()) continue;
      match_in_tree(thing, found.front());
      found.pop_front();
    }
  }

  const Things& before_;
  const Things& after_;
  Renames& renames_;
  Renames names_after_;  ///< without renames: tells which names are still open
  Matching matching_;
  Parts parts_before_, parts_after_;
  Kinds kinds_before_, kinds_after_;
  std::deque<std::pair<std::size_t, std::size_t>> scenes_;  ///< their entities are matched next
  std::deque<std::size_t> queue_;  ///< old links and joints whose neighbours are matched next
  std::unordered_map<std::size_t, std::size_t> links_before_, joints_before_, links_after_,
      joints_after_;
};

}  // namespace

std::uint64_t hash_of(const Property& property, const Renames& names) {
  if (property.is_default) return 0;
  switch (property.form) {
  case Property::Form::absent: return 0;
  case Property::Form::text: return hash_of_name(property.text, property.span, names);
  case Property::Form::texts: return hash_of_texts(property.texts, names);
  case Property::Form::file: return hash_of_text(path::file_name(property.text));
  case Property::Form::list:
  case Property::Form::group:
  case Property::Form::choice: return hash_of_members(property, names);
  default: return hash_of_numbers(property.numbers);
  }
}

Matching match(const Things& before, const Things& after, Renames& renames) {
  return Matcher(before, after, renames).run();
}

}  // namespace smurf
