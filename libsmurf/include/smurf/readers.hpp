// SPDX-License-Identifier: BSD-3-Clause
// The programs that read URDF, SMURF and SMURFS, and the effects of findings on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"

namespace smurf {

std::string_view to_string(Effect effect);

/// One rule, or all rules whose ids have a common beginning, such as those about numbers: "SML18".
class RuleFamily {
 public:
  constexpr RuleFamily() = default;
  constexpr RuleFamily(const Rule& rule) : rule_(&rule) {}
  constexpr RuleFamily(const char* beginning) : beginning_(beginning) {}
  bool covers(const Rule& rule) const {
    return rule_ != nullptr ? &rule == rule_ : rule.id.starts_with(beginning_);
  }
  /// "SML1508", "SML18"
  std::string_view id() const { return rule_ != nullptr ? rule_->id : beginning_; }

 private:
  const Rule* rule_ = nullptr;
  std::string_view beginning_;
};

/// A fact of a reader about a family.
struct FamilyFact {
  RuleFamily family;
  Fact fact;
};

/// A version of a reader, or of one that it is built on.
struct ReaderVersion {
  const Reader* reader = nullptr;
  Version version{};
};

/// A program that reads robots. Facts about it are in the rows of the rules.
struct Reader {
  std::string_view name;     ///< the value of `--target`: "mujoco"
  std::string_view title{};  ///< "MuJoCo"
  std::string_view basis{};  ///< which version, and whether it was executed or read
  const Reader* like = nullptr;
  /// The version that was run: facts whose evidence is kRun were seen with it.
  std::string_view version{};
  std::span<const FamilyFact> families{};
  bool is_target = true;           ///< false for libraries that other readers are built on
  bool reads_annotations = false;  ///< findings in annotations affect it
  /// Parts of a URDF that it does not look at: findings there do not affect it.
  std::span<const Fact> unread{};
  /// The version to which facts with a range of versions are compared; that of `version`.
  Version number{};
  /// Of a release such as "ros:jazzy": the versions in it, of readers that it is like.
  std::span<const ReaderVersion> parts{};
  /// Its releases that are supported, oldest first: "ros:humble". Without a release, the oldest is
  /// meant.
  std::span<const Reader* const> releases{};
  /// Releases before these, oldest first. They can be targets, too.
  std::span<const Reader* const> earlier{};
  /// Adds to findings in a model the circumstances that facts about this reader need. May be null.
  void (*see)(const LinkedModel&, std::span<Diagnostic* const>) = nullptr;
  /// Of findings in parts that it reads, but does not build: only facts of `like` are about them.
  const Circumstance* drops = nullptr;
};

/// All readers in the order of the table, including those that are not targets.
std::span<const Reader* const> all_readers();
/// Finds a target by name, also one of its releases ("ros:jazzy"); null for an unknown name.
const Reader* find_target(std::string_view name);
std::vector<std::string_view> target_names();

/// The names of a finding's XPath or YAML pointer that facts know, without predicates, indices and
/// names that users give: /robot/link/collision/geometry/mesh/@filename. Others are PlaceName{}.
std::vector<PlaceName> place_of(const Diagnostic& diagnostic);
/// Whether a path contains the place.
bool contains(std::span<const PlaceName> path, const Where& where);
/// Whether there is a fact about a rule: for this reader, or for any.
bool has_facts(const Reader& reader, const Rule& rule);
bool has_facts(const Rule& rule);
/// All facts about a rule and its family, in the order of the readers.
std::vector<const Fact*> facts_about(const Rule& rule);
/// The evidence of a fact: the version that was run, or "Drake joint.h:159".
std::string evidence_of(const Fact& fact);
/// "MuJoCo (visual): discards visuals"
std::string describe(const Fact& fact);
/// What to do for single readers, where it differs from the remedy: "PyBullet: couple the joints".
std::vector<std::string> cures_of(const Rule& rule);
/// "mass/@value, too large, before 3.13"; empty for all findings in all versions.
std::string describe(const Where& where);
/// The evidence of all facts about a rule, without repetitions, and the rule's own sources.
std::string sources_of(const Rule& rule);

}  // namespace smurf
