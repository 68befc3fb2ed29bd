// SPDX-License-Identifier: BSD-3-Clause
#include "schema/checked_schema.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "ast/keys.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "schema/json_value.hpp"

namespace smurf {
namespace {

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

struct KeywordRow {
  std::string_view name;
  Holds holds = Holds::anything;
  Keyword keyword = Keyword::never;  ///< irrelevant where it holds nothing
  bool is_in_place = false;          ///< the schemas in it apply to the same value
};

constexpr KeywordRow kKeywords[] = {
    {"$comment", Holds::nothing},
    {"$defs", Holds::schemas_by_name},
    {"$id", Holds::nothing},
    {"$ref", Holds::reference, Keyword::reference, true},
    {"$schema", Holds::nothing},
    {"additionalItems", Holds::schema, Keyword::additional_items},
    {"additionalProperties", Holds::schema, Keyword::additional_properties},
    {"allOf", Holds::schemas, Keyword::all_of, true},
    {"anyOf", Holds::schemas, Keyword::any_of, true},
    {"const", Holds::anything, Keyword::constant},
    {"contains", Holds::schema, Keyword::contains},
    {"contentEncoding", Holds::nothing},
    {"contentMediaType", Holds::nothing},
    {"default", Holds::nothing},
    {"definitions", Holds::schemas_by_name},
    {"dependencies", Holds::dependencies, Keyword::dependencies, true},
    {"description", Holds::nothing},
    {"else", Holds::schema, Keyword::if_then_else, true},
    {"enum", Holds::any_list, Keyword::enumeration},
    {"examples", Holds::nothing},
    {"exclusiveMaximum", Holds::number, Keyword::exclusive_maximum},
    {"exclusiveMinimum", Holds::number, Keyword::exclusive_minimum},
    {"format", Holds::nothing},  // an annotation, as draft-07 allows
    {"if", Holds::schema, Keyword::if_then_else, true},
    {"items", Holds::items, Keyword::items},
    {"maxItems", Holds::count, Keyword::max_items},
    {"maxLength", Holds::count, Keyword::max_length},
    {"maxProperties", Holds::count, Keyword::max_properties},
    {"maximum", Holds::number, Keyword::maximum},
    {"minItems", Holds::count, Keyword::min_items},
    {"minLength", Holds::count, Keyword::min_length},
    {"minProperties", Holds::count, Keyword::min_properties},
    {"minimum", Holds::number, Keyword::minimum},
    {"multipleOf", Holds::number, Keyword::multiple_of},
    {"not", Holds::schema, Keyword::not_allowed, true},
    {"oneOf", Holds::schemas, Keyword::one_of, true},
    {"pattern", Holds::pattern, Keyword::pattern},
    {"patternProperties", Holds::schemas_by_pattern, Keyword::pattern_properties},
    {"properties", Holds::schemas_by_name, Keyword::properties},
    {"propertyNames", Holds::schema, Keyword::property_names},
    {"readOnly", Holds::nothing},
    {"required", Holds::texts, Keyword::required},
    {"then", Holds::schema, Keyword::if_then_else, true},
    {"title", Holds::nothing},
    {"type", Holds::type, Keyword::type},
    {"uniqueItems", Holds::boolean, Keyword::unique_items},
    {"writeOnly", Holds::nothing},
};

constexpr std::string_view kTypes[] = {"array",  "boolean", "integer", "null",
                                       "number", "object",  "string"};

/// Limits the schemas that apply to one value: their nesting depth and their number.
constexpr int kDeepest = 32;
constexpr double kMost = 256;
constexpr std::size_t kLongestPattern = 300;
/// Limits the memory of all patterns of a schema.
constexpr std::size_t kMostPatternSteps = 500'000;

const KeywordRow* find_keyword(std::string_view name) {
  for (const KeywordRow& keyword : kKeywords) {
    if (keyword.name == name) return &keyword;
  }
  return nullptr;
}

/// The value with this key, or at this index; null if there is none.
yaml::View child(yaml::View parent, std::string_view step) {
  if (parent.is_mapping()) return parent.find(step);
  const auto index = parent.is_sequence() ? parse_integer(step) : std::nullopt;
  if (!index || *index < 0 || static_cast<std::uint64_t>(*index) >= parent.size()) return {};
  return *std::next(parent.begin(), static_cast<std::ptrdiff_t>(*index));
}

/// The node that "#/definitions/color" names; null if there is none or it is in another file.
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

class SchemaChecker {
 public:
  SchemaChecker(yaml::View root, DiagnosticSink& sink) : root_(root), sink_(sink) {}

