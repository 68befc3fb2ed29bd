// SPDX-License-Identifier: BSD-3-Clause
#include "schema/checked_schema.hpp"

#include <cmath>
#include <map>
#include <regex>
#include <string>
#include <utility>

#include "ast/keys.hpp"
#include "base/numbers.hpp"
#include "base/quoted.hpp"
#include "base/rules.hpp"
#include "base/suggest.hpp"

namespace smurf {
namespace {

using nlohmann::json;

/// Types of the values of keywords.
enum class Holds : std::uint8_t {
  nothing,  ///< not relevant to validation; dropped
  anything,
  any_list,
  number,
  count,
  boolean,
  texts,
  type,
  pattern,
  reference,
  schema,
  schemas,
  schemas_by_name,
  schemas_by_pattern,
  items,        ///< a schema, or a list of them
  dependencies  ///< by name: a schema, or a list of texts
};

struct Keyword {
  std::string_view name;
  Holds holds = Holds::anything;
  bool is_in_place = false;  ///< the schemas in it apply to the same value
};

constexpr Keyword kKeywords[] = {
    {"$comment", Holds::nothing},
    {"$defs", Holds::schemas_by_name},
    {"$id", Holds::nothing},
    {"$ref", Holds::reference, true},
    {"$schema", Holds::nothing},
    {"additionalItems", Holds::schema},
    {"additionalProperties", Holds::schema},
    {"allOf", Holds::schemas, true},
    {"anyOf", Holds::schemas, true},
    {"const", Holds::anything},
    {"contains", Holds::schema},
    {"contentEncoding", Holds::nothing},
    {"contentMediaType", Holds::nothing},
    {"default", Holds::nothing},
    {"definitions", Holds::schemas_by_name},
    {"dependencies", Holds::dependencies, true},
    {"description", Holds::nothing},
    {"else", Holds::schema, true},
    {"enum", Holds::any_list},
    {"examples", Holds::nothing},
    {"exclusiveMaximum", Holds::number},
    {"exclusiveMinimum", Holds::number},
    {"format", Holds::nothing},  // an annotation, as draft-07 allows
    {"if", Holds::schema, true},
    {"items", Holds::items},
    {"maxItems", Holds::count},
    {"maxLength", Holds::count},
    {"maxProperties", Holds::count},
    {"maximum", Holds::number},
    {"minItems", Holds::count},
    {"minLength", Holds::count},
    {"minProperties", Holds::count},
    {"minimum", Holds::number},
    {"multipleOf", Holds::number},
    {"not", Holds::schema, true},
    {"oneOf", Holds::schemas, true},
    {"pattern", Holds::pattern},
    {"patternProperties", Holds::schemas_by_pattern},
    {"properties", Holds::schemas_by_name},
    {"propertyNames", Holds::schema},
    {"readOnly", Holds::nothing},
    {"required", Holds::texts},
    {"then", Holds::schema, true},
    {"title", Holds::nothing},
    {"type", Holds::type},
    {"uniqueItems", Holds::boolean},
    {"writeOnly", Holds::nothing},
};

constexpr std::string_view kTypes[] = {"array",  "boolean", "integer", "null",
                                       "number", "object",  "string"};

/// Limits the schemas that apply to one value: their nesting depth and their number.
constexpr int kDeepest = 32;
constexpr double kMost = 256;
constexpr std::size_t kLongestPattern = 300;
/// Limits on the patterns of a schema. Each pattern uses memory, and each pattern of names is
/// matched again for every mapping.
constexpr std::size_t kMostPatternSteps = 500'000;
constexpr std::size_t kMostNamePatternSteps = 300;
constexpr int kMostNamePatterns = 1000;
/// Names, values and types that the library compares in one step.
constexpr std::size_t kItemsForStep = 16;

const Keyword* find_keyword(std::string_view name) {
  for (const Keyword& keyword : kKeywords) {
    if (keyword.name == name) return &keyword;
  }
  return nullptr;
}

/// The backtracking matcher of the library matches property names. Therefore, repeated groups,
/// which can need exponential time, are not allowed, and the number of repetitions is limited.
bool is_simple_pattern(std::string_view pattern) {
  int repetitions = 0;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const char next = i + 1 < pattern.size() ? pattern[i + 1] : ' ';
    if (pattern[i] == '\\') {
      if (next >= '1' && next <= '9') return false;
      ++i;
    } else if (pattern[i] == ')' && (next == '*' || next == '+' || next == '{')) {
      return false;
    } else if (pattern[i] == '*' || pattern[i] == '+' || pattern[i] == '{') {
      ++repetitions;
    }
  }
  return repetitions <= 2;
}

class SchemaChecker {
 public:
  SchemaChecker(yaml::View root, DiagnosticSink& sink) : root_(root), sink_(sink) {}

