// SPDX-License-Identifier: BSD-3-Clause
#include "diff/compare.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/files/path.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "diff/values.hpp"

namespace smurf {
namespace {

using Form = Property::Form;

/// Whether readers treat the value as absent.
bool is_nothing(const Property& property) {
  if (property.is_default || property.form == Form::absent) return true;
  if (property.form == Form::texts) return property.texts.empty();
  if (property.form != Form::group && property.form != Form::list) return false;
  return std::all_of(property.members.begin(), property.members.end(), is_nothing);
}

bool is_list_of_values(const Property& property) {
  return std::none_of(property.members.begin(), property.members.end(),
                      [](const Property& member) { return member.has_members(); });
}

constexpr std::size_t kLongestName = 1000;

/// The place for a property that one version lacks.
Span beside(Span span) { return {span.source, span.begin, span.begin}; }

/// Pairs members with the same key, such as an attribute and an element of one name, in their
/// order.
class KeyCounter {
 public:
  std::string unique(std::string_view name) {
    const std::string key(name);
    const std::size_t number = ++counts_[key];
    return number == 1 ? key : key + '\0' + std::to_string(number);
  }

 private:
  std::map<std::string, std::size_t> counts_;
};

/// A thing that is in both versions.
class PropertyComparer {
 public:
  PropertyComparer(const Renames& renames, const DiffOptions& options, FileContents& contents,
                   Difference frame, std::vector<Difference>& out)
      : renames_(renames),
        options_(options),
        contents_(contents),
        frame_(std::move(frame)),
        out_(out) {}

  /// With `is_list`, the keys are names of items.
  void compare_members(const Property& before, const Property& after, const std::string& path,
                       bool is_list = false) {
    std::map<std::string, const Property*> old_members;
    KeyCounter old_keys, new_keys;
    for (const Property& member : before.members) {
      old_members.emplace(old_keys.unique(renames_.translate(member.key, member.key_span)),
                          &member);
    }
    std::unordered_set<const Property*> seen;
    for (const Property& member : after.members) {
      const auto old_member = old_members.find(new_keys.unique(member.key));
      if (old_member == old_members.end()) {
        compare_with_nothing(member, false, joined(path, member.key, is_list), before.span);
      } else {
        seen.insert(old_member->second);
        compare(*old_member->second, member, joined(path, member.key, is_list));
      }
    }
    for (const Property& member : before.members) {
      if (seen.contains(&member)) continue;
      const std::string name = renames_.translate(member.key, member.key_span);
      compare_with_nothing(member, true, joined(path, name, is_list), after.span);
    }
  }

 private:
  bool is_full() const { return out_.size() > options_.limits.differences; }

  /// Every difference below repeats the path, so its length is limited.
  static std::string joined(const std::string& path, std::string_view key, bool is_item = false) {
    constexpr std::size_t kLongest = 300;
    const std::string step = shortened(key, kLongest);
    if (is_item) return shortened(path + "[" + step + "]", kLongest);
    if (path.empty() || step.empty()) return path + step;
    return shortened(path + "." + step, kLongest);
  }

  void compare(const Property& before, const Property& after, const std::string& path) {
    if (is_full()) return;
    const bool is_one_type = before.form == after.form;
    if (!is_one_type || !after.has_members()) {
      if (!is_same(before, after)) report(path, before, after);
    } else if (after.form == Form::list) {
      compare_lists(before, after, path);
    } else if (after.form == Form::choice && before.text != after.text) {
      report(path, before, after);
    } else {
      compare_members(before, after, after.form == Form::choice ? after.text : path);
    }
  }