  std::optional<CheckedSchema> run() {
    if (size_of(root_) > kLargest) {
      fault(root_.span(), "the schema is too large");
      return std::nullopt;
    }
    schema(root_);
    resolve_references();
    for (const auto& [id, reached] : applied_) {
      if (!is_sound_) break;
      measure(id, {}, 0);
    }
    if (!is_sound_) return std::nullopt;
    return CheckedSchema{std::move(schemas_)};
  }

 private:
  struct Applied {
    yaml::NodeId schema;
    Span place;
  };
  struct Reference {
    yaml::NodeId schema;
    yaml::View value;
    SchemaIndex index;
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

  SchemaIndex schema(yaml::View node) {
    applied_[node.id()];
    const auto index = static_cast<SchemaIndex>(schemas_.size());
    schemas_.push_back({node, {}});
    indices_.emplace(node.id(), index);
    if (const auto boolean = node.boolean()) {
      if (!*boolean) add({Keyword::never, node}, index);
    } else if (!node.is_mapping()) {
      fault(node.place(), "a schema must be a mapping, true or false, not " + describe(node));
    } else if (const yaml::View reference = node.find("$ref")) {  // other keys have no effect
      add_reference(node, reference, index);
    } else {
      for (const yaml::View value : node) {
        if (!value.is_repeated()) add_keyword(node, value, index);
      }
    }
    return index;
  }

  void add(SchemaCheck check, SchemaIndex index) {
    schemas_[index].checks.push_back(std::move(check));
  }

  void add_keyword(yaml::View node, yaml::View value, SchemaIndex index) {
    const KeywordRow* row = find_keyword(value.key());
    if (row == nullptr) return suggest_keyword(value);
    SchemaCheck check{row->keyword, value};
    switch (row->holds) {
    case Holds::nothing: return;
    case Holds::pattern: add_pattern(value, check); break;
    case Holds::schema: check.schemas = {inner(node, value, *row)}; break;
    case Holds::schemas: add_schemas(node, value, *row, check); break;
    case Holds::schemas_by_pattern:
    case Holds::schemas_by_name: add_schemas_by_name(node, value, *row, check); break;
    case Holds::items:
      if (value.is_sequence()) {
        add_schemas(node, value, *row, check);
      } else {
        check.schemas = {inner(node, value, *row)};
      }
      break;
    case Holds::dependencies: add_dependencies(node, value, *row, check); break;
    default: add_plain(*row, value, check);
    }
    if (row->keyword == Keyword::if_then_else) return add_condition(value, check, index);
    if (row->keyword != Keyword::never) add(std::move(check), index);
  }

  /// `if`, `then` and `else` become one check.
  void add_condition(yaml::View value, const SchemaCheck& part, SchemaIndex index) {
    std::vector<SchemaCheck>& checks = schemas_[index].checks;
    const auto is_condition = [](const SchemaCheck& check) {
      return check.keyword == Keyword::if_then_else;
    };
    auto condition = std::find_if(checks.begin(), checks.end(), is_condition);
    if (condition == checks.end()) {
      condition = checks.insert(checks.end(), {Keyword::if_then_else, value});
      condition->schemas.assign(3, kNoSchema);
    }
    const std::size_t place = value.key() == "if" ? 0 : value.key() == "then" ? 1 : 2;
    condition->schemas[place] = part.schemas.front();
  }

  void suggest_keyword(yaml::View value) {
    std::vector<std::string_view> names;
    for (const KeywordRow& keyword : kKeywords) names.push_back(keyword.name);
    const auto near = nearest(value.key(), names);
    if (!near) return;
    fault(value.key_span(), quoted(value.key()) + " is not a keyword of JSON Schema draft-07")
        .help("did you mean " + quoted(*near) + "?");
  }