  std::optional<CheckedSchema> run() {
    if (size_of(root_) > kLargest) {
      fault(root_.span(), "the schema is too large");
      return std::nullopt;
    }
    json checked = schema(root_);
    resolve_references();
    for (const auto& [id, reached] : applied_) {
      if (!is_sound_) break;
      measure(id, {}, 0);
    }
    if (!is_sound_) return std::nullopt;
    return CheckedSchema{std::move(checked), std::move(guards_)};
  }

 private:
  struct Applied {
    yaml::NodeId schema;
    Span place;
  };
  struct Extent {
    int depth = 0;
    double count = 0;
    bool is_open = false;
  };

  Diagnostic& fault(Span place, std::string message) {
    is_sound_ = false;
    return sink_.report(rules::sml9011_broken_schema, place, std::move(message));
  }

  void expect(bool is_right, yaml::View value, std::string_view expected) {
    if (is_right) return;
    fault(value.place(),
          quoted(value.key()) + " must be " + std::string(expected) + ", not " + describe(value));
  }

  json schema(yaml::View node) {
    applied_[node.id()];
    if (node.boolean()) return *node.boolean();
    if (!node.is_mapping()) {
      fault(node.place(), "a schema must be a mapping, true or false, not " + describe(node));
      return true;
    }
    json checked = json::object();
    if (const yaml::View reference = node.find("$ref")) {  // other keys in this schema are ignored
      add_reference(node, reference);
      return json{{"$ref", std::string(reference.text())}};
    }
    SchemaGuard guard;
    for (const yaml::View value : node) {
      if (!value.is_repeated()) add_keyword(node, value, checked, guard);
    }
    add_guards(std::move(guard), checked);
    return checked;
  }

  /// The library checks the guard of a schema last, but guards in `allOf` before it compares items
  /// or matches names.
  void add_guards(SchemaGuard guard, json& checked) {
    if (guard.has_name_patterns || guard.has_unique_items) {
      checked["allOf"].push_back(json{{kGuardKey, guards_.size()}});
      guards_.push_back({.steps = guard.steps,
                         .has_name_patterns = std::exchange(guard.has_name_patterns, false),
                         .has_unique_items = std::exchange(guard.has_unique_items, false)});
    }
    checked[kGuardKey] = guards_.size();
    guards_.push_back(std::move(guard));
  }

  void add_keyword(yaml::View node, yaml::View value, json& checked, SchemaGuard& guard) {
    const Keyword* keyword = find_keyword(value.key());
    if (keyword == nullptr) return suggest_keyword(value);
    const std::string name(keyword->name);
    const bool is_many = value.is_sequence() || value.is_mapping();
    if (is_many) guard.steps += static_cast<std::int64_t>(value.size() / kItemsForStep);
    switch (keyword->holds) {
    case Holds::nothing: return;
    case Holds::pattern: guard.pattern = pattern_of(value); return;
    case Holds::schema: checked[name] = inner(node, value, *keyword); return;
    case Holds::schemas: checked[name] = schemas(node, value, *keyword); return;
    case Holds::schemas_by_pattern:
      guard.has_name_patterns = value.is_mapping() && value.size() > 0;
      guard.steps += kStepsForNamePattern * static_cast<std::int64_t>(value.size());
      [[fallthrough]];
    case Holds::schemas_by_name: checked[name] = schemas_by_name(node, value, *keyword); return;
    case Holds::items:
      checked[name] =
          value.is_sequence() ? schemas(node, value, *keyword) : inner(node, value, *keyword);
      return;
    case Holds::dependencies: checked[name] = dependencies(node, value, *keyword); return;
    case Holds::boolean: guard.has_unique_items = value.boolean().value_or(false); [[fallthrough]];
    default: check_plain(*keyword, value); checked[name] = to_json(value);
    }
  }

  void suggest_keyword(yaml::View value) {
    std::vector<std::string_view> names;
    for (const Keyword& keyword : kKeywords) names.push_back(keyword.name);
    const auto near = nearest(value.key(), names);
    if (!near) return;
    fault(value.key_span(), quoted(value.key()) + " is not a keyword of JSON Schema draft-07")
        .help("did you mean " + quoted(*near) + "?");
  }

