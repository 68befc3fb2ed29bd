// SPDX-License-Identifier: BSD-3-Clause
// Rules, diagnostics and the sink that every stage reports into.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/limits.hpp"
#include "smurf/source.hpp"

namespace smurf {

struct Companions;
struct LinkedModel;
struct LinkedScene;
class Findings;

enum class Severity : std::uint8_t { info, warning, error };
std::string_view to_string(Severity severity);

/// The effect of a construct on a reader, mildest first.
enum class Effect : std::uint8_t {
  takes,    ///< reads it as intended
  ignores,  ///< does not use it, and nothing else changes
  changes,  ///< silently builds something else
  loses,    ///< silently leaves a part of the robot out
  breaks,   ///< reports an error and continues with the rest
  refuses,  ///< does not load the file
  crashes   ///< crashes or never terminates
};

struct Reader;

/// What readers distinguish among the findings of a rule: a case of the rule, such as a hexadecimal
/// number, or a circumstance that a reader sees, such as a link that is fixed to another. Define
/// each once, as a constant beside the check: its address is its identity.
struct Circumstance {
  std::string_view name;  ///< in words, for users: "too large"
  /// The only reader for which authors write such elements; nothing is reported if it loads them.
  const Reader* written_for = nullptr;
};

/// The cases of a finding. Their order does not count.
class Circumstances {
 public:
  void add(const Circumstance& one) {
    const auto place = std::lower_bound(cases_.begin(), cases_.end(), &one, std::less<>());
    if (place == cases_.end() || *place != &one) cases_.insert(place, &one);
  }
  void add(const Circumstance&&) = delete;  // only constants have an identity
  bool contains(const Circumstance& one) const {
    return std::find(cases_.begin(), cases_.end(), &one) != cases_.end();
  }
  bool empty() const { return cases_.empty(); }
  friend bool operator==(const Circumstances&, const Circumstances&) = default;
  friend bool operator<(const Circumstances& a, const Circumstances& b) {
    return a.cases_ < b.cases_;
  }

 private:
  std::vector<const Circumstance*> cases_;
};

/// An element, attribute or key that facts name. at() in base/findings/place_names.hpp makes it of
/// a text.
enum class PlaceName : std::uint8_t {};

/// The version of a reader: 12.7.2.
struct Version {
  std::uint16_t major = 0, minor = 0, patch = 0;
  auto operator<=>(const Version&) const = default;
};

/// The findings, and the versions of the reader, that a fact is about. All parts must apply.
struct Where {
  static constexpr std::size_t kMostNames = 4, kMostCases = 3;

  std::array<PlaceName, kMostNames> place{};  ///< names that follow each other in its path
  std::array<const Circumstance*, kMostCases> cases{};  ///< the finding has all of these
  const Circumstance* except = nullptr;                 ///< and not this one
  Version from{};                                       ///< the first version
  Version until{};  ///< the first later version without it; 0: none

  /// Only findings with these cases.
  template <std::same_as<Circumstance>... C>
  consteval Where when(const C&... more) const {
    Where out = *this;
    std::size_t next = 0;
    while (out.cases.at(next) != nullptr) ++next;
    ((out.cases.at(next++) = &more), ...);
    return out;
  }
  /// Only findings without this case.
  consteval Where unless(const Circumstance& one) const {
    Where out = *this;
    out.except = &one;
    return out;
  }
  /// Only this version of the reader and later ones.
  consteval Where since(Version first) const {
    Where out = *this;
    out.from = first;
    return out;
  }
  /// Only versions of the reader before this one.
  consteval Where before(Version first) const {
    Where out = *this;
    out.until = first;
    return out;
  }
  constexpr bool needs(const Circumstance& one) const {
    for (const Circumstance* known : cases) {
      if (known == &one) return true;
    }
    return false;
  }
  bool operator==(const Where&) const = default;
};

/// Evidence for facts that were seen by running the reader, in the version of its row.
inline constexpr std::string_view kRun = "run";

/// The effect of a finding on one reader.
struct Fact {
  const Reader* reader = nullptr;
  Effect effect = Effect::takes;
  std::string_view makes;     ///< "reads the missing limit as 0"; completes "MuJoCo ..."
  std::string_view evidence;  ///< kRun, or the lines of its source
  Where where = {};           ///< `at("/joint/axis/")`, `when(kHex)`, `since({3, 13})`
  /// What to do for this reader, where it differs from the remedy of the rule: "use Drake's SAP".
  std::string_view cure = {};
};

/// What a rule asks. It decides what a target can change about its findings.
enum class About : std::uint8_t {
  readers,  ///< what programs make of the file: the facts decide
  robot,    ///< whether the robot is as it was meant: no target makes a finding milder
  format,   ///< whether the file follows its format; programs may read it anyway
};

/// From which languages a URDF that is made of a file takes the faulty part over as it is.
enum class TakenOver : std::uint8_t { never, from_sdf, always };

/// Which tool reports the findings of a rule.
enum class Tool : std::uint8_t { lint, load_check, converters };

/// The threshold of a rule, which a configuration may change.
struct Tolerance {
  double value = 0;
  std::string_view unit{};     ///< "rad"; empty for a ratio
  std::string_view meaning{};  ///< "how far the length may be from 1"; empty: there is none
};

/// A rule and its texts: the only source of `--explain`, docs/rules, docs/readers.md, SARIF
/// metadata,
/// `--list-rules` and the severities under `--target`.
struct Rule {
  std::string_view id;    ///< "SML3101"; never reused
  std::string_view name;  ///< kebab-case name of the fault: "unknown-joint"
  Severity severity = Severity::error;
  std::string_view summary;    ///< one sentence: the fault that it finds
  std::string_view why{};      ///< the reason why it matters, beyond the facts
  std::string_view remedy;     ///< what to do
  std::string_view sources{};  ///< sources of the rule, beyond the evidence of the facts

