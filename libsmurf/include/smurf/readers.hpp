// SPDX-License-Identifier: BSD-3-Clause
// The programs that read URDF, SMURF and SMURFS, and what each makes of what the rules find.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// What a reader does with a construct, mildest first.
enum class Effect : std::uint8_t {
  takes,    ///< as it is meant
  ignores,  ///< has no use for it, and nothing else changes
  changes,  ///< silently makes something else of it
  loses,    ///< silently leaves a part of the robot out
  breaks,   ///< reports an error and goes on with the rest
  refuses,  ///< does not load the file
  crashes   ///< ends or hangs, with the program it is part of
};
std::string_view to_string(Effect effect);

/// One thing that is known of one reader.
struct ReaderFact {
  std::string_view rule;  ///< id or prefix of the rules whose findings it is about
  Effect effect = Effect::takes;
  std::string_view makes;   ///< "reads the missing limit as 0"; completes "MuJoCo ..."
  std::string_view source;  ///< file and line, or the version that was executed
  /// Only findings with this in their path, such as "/joint/", "/@xyz/" or "#dae"; see fact_path().
  std::string_view where = {};
};

/// Facts are asked in order, the first that fits wins; then those of `like`.
struct Reader {
  std::string_view name;   ///< what `--target` takes: "mujoco"
  std::string_view title;  ///< "MuJoCo"
  std::string_view basis;  ///< which version, and whether it was executed or read
  const Reader* like = nullptr;
  std::span<const ReaderFact> facts;
  bool is_target = true;  ///< false for what other readers are built on
};

/// In the order of the table; those that are no target included.
std::span<const Reader* const> all_readers();
/// Null when there is no such target.
const Reader* find_target(std::string_view name);
std::vector<std::string_view> target_names();

/// Where a finding is, as facts see it: its XPath or YAML pointer without predicates and indices,
/// then its construct: "/robot/link/collision/geometry/mesh/@filename/#dae".
std::string fact_path(const Diagnostic& diagnostic);
/// What the reader makes of it; null when nothing is known, or what is known is that it takes it.
const ReaderFact* find_fact(const Reader& reader, const Diagnostic& diagnostic);
/// Is anything known about a rule: of this reader, or of any.
bool has_facts(const Reader& reader, const Rule& rule);
bool has_facts(const Rule& rule);

/// A fact and whose it is.
struct KnownFact {
  const Reader* reader = nullptr;
  const ReaderFact* fact = nullptr;
};
/// All that is known about a rule, in the order of the table.
std::vector<KnownFact> facts_about(const Rule& rule);

/// What becomes of the files in one reader.
struct TargetVerdict {
  const Reader* reader = nullptr;
  std::size_t refusals = 0;  ///< findings it refuses or crashes on
  std::size_t losses = 0;    ///< findings that leave something out or make something else of it
  const Diagnostic* first = nullptr;  ///< the first refusal, else the first loss
  const ReaderFact* fact = nullptr;   ///< about `first`
};
/// "takes", "loses" or "refuses".
std::string_view to_word(const TargetVerdict& verdict);
TargetVerdict judge_target(const Reader& reader, std::span<const Diagnostic> diagnostics);

}  // namespace smurf