  void check_plain(const Keyword& keyword, yaml::View value) {
    const std::optional<double> number = value.number();
    const bool is_finite = number && std::isfinite(*number);
    switch (keyword.holds) {
    case Holds::number:
      expect(is_finite && (keyword.name != "multipleOf" || *number > 0), value,
             keyword.name == "multipleOf" ? "a number above 0" : "a number");
      return;
    case Holds::count:
      expect(is_finite && *number >= 0 && *number <= 1e9 && std::trunc(*number) == *number, value,
             "a whole number from 0");
      return;
    case Holds::boolean: expect(value.boolean().has_value(), value, "true or false"); return;
    case Holds::any_list: expect(value.is_sequence(), value, "a list"); return;
    case Holds::texts: {
      bool all = value.is_sequence();
      if (all) {
        for (const yaml::View item : value) all = all && item.is_scalar();
      }
      expect(all, value, "a list of names");
      return;
    }
    case Holds::type:
      if (!value.is_sequence()) return check_type(value);
      for (const yaml::View item : value) check_type(item);
      return;
    default: return;
    }
  }

  void check_type(yaml::View value) {
    for (const std::string_view type : kTypes) {
      if (value.is_scalar() && value.text() == type) return;
    }
    Diagnostic& diagnostic =
        fault(value.place(), (value.is_scalar() ? quoted(value.text()) : describe(value)) +
                                 " is not a type of JSON Schema");
    const auto near = only_nearest(value.text(), kTypes);
    diagnostic.help(near ? "did you mean " + quoted(*near) + "?"
                         : "types are array, boolean, integer, null, number, object, string");
  }

  std::optional<Pattern> pattern_of(yaml::View value) {
    if (value.is_scalar()) return compile(value.text(), value.place());
    expect(false, value, "a regular expression");
    return std::nullopt;
  }

  std::optional<Pattern> compile(std::string_view text, Span place) {
    if (text.size() > kLongestPattern) {
      fault(place, "a pattern has at most " + std::to_string(kLongestPattern) + " characters");
      return std::nullopt;
    }
    auto compiled = Pattern::compile(text);
    if (const auto* reason = std::get_if<Pattern::Fault>(&compiled)) {
      fault(place, quoted(text) + " is not a regular expression: " + *reason);
      return std::nullopt;
    }
    Pattern& pattern = std::get<Pattern>(compiled);
    pattern_steps_ += pattern.steps_for("");
    if (pattern_steps_ > kMostPatternSteps) {
      fault(place, "the repeats of all patterns up to here make the schema too large");
      return std::nullopt;
    }
    return std::move(pattern);
  }

  json inner(yaml::View outer, yaml::View node, const Keyword& keyword) {
    if (keyword.is_in_place) applied_[outer.id()].push_back({node.id(), node.place()});
    return schema(node);
  }

  json schemas(yaml::View outer, yaml::View list, const Keyword& keyword) {
    json checked = json::array();
    expect(list.is_sequence() && list.size() > 0, list, "a list of schemas");
    if (!list.is_sequence()) return checked;
    for (const yaml::View node : list) checked.push_back(inner(outer, node, keyword));
    return checked;
  }

  json schemas_by_name(yaml::View outer, yaml::View mapping, const Keyword& keyword) {
    json checked = json::object();
    expect(mapping.is_mapping(), mapping, "a mapping of schemas");
    if (!mapping.is_mapping()) return checked;
    for (const yaml::View node : mapping) {
      if (keyword.holds == Holds::schemas_by_pattern) check_name_pattern(node);
      checked[std::string(node.key())] = inner(outer, node, keyword);
    }
    return checked;
  }

  void check_name_pattern(yaml::View node) {
    const std::optional<Pattern> pattern = compile(node.key(), node.key_span());
    if (!pattern) return;
    if (++name_patterns_ > kMostNamePatterns || !is_simple_pattern(node.key()) ||
        pattern->steps_for("") > kMostNamePatternSteps) {
      fault(node.key_span(), "this pattern of names is too costly")
          .help(
              "repeat at most two characters, none of them hundreds of times, and no groups; write "
              "at most " +
              std::to_string(kMostNamePatterns) + " such patterns in a schema");
      return;
    }
    try {
      const std::regex compiled{std::string(node.key())};
    } catch (const std::regex_error&) {
      fault(node.key_span(), quoted(node.key()) + " is not a regular expression");
    }
  }

  json dependencies(yaml::View outer, yaml::View mapping, const Keyword& keyword) {
    json checked = json::object();
    expect(mapping.is_mapping(), mapping, "a mapping of schemas or lists of names");
    if (!mapping.is_mapping()) return checked;
    for (const yaml::View node : mapping) {
      if (node.is_sequence()) check_plain({keyword.name, Holds::texts}, node);
      checked[std::string(node.key())] =
          node.is_sequence() ? to_json(node) : inner(outer, node, keyword);
    }
    return checked;
  }

  void add_reference(yaml::View node, yaml::View reference) {
    if (!reference.is_scalar()) return expect(false, reference, "a text");
    references_.emplace_back(node.id(), reference);
  }