  bool is_same(const Property& before, const Property& after) {
    if (is_nothing(before) && is_nothing(after)) return true;
    if (before.form == Form::file && after.form == Form::file) {
      if (!before.path.empty() && !after.path.empty() && options_.files != nullptr) {
        return before.path == after.path ||
               contents_.are_same(std::string(before.path), std::string(after.path));
      }
      return before.text == after.text;
    }
    if (before.form == Form::texts && after.form == Form::texts) {
      return std::equal(before.texts.begin(), before.texts.end(), after.texts.begin(),
                        after.texts.end(), [&](const auto& a, const auto& b) {
                          return renames_.translate(a.value, a.span) == b.value;
                        });
    }
    return is_same_leaf(before, renames_.translate(before.text, before.span), after,
                        options_.tolerance);
  }

  /// Reports a property that one version lacks; for a group with one value, that value.
  void compare_with_nothing(const Property& property, bool is_old, const std::string& path,
                            Span other) {
    if (is_nothing(property) || is_full()) return;
    const bool is_group = property.form == Form::group;
    if (is_group && std::count_if(property.members.begin(), property.members.end(),
                                  [](const Property& one) { return !is_nothing(one); }) == 1) {
      for (const Property& member : property.members) {
        compare_with_nothing(member, is_old, joined(path, member.key), other);
      }
      return;
    }
    Difference& difference = add(path, property);
    (is_old ? difference.before : difference.after) = value_of(property);
    difference.old_place = is_old ? property.span : beside(other);
    difference.new_place = is_old ? beside(other) : property.span;
  }

  void compare_lists(const Property& before, const Property& after, const std::string& path) {
    // Items with names are paired by name, in any order.
    if (are_named(before) && are_named(after)) return compare_members(before, after, path, true);
    const bool is_long_as_before = before.members.size() == after.members.size();
    if (is_list_of_values(before) && is_list_of_values(after)) {
      const bool is_equal =
          is_long_as_before &&
          std::equal(before.members.begin(), before.members.end(), after.members.begin(),
                     [&](const Property& a, const Property& b) { return is_same(a, b); });
      if (!is_equal) report(path, before, after);
    } else if (is_long_as_before) {
      for (std::size_t i = 0; i < after.members.size(); ++i) {
        compare(before.members[i], after.members[i], path + "[" + std::to_string(i) + "]");
      }
    } else {
      report(path, before, after);
    }
  }

  static bool are_named(const Property& list) {
    std::map<std::string_view, bool> seen;
    return std::all_of(list.members.begin(), list.members.end(), [&](const Property& member) {
      return !member.key.empty() && !std::exchange(seen[member.key], true);
    });
  }

  /// "a was renamed to b, c was renamed to d and 3 more".
  static std::string renames_in(const std::map<std::string, std::string, std::less<>>& renamed) {
    std::vector<std::string> all;
    for (const auto& [name, other] : renamed) all.push_back(name + " was renamed to " + other);
    constexpr std::size_t kMost = 3;
    return shortlist(all, kMost);
  }

  Difference& add(const std::string& path, const Property& property) {
    Difference& difference = out_.emplace_back(frame_);
    difference.property = path;
    difference.unit = property.unit;
    difference.fallback = property.fallback;
    difference.parts = property.parts;
    return difference;
  }

  void report(const std::string& path, const Property& before, const Property& after) {
    Difference& difference = add(path, after);
    difference.before = value_of(before);
    difference.after = value_of(after);
    if (difference.before == difference.after) {  // the old name of a renamed thing
      std::map<std::string, std::string, std::less<>> renamed;
      const DiffValue meant = value_of(before, [&](std::string_view name, Span place) {
        std::string translated = renames_.translate(name, place);
        if (translated != name) renamed.try_emplace(std::string(name), translated);
        return translated;
      });
      const bool is_list = after.form == Form::texts || after.form == Form::list;
      difference.detail =
          is_list ? renames_in(renamed) : "which was renamed to " + value_text(meant, {}, {});
    }
    difference.old_place = before.span;
    difference.new_place = after.span;
    if (before.form == Property::Form::file && after.form == Property::Form::file &&
        options_.files != nullptr && before.text == after.text) {
      difference.detail = contents_.difference(std::string(before.path), std::string(after.path));
    }
  }

