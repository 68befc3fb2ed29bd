// SPDX-License-Identifier: BSD-3-Clause
// The words of launch files: elements and attributes of XML and YAML, substitutions, classes of
// Python, as launch and launch_ros of humble, jazzy and rolling have them together.
#pragma once

#include <span>
#include <string_view>

namespace smurf::launch {

/// An element. Lists of words are separated by blanks.
struct Action {
  std::string_view name;  ///< "node"; of an element in another one: "node/param"
  /// Behind a colon what YAML must hold: nothing for a text, "truth" for a boolean or a text,
  /// "real" for a number with a point or a text, "count" for a whole number or a text, "any".
  std::string_view attributes;
  std::string_view required;
  std::string_view children;  ///< names; "*" stands for any actions
};
std::span<const Action> actions();
/// An element in `parent`, whose row is looked for first; null if there is none.
const Action* find_action(std::string_view parent, std::string_view name);

struct Substitution {
  std::string_view name;
  int least = 0, most = 0;  ///< values behind the name
};
std::span<const Substitution> substitutions();

/// A class of launch or launch_ros.
struct Class {
  std::string_view name;
  std::string_view keywords;
  std::string_view required;  ///< that have no default
  int positions = 0;          ///< of its keywords, which may be given without their names
};
std::span<const Class> classes();
/// Null if there is none.
const Class* find_class(std::string_view name);

/// A word of ROS 1 or of another class, and what stands for it in ROS 2.
struct OldWord {
  std::string_view place, word, now;  ///< place: the element, "$" for substitutions; now: help
};
std::span<const OldWord> old_words();

/// Whether a list of words separated by blanks has a word; what stands behind its colon.
bool has_word(std::string_view list, std::string_view word, std::string_view* mark = nullptr);

}  // namespace smurf::launch