  /// Checks that the linter runs, each on its subject. The model of check_companions() has no robot
  /// if none was found for a companion.
  void (*check_model)(const LinkedModel&, Findings&) = nullptr;
  void (*check_companions)(const LinkedModel&, const Companions&, Findings&) = nullptr;
  void (*check_scene)(const LinkedScene&, Findings&) = nullptr;
  /// False for findings that a reader or writer reports itself.
  constexpr bool has_check() const {
    return check_model != nullptr || check_companions != nullptr || check_scene != nullptr;
  }

  /// Only run for targets that have a fact about the rule: others are not affected.
  bool needs_target = false;

  Tolerance tolerance{};  ///< use Findings::tolerance(), which includes the configuration

  /// The effects on readers. Facts about one reader are adjacent; the first matching one applies.
  std::span<const Fact> facts{};

  Tool reported_by = Tool::lint;
  About about = About::readers;
  bool blocks_building = false;  ///< no robot can be built from the file
  /// With other packages, arguments or limits, or in another program, there is no such fault.
  bool may_pass_elsewhere = false;
  /// Whether a finding in the URDF of an MJCF or SDF file is about that file, too.
  TakenOver taken_over = TakenOver::never;
};

/// A second place that explains a diagnostic, possibly in another file.
struct Label {
  Span span;
  std::string message;
};

/// Replaces the bytes of `span` by `text`; an empty span inserts.
struct Edit {
  Span span;
  std::string text;
};

enum class Applicability : std::uint8_t { safe, unsafe };

/// A remedy as byte edits. Safe fixes never change what the model means to any reader that loads
/// it.
struct Fix {
  /// A name that must be unique in its parent: a key of a mapping, or an attribute of an element.
  struct NewName {
    Span among;  ///< the mapping, the start tag, the robot
    std::string name;
    friend bool operator==(const NewName&, const NewName&) = default;
  };

  Applicability applicability = Applicability::unsafe;
  std::vector<Edit> edits;
  /// When two fixes create the same name, only the first is applied.
  std::optional<NewName> new_name = {};
};

/// A place of a finding, and what readers distinguish there. Effects are looked up for places.
struct Occurrence {
  Span span;
  /// The names of its pointer that facts know: robot, link, inertial. Others are PlaceName{}.
  std::vector<PlaceName> names = {};
  Circumstances cases = {};
  std::vector<const Rule*> consequences = {};
  std::size_t count = 1;  ///< how many places are like this one to every reader
};

/// A finding: the rule, the place, the message, and the fixes.
struct Diagnostic {
  const Rule* rule = nullptr;
  Severity severity = Severity::error;
  Span span;
  std::string message;  ///< one sentence, lower case, no full stop; names in backticks
  std::string caret;    ///< short text beside the caret; may be empty
  std::string pointer;  ///< YAML pointer or XPath; filled by locate() when empty
  /// The pointer by names, "/motors/name=elbow/joint": the same after other entries were added.
  std::string named_pointer;
  std::vector<PlaceName> names;  ///< see Occurrence; filled by locate()
  /// What readers distinguish: cases of the rule, and circumstances that locate() adds.
  Circumstances cases = {};
  /// Other rules that the finding also breaks: to readers, a misspelt `effort` is missing.
  std::vector<const Rule*> consequences;
  /// What is written about several of its kind in a file: "more links like it". Then they are one
  /// finding: see join_places().
  std::string_view others_are;
  std::uint32_t habit = 0;  ///< tells several of a rule in a file apart
  /// The other places, once they are joined.
  std::vector<Occurrence> others;
  /// Of a finding in an expanded robot: its place there, and the call of the macro around it.
  std::optional<Span> expanded;
  Span call;
  /// The severity before targets changed it; none if they did not change it.
  std::optional<Severity> untargeted;
  std::vector<Label> labels;
  std::vector<std::string> notes;  ///< facts without a place
  std::string help_text;           ///< what to do; may be empty
  std::vector<Fix> fixes;          ///< at most one at present
  /// The rule whose later findings were left out because of a limit; SML0002 means all rules.
  const Rule* left_out = nullptr;