  const Renames& renames_;
  const DiffOptions& options_;
  FileContents& contents_;
  const Difference frame_;
  std::vector<Difference>& out_;
};

class Comparison {
 public:
  Comparison(const Things& before, const Things& after, const Matching& matching,
             const Renames& renames, const DiffOptions& options, FileContents& contents)
      : before_(before),
        after_(after),
        matching_(matching),
        renames_(renames),
        options_(options),
        contents_(contents),
        numbers_before_(numbers_of(before)),
        numbers_after_(numbers_of(after)) {}

  std::vector<Difference> run() {
    for (std::size_t i = 0; i < after_.all.size() && !is_full(); ++i) {
      if (matching_.to_old[i] == kNone) {
        if (is_alone(after_, matching_.to_old, i)) add_whole(Change::added, after_, i);
      } else {
        compare_things(matching_.to_old[i], i);
      }
    }
    for (std::size_t i = 0; i < before_.all.size() && !is_full(); ++i) {
      if (matching_.to_new[i] != kNone || !is_alone(before_, matching_.to_new, i)) continue;
      add_whole(Change::removed, before_, i);
    }
    return std::move(out_);
  }

 private:
  bool is_full() const { return out_.size() > options_.limits.differences; }

  /// Parts of a thing that was added or removed as a whole are not reported.
  static bool is_alone(const Things& things, const std::vector<std::size_t>& others,
                       std::size_t i) {
    const std::size_t parent = things.all[i].parent;
    if (things.all[i].is_scene) return false;  // the entity that brings it is reported
    return parent == kNone || others[parent] != kNone;
  }

  /// The number of a thing among things without name in the same parent; 0 for the only one.
  static std::vector<std::size_t> numbers_of(const Things& things) {
    std::vector<std::size_t> numbers(things.all.size());
    std::map<std::string, std::vector<std::size_t>> unnamed;
    for (std::size_t i = 0; i < things.all.size(); ++i) {
      const Thing& thing = things.all[i];
      if (thing.name.empty() && !thing.is_scene)
        unnamed[thing.kind + '\0' + std::to_string(thing.parent)].push_back(i);
    }
    for (const auto& [key, found] : unnamed) {
      if (found.size() < 2) continue;
      for (std::size_t i = 0; i < found.size(); ++i) numbers[found[i]] = i + 1;
    }
    return numbers;
  }

  /// Every difference of the thing repeats this text, so its length is limited.
  static std::string shown_name(const Thing& thing) {
    return shortened(thing.path.empty() ? thing.name : thing.path, kLongestName);
  }
  static std::string shown_kind(const Thing& thing) { return shortened(thing.kind, kLongestName); }

  Difference frame_of(const Things& things, std::size_t i) const {
    const Thing& thing = things.all[i];
    Difference frame;
    frame.kind = shown_kind(thing);
    frame.name = shown_name(thing);
    frame.number = (&things == &before_ ? numbers_before_ : numbers_after_)[i];
    if (thing.parent != kNone && !things.all[thing.parent].is_scene) {
      const Thing& owner = things.all[thing.parent];
      frame.owner = shown_kind(owner) + (owner.name.empty() ? "" : " " + shown_name(owner));
    }
    return frame;
  }

  void add_whole(Change change, const Things& things, std::size_t i) {
    Difference difference = frame_of(things, i);
    difference.change = change;
    if (change == Change::added) {
      difference.new_place = things.all[i].place;
    } else {
      difference.old_place = things.all[i].place;
    }
    out_.push_back(std::move(difference));
  }