  void resolve_references() {
    for (const auto& [node, reference] : references_) {
      const yaml::View target = follow_reference(root_, reference.text());
      if (!target || !applied_.contains(target.id())) {
        fault(reference.span(),
              quoted(reference.text()) + " does not refer to a schema in this file")
            .help("other files are not read; write `#/definitions/NAME`");
        continue;
      }
      applied_[node].push_back({target.id(), reference.span()});
    }
  }

  /// Counts the schemas that apply to one value, and their depth; reports an endless cycle.
  Extent measure(yaml::NodeId id, Span place, int depth) {
    const auto known = extents_.find(id);
    if (known != extents_.end() && !known->second.is_open) return known->second;
    if (known != extents_.end()) {
      fault(place, "this schema applies itself to the same value again, without end");
      return {};
    }
    extents_[id].is_open = true;
    Extent extent{1, 1, false};
    if (depth <= kDeepest) {
      for (const Applied& applied : applied_[id]) {
        if (!is_sound_) return {};
        const Extent other = measure(applied.schema, applied.place, depth + 1);
        extent.depth = std::max(extent.depth, other.depth + 1);
        extent.count += other.count;
      }
    }
    if (is_sound_ && (depth > kDeepest || extent.depth > kDeepest || extent.count > kMost)) {
      fault(place.empty() ? root_.span() : place, "too many schemas apply to one value: at most " +
                                                      format_number(kMost) + ", " +
                                                      std::to_string(kDeepest) + " deep");
    }
    return extents_[id] = extent;
  }

  yaml::View root_;
  DiagnosticSink& sink_;
  bool is_sound_ = true;
  std::vector<SchemaGuard> guards_;
  std::size_t pattern_steps_ = 0;
  int name_patterns_ = 0;
  /// Visits every schema of the file, and the schemas it applies to the same value.
  std::map<yaml::NodeId, std::vector<Applied>> applied_;
  std::vector<std::pair<yaml::NodeId, yaml::View>> references_;
  std::map<yaml::NodeId, Extent> extents_;
};

bool fits(yaml::View value, std::size_t& left) {
  if (left == 0) return false;
  --left;
  if (value.kind() != yaml::Kind::sequence && value.kind() != yaml::Kind::mapping) return true;
  for (const yaml::View item : value) {
    if (!fits(item, left)) return false;
  }
  return true;
}

json number_of(double number) {
  constexpr double kExact = 9007199254740992;  // 2^53
  if (std::trunc(number) == number && std::fabs(number) <= kExact) {
    return static_cast<std::int64_t>(number);
  }
  return number;
}

}  // namespace

json to_json(yaml::View value) {
  switch (value.kind()) {
  case yaml::Kind::null: return nullptr;
  case yaml::Kind::sequence: {
    json list = json::array();
    for (const yaml::View item : value) list.push_back(to_json(item));
    return list;
  }
  case yaml::Kind::mapping: {
    json object = json::object();
    for (const yaml::View item : value) object.emplace(std::string(item.key()), to_json(item));
    return object;
  }
  case yaml::Kind::scalar: break;
  }
  if (const auto boolean = value.boolean()) return *boolean;
  if (const auto number = value.number()) return number_of(*number);
  return std::string(value.text());
}

std::size_t size_of(yaml::View value) {
  std::size_t left = kLargest + 1;
  return fits(value, left) ? kLargest + 1 - left : kLargest + 1;
}

yaml::View child(yaml::View parent, std::string_view step) {
  if (parent.is_mapping()) return parent.find(step);
  const auto index = parent.is_sequence() ? parse_integer(step) : std::nullopt;
  if (!index || *index < 0 || static_cast<std::uint64_t>(*index) >= parent.size()) return {};
  return *std::next(parent.begin(), static_cast<std::ptrdiff_t>(*index));
}

std::optional<CheckedSchema> check_schema(yaml::View root, DiagnosticSink& sink) {
  return SchemaChecker(root, sink).run();
}

yaml::View follow_reference(yaml::View root, std::string_view reference) {
  if (!reference.starts_with('#')) return {};
  reference.remove_prefix(1);
  yaml::View at = root;
  while (at && reference.starts_with('/')) {
    reference.remove_prefix(1);
    const std::size_t size = std::min(reference.find('/'), reference.size());
    std::string step(reference.substr(0, size));
    reference.remove_prefix(size);
    for (const auto& [escape, character] : {std::pair("~1", '/'), std::pair("~0", '~')}) {
      for (std::size_t i = step.find(escape); i < step.size(); i = step.find(escape, i + 1)) {
        step.replace(i, 2, 1, character);
      }
    }
    at = child(at, step);
  }
  return reference.empty() ? at : yaml::View();
}

}  // namespace smurf