  // Calls can be chained: report(...).when(kHex).label(...).help(...).
  /// Adds a case that readers distinguish; see Fact::where.
  Diagnostic& when(const Circumstance& one) {
    cases.add(one);
    return *this;
  }
  Diagnostic& when(const Circumstance&&) = delete;
  /// Adds a second place, with a short text.
  Diagnostic& label(Span place, std::string text);
  /// Adds a fact without a place.
  Diagnostic& note(std::string text);
  /// Adds the advice.
  Diagnostic& help(std::string text);
};

class SuggestionIndexes;

/// Indexes that are made when they are needed. A copy begins without.
class KeptIndexes {
 public:
  KeptIndexes();
  KeptIndexes(const KeptIndexes&);
  KeptIndexes& operator=(const KeptIndexes&);
  ~KeptIndexes();
  SuggestionIndexes& get();

 private:
  std::unique_ptr<SuggestionIndexes> indexes_;
};

/// Collects diagnostics. Passed by reference through all stages; never prints, never throws.
class DiagnosticSink {
 public:
  /// Keeps at most `most` findings of each rule, and `all` findings in total. The next finding
  /// becomes an SML0002. `suggestions` limits the work of suggest().
  explicit DiagnosticSink(std::uint64_t most = Limits{}.findings,
                          std::uint64_t suggestions = Limits{}.suggestions,
                          std::uint64_t all = Limits{}.all_findings)
      : most_(most),
        most_suggestions_(suggestions),
        suggestions_left_(suggestions),
        most_of_all_(all) {}
  /// Takes the limits of a run, which a user may have raised.
  explicit DiagnosticSink(const Limits& limits)
      : DiagnosticSink(limits.findings, limits.suggestions, limits.all_findings) {}

  /// The reference is valid until take(). Changes to a finding that is left out have no effect.
  Diagnostic& report(const Rule& rule, Span span, std::string message);
  /// The known name nearest to `name`, for the finding reported last. None if that finding is left
  /// out, or if all suggestions together exceed their limit, which an SML0002 reports. Use it for
  /// known names that come from a file.
  std::optional<std::string_view> suggest(std::string_view name,
                                          std::span<const std::string_view> known);

  /// Marks the finding at `place` as a fault of `rule`, too. take() joins the two.
  void add_consequence(Span place, const Rule& rule) { consequences_.push_back({place, &rule}); }

  const std::deque<Diagnostic>& diagnostics() const { return diagnostics_; }
  std::vector<Diagnostic> take();
  bool has_errors() const;
  /// How many findings of a rule were reported.
  std::uint64_t count_of(const Rule& rule) const;

 private:
  /// Reports that findings are left out from `span` on.
  void report_left_out(const Rule& rule, Span span, std::string message, std::string_view limit);

  std::uint64_t most_;
  std::uint64_t most_suggestions_;
  std::uint64_t suggestions_left_;
  KeptIndexes indexes_;                  ///< of the names in which suggest() searched
  std::optional<Span> suggestions_end_;  ///< the first finding without a suggestion
  bool is_last_left_out_ = false;
  std::map<const Rule*, std::uint64_t> counts_;
  std::deque<Diagnostic> diagnostics_;  ///< so that the results of report() stay valid
  std::vector<std::pair<Span, const Rule*>> consequences_;
  Diagnostic left_out_;
  std::uint64_t most_of_all_;
  bool is_full_ = false;  ///< findings of all rules are left out
};

/// All rules, ascending by id.
std::span<const Rule* const> all_rules();
/// The ids of all rules, then their names. Always the same list, so that all searches for names to
/// suggest use one index of it.
const std::vector<std::string_view>& rule_words();

/// Accepts an id ("SML3101") or a name ("unknown-joint"); null if there is no such rule.
const Rule* find_rule(std::string_view id_or_name);

}  // namespace smurf