  void compare_things(std::size_t old_thing, std::size_t new_thing) {
    const Thing& before = before_.all[old_thing];
    const Thing& after = after_.all[new_thing];
    const Difference frame = frame_of(after_, new_thing);
    const std::string name =
        before.names ? before.name : renames_.translate(before.name, before.place);
    // An annotation may still have the old name of a renamed joint; lists that name it say so.
    const bool is_left_behind = before.name == after.name;
    if (name != after.name && !is_left_behind) {
      Difference& difference = out_.emplace_back(frame);
      difference.change = Change::renamed;
      difference.old_name = shown_name(before);
      difference.old_place = before.place;
      difference.new_place = after.place;
    }
    const std::size_t first = out_.size();
    PropertyComparer(renames_, options_, contents_, frame, out_)
        .compare_members(before.properties, after.properties, {});
    tell_effect(new_thing, first);
  }

  /// A moved joint moves all links below it; these are counted, not reported one by one.
  void tell_effect(std::size_t new_thing, std::size_t first) {
    if (after_.all[new_thing].names != NameKind::joint) return;
    for (std::size_t i = first; i < out_.size(); ++i) {
      const std::string& property = out_[i].property;
      if (property != "pose" && property != "parent") continue;
      const std::size_t links = links_below(new_thing);
      if (links == 0) continue;
      out_[i].detail = "moves " + std::to_string(links) + (links == 1 ? " link" : " links");
    }
  }

  std::size_t links_below(std::size_t joint) {
    if (after_.tree == nullptr) return 0;
    if (below_.empty()) count_below();
    const auto number = joints_.find(joint);
    if (number == joints_.end()) return 0;
    const auto child = after_.tree->joint_child[number->second];
    return child ? below_[to_size(*child)] : 0;
  }

  void count_below() {
    const KinematicTree& tree = *after_.tree;
    for (std::size_t i = 0; i < after_.joints.size(); ++i) joints_.emplace(after_.joints[i], i);
    below_.assign(tree.parent_joint.size(), 1);
    for (auto link = tree.order.rbegin(); link != tree.order.rend(); ++link) {
      const auto joint = tree.parent_joint[to_size(*link)];
      const auto parent = joint ? tree.joint_parent[to_size(*joint)] : std::nullopt;
      if (parent) below_[to_size(*parent)] += below_[to_size(*link)];
    }
  }

  const Things& before_;
  const Things& after_;
  const Matching& matching_;
  const Renames& renames_;
  const DiffOptions& options_;
  FileContents& contents_;
  std::vector<std::size_t> numbers_before_, numbers_after_;
  std::vector<std::size_t> below_;  ///< number of links below and itself, by link
  std::unordered_map<std::size_t, std::size_t> joints_;  ///< by thing
  std::vector<Difference> out_;
};

}  // namespace

bool FileContents::are_same(const std::string& a, const std::string& b) {
  if (options_.files->identity(a) == options_.files->identity(b)) return true;
  const std::string first = digest(a);
  const std::string& second = digest(b);
  if (first.empty() && second.empty()) return path::file_name(a) == path::file_name(b);
  return first == second;
}

std::string_view FileContents::difference(const std::string& a, const std::string& b) {
  if (a.empty() || digest(a).empty()) return "the old file cannot be read";
  if (b.empty() || digest(b).empty()) return "the new file cannot be read";
  return "the contents differ";
}

/// Not cryptographic, because a collision gives no advantage to anyone.
const std::string& FileContents::digest(const std::string& path) {
  const auto [place, is_new] = digests_.try_emplace(path);
  if (!is_new) return place->second;
  const FileContent content = options_.files->read(path, options_.limits.mesh_bytes);
  if (content.status != ReadStatus::ok) return place->second;
  place->second = std::to_string(content.text.size()) + "-" +
                  std::to_string(std::hash<std::string>{}(content.text));
  return place->second;
}

std::vector<Difference> compare(const Things& before, const Things& after, const Matching& matching,
                                const Renames& renames, const DiffOptions& options,
                                FileContents& contents) {
  return Comparison(before, after, matching, renames, options, contents).run();
}

}  // namespace smurf