  void check_plain(const KeywordRow& keyword, yaml::View value) {
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

  void add_plain(const KeywordRow& row, yaml::View value, SchemaCheck& check) {
    check_plain(row, value);
    check.number = value.number().value_or(0);
    if (row.keyword != Keyword::enumeration || !value.is_sequence()) return;
    std::size_t visited = 0;  // at most the size of the schema
    for (const yaml::View allowed : value)
      check.hashes.emplace_back(hash_of(allowed, visited), allowed);
    std::stable_sort(check.hashes.begin(), check.hashes.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
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

  void add_pattern(yaml::View value, SchemaCheck& check) {
    expect(value.is_scalar(), value, "a regular expression");
    if (!value.is_scalar()) return;
    if (auto pattern = compile(value.text(), value.place())) {
      check.patterns.push_back(*std::move(pattern));
    }
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

  SchemaIndex inner(yaml::View outer, yaml::View node, const KeywordRow& row) {
    if (row.is_in_place) applied_[outer.id()].push_back({node.id(), node.place()});
    return schema(node);
  }

  void add_schemas(yaml::View outer, yaml::View list, const KeywordRow& row, SchemaCheck& check) {
    expect(list.is_sequence() && list.size() > 0, list, "a list of schemas");
    if (!list.is_sequence()) return;
    for (const yaml::View node : list) check.schemas.push_back(inner(outer, node, row));
  }

  /// Names are sorted; patterns keep their order.
  void add_schemas_by_name(yaml::View outer, yaml::View mapping, const KeywordRow& row,
                           SchemaCheck& check) {
    expect(mapping.is_mapping(), mapping, "a mapping of schemas");
    if (!mapping.is_mapping()) return;
    std::vector<std::pair<std::string_view, SchemaIndex>> named;
    for (const yaml::View node : mapping) {
      if (node.is_repeated()) continue;
      named.emplace_back(node.key(), inner(outer, node, row));
      if (row.holds != Holds::schemas_by_pattern) continue;
      if (auto pattern = compile(node.key(), node.key_span())) {
        check.patterns.push_back(*std::move(pattern));
      }
    }
    if (row.holds == Holds::schemas_by_name) std::sort(named.begin(), named.end());
    for (const auto& [name, schema] : named) {
      check.names.push_back(name);
      check.schemas.push_back(schema);
    }
  }

  void add_dependencies(yaml::View outer, yaml::View mapping, const KeywordRow& row,
                        SchemaCheck& check) {
    expect(mapping.is_mapping(), mapping, "a mapping of schemas or lists of names");
    if (!mapping.is_mapping()) return;
    std::map<std::string_view, SchemaIndex> named;
    for (const yaml::View node : mapping) {
      if (node.is_repeated()) continue;
      const bool is_list = node.is_sequence();
      if (is_list) check_plain({row.name, Holds::texts}, node);
      named.emplace(node.key(), is_list ? kNoSchema : inner(outer, node, row));
    }
    for (const auto& [name, schema] : named) {
      check.names.push_back(name);
      check.schemas.push_back(schema);
    }
  }

  void add_reference(yaml::View node, yaml::View reference, SchemaIndex index) {
    if (!reference.is_scalar()) return expect(false, reference, "a text");
    references_.push_back({node.id(), reference, index});
  }

  void resolve_references() {
    for (const Reference& one : references_) {
      const yaml::View target = follow_reference(root_, one.value.text());
      if (!target || !applied_.contains(target.id())) {
        fault(one.value.span(),
              quoted(one.value.text()) + " does not refer to a schema in this file")
            .help("other files are not read; write `#/definitions/NAME`");
        continue;
      }
      applied_[one.schema].push_back({target.id(), one.value.span()});
      SchemaCheck check{Keyword::reference, one.value};
      check.schemas = {indices_.at(target.id())};
      add(std::move(check), one.index);
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
  std::vector<Subschema> schemas_;
  std::map<yaml::NodeId, SchemaIndex> indices_;
  std::size_t pattern_steps_ = 0;
  /// Visits every schema of the file, and the schemas it applies to the same value.
  std::map<yaml::NodeId, std::vector<Applied>> applied_;
  std::vector<Reference> references_;
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

}  // namespace

std::size_t size_of(yaml::View value) {
  std::size_t left = kLargest + 1;
  return fits(value, left) ? kLargest + 1 - left : kLargest + 1;
}

std::optional<CheckedSchema> check_schema(yaml::View root, DiagnosticSink& sink) {
  return SchemaChecker(root, sink).run();
}

}  // namespace smurf
