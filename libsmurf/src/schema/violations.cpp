// SPDX-License-Identifier: BSD-3-Clause
#include "schema/violations.hpp"

#include <algorithm>
#include <set>

#include "ast/key_renames.hpp"
#include "ast/keys.hpp"
#include "base/text/edits.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "schema/checked_schema.hpp"

namespace smurf {
namespace {

/// What a violated keyword means for the value; between the two, the keyword's value is shown if
/// `before` ends with a space.
struct Phrase {
  Keyword keyword;
  std::string_view before, after;
};

constexpr Phrase kPhrases[] = {
    {Keyword::additional_properties, "has no key ", " in its schema"},
    {Keyword::any_of, "has none of the forms that the schema allows", ""},
    {Keyword::constant, "must be ", ""},
    {Keyword::contains, "lacks an item that the schema requires", ""},
    {Keyword::dependencies, "has no ", ""},
    {Keyword::enumeration, "is not one of ", ""},
    {Keyword::exclusive_maximum, "must be less than ", ""},
    {Keyword::exclusive_minimum, "must be greater than ", ""},
    {Keyword::items, "contains too many items", ""},
    {Keyword::max_items, "contains at most ", " items"},
    {Keyword::max_length, "has at most ", " characters"},
    {Keyword::max_properties, "has at most ", " keys"},
    {Keyword::maximum, "must be at most ", ""},
    {Keyword::min_items, "contains at least ", " items"},
    {Keyword::min_length, "has at least ", " characters"},
    {Keyword::min_properties, "has at least ", " keys"},
    {Keyword::minimum, "must be at least ", ""},
    {Keyword::multiple_of, "must be a multiple of ", ""},
    {Keyword::never, "does not fit the schema", ""},
    {Keyword::not_allowed, "has a form that the schema excludes", ""},
    {Keyword::one_of, "has none of the forms that the schema allows", ""},
    {Keyword::pattern, "does not match the pattern ", ""},
    {Keyword::property_names, "has the key ", ", whose name the schema does not allow"},
    {Keyword::required, "has no ", ""},
    {Keyword::type, "must be ", ""},
    {Keyword::unique_items, "contains an item twice", ""},
};

constexpr std::size_t kNodesForExplainedStep =
    64;  ///< most nodes of the schema and the value to look at
constexpr std::uint64_t kComparisonsForStep = 256;  ///< most compared characters, for suggestions

Phrase phrase_of(const SchemaFault& fault) {
  if (fault.fits_several) {
    return {fault.keyword, "has several of the forms of which the schema allows only one", ""};
  }
  for (const Phrase& phrase : kPhrases) {
    if (phrase.keyword == fault.keyword) return phrase;
  }
  return {fault.keyword, "does not fit the schema", ""};
}

std::string_view describe_type(std::string_view type) {
  if (type == "array") return "a list";
  if (type == "boolean") return "true or false";
  if (type == "integer") return "a whole number";
  if (type == "null") return "nothing";
  if (type == "number") return "a number";
  if (type == "object") return "a mapping";
  return "a text";
}

/// `a`, `b` or `c`.
std::string alternatives(yaml::View list, bool are_types) {
  const auto one = [&](yaml::View item) {
    if (are_types) return std::string(describe_type(item.text()));
    return item.is_scalar() ? quoted(item.text()) : describe(item);
  };
  if (!list.is_sequence()) return one(list);
  std::string all;
  std::size_t index = 0;
  constexpr std::size_t kMostShown = 12;
  for (const yaml::View item : list) {
    ++index;
    if (index > kMostShown) return all + ", ...";
    if (index > 1) all += index == list.size() ? " or " : ", ";
    all += one(item);
  }
  return all;
}

/// The value of a keyword in the first of the schemas that has it.
yaml::View find(const std::vector<yaml::View>& schemas, std::string_view keyword) {
  for (const yaml::View schema : schemas) {
    const yaml::View value = schema.is_mapping() ? schema.find(keyword) : yaml::View();
    if (value) return value;
  }
  return {};
}

/// Where a fault is: `is_inside` an item of the value called `name`.
struct Located {
  explicit Located(const SchemaFault& fault) : value(fault.path.back()) {
    bool is_item = false;
    for (const yaml::View step : fault.path) {
      if (!is_item) name = step.key();
      is_inside = is_item;
      is_item = step.is_sequence();
    }
  }
  std::string subject() const {
    if (name.empty()) return "this value";
    return (is_inside ? "an item of " : "") + quoted(name);
  }

  yaml::View value;
  std::string_view name;
  bool is_inside = false;
};

std::string message(const SchemaFault& fault) {
  const Located at(fault);
  const Phrase phrase = phrase_of(fault);
  std::string text = at.subject() + " " + std::string(phrase.before);
  if (!fault.name.empty()) return text + quoted(fault.name) + std::string(phrase.after);
  const bool is_type = fault.keyword == Keyword::type;
  if (phrase.before.ends_with(' ')) text += alternatives(fault.keyword_value, is_type);
  text += phrase.after;
  if (is_type) text += ", not " + describe(at.value);
  return text;
}

std::vector<std::string_view> property_names(const SchemaFault& fault) {
  std::vector<std::string_view> names;
  for (const yaml::View schema : fault.schemas) {
    const yaml::View properties = schema.is_mapping() ? schema.find("properties") : yaml::View();
    if (!properties || !properties.is_mapping()) continue;
    for (const yaml::View property : properties) names.push_back(property.key());
  }
  return names;
}

/// The names that property_names() and is_required() look at.
std::size_t name_count(const SchemaFault& fault) {
  std::size_t count = 0;
  for (const yaml::View schema : fault.schemas) {
    for (const std::string_view keyword : {"properties", "required"}) {
      const yaml::View names = schema.is_mapping() ? schema.find(keyword) : yaml::View();
      count += names ? names.size() : 0;
    }
  }
  return count;
}

bool is_required(const SchemaFault& fault, std::string_view name) {
  const yaml::View required = find(fault.schemas, "required");
  if (!required || !required.is_sequence()) return false;
  return std::any_of(required.begin(), required.end(),
                     [&](yaml::View item) { return item.text() == name; });
}

class Explainer {
 public:
  Explainer(const std::vector<SchemaFault>& faults, std::int64_t& steps_left)
      : faults_(faults), steps_left_(steps_left) {}

  std::vector<Violation> run() {
    for (const SchemaFault& fault : faults_) {
      if (spend(kNodesForExplainedStep)) explain(fault);
    }
    return std::move(violations_);
  }

 private:
  /// False if no steps remain.
  bool spend(std::size_t nodes) {
    steps_left_ -=
        std::min(steps_left_, static_cast<std::int64_t>(nodes / kNodesForExplainedStep + 1));
    return steps_left_ > 0;
  }

  void explain(const SchemaFault& fault) {
    if (fault.keyword == Keyword::additional_properties) return explain_key(fault);
    const Located at(fault);
    const bool is_about_key =
        fault.keyword == Keyword::required || fault.keyword == Keyword::dependencies;
    Violation& violation = add(fault, is_about_key ? head_of(at.value) : at.value.place());
    for (const SchemaFault& form : fault.forms) {
      violation.notes.push_back("one form: " + message(form));
    }
    if (fault.keyword == Keyword::enumeration) suggest_value(fault, at.value, violation);
    if (fault.keyword == Keyword::property_names) {
      violation.span = at.value.find(fault.name).key_span();
    }
    if (!is_about_key) return;
    violation.add_span = place_to_add(at.value, std::string(fault.name));
    suggest_key(fault, at.value, violation);
  }

  /// Then, the place is a misspelt key that may mean the missing one.
  void suggest_key(const SchemaFault& fault, yaml::View value, Violation& violation) {
    if (!spend(kNodesForExplainedStep / 4 * value.size() + name_count(fault))) return;
    const std::vector<std::string_view> names = property_names(fault);
    const std::set<std::string_view> known(names.begin(), names.end());
    const std::string_view meant[] = {fault.name};
    for (const yaml::View key : value) {
      if (known.contains(key.key())) continue;
      if (!nearest(key.key(), meant)) continue;
      violation.span = key.key_span();
      violation.add_span = {};
      KeyRenames renames(value);
      return suggest_name(violation, renames, key, fault.name);
    }
  }

  Violation& add(const SchemaFault& fault, Span span) {
    Violation& violation = violations_.emplace_back();
    violation.span = span;
    violation.message = message(fault);
    violation.schema_span = fault.keyword_value.key_span();
    for (const std::string_view words : {"description", "title"}) {
      const yaml::View text = find(fault.schemas, words);
      if (violation.help.empty() && text && text.is_scalar()) violation.help = text.text();
    }
    return violation;
  }

  /// The key of a mapping, else its first key.
  static Span head_of(yaml::View mapping) {
    if (!mapping.key_span().empty()) return mapping.key_span();
    return mapping.is_mapping() && mapping.size() > 0 ? (*mapping.begin()).key_span()
                                                      : mapping.place();
  }

  std::optional<std::string_view> nearest_of(std::string_view name,
                                             std::span<const std::string_view> known) {
    const auto most = static_cast<std::uint64_t>(std::max<std::int64_t>(steps_left_, 0));
    std::uint64_t comparisons_left = most * kComparisonsForStep;
    const auto near = only_nearest(name, known, comparisons_left);
    steps_left_ = static_cast<std::int64_t>(comparisons_left / kComparisonsForStep);
    return near;
  }

  void suggest_value(const SchemaFault& fault, yaml::View wrong, Violation& violation) {
    if (fault.keyword_value.size() > kMostValues) return;
    if (!wrong.is_scalar() || !spend(fault.keyword_value.size())) return;
    std::vector<std::string_view> names;
    for (const yaml::View value : fault.keyword_value) names.push_back(value.text());
    if (const auto near = nearest_of(wrong.text(), names)) {
      violation.help = "did you mean " + quoted(*near) + "?";
      if (!fits_everywhere(*near)) return;
      const Span place = within_quotes(wrong);
      violation.fixes.push_back({Applicability::unsafe, {{place, std::string(*near)}}});
    }
  }

  static void suggest_name(Violation& violation, KeyRenames& renames, yaml::View key,
                           std::string_view name) {
    violation.help = "did you mean " + quoted(name) + "?";
    if (fits_everywhere(name)) renames.offer(violation.fixes, key, name);
  }

  void explain_key(const SchemaFault& fault) {
    const yaml::View value = fault.path.back();
    if (!spend(value.size() + name_count(fault))) return;
    const yaml::View key = value.find(fault.name);
    const std::vector<std::string_view> names = property_names(fault);
    KeyRenames renames(value);
    const auto near = nearest_of(key.key(), names);
    const bool is_slip = near && !renames.has(*near);
    if (is_slip && is_required(fault, *near)) return;  // reported as missing
    Violation& violation = add(fault, key.key_span());
    violation.help.clear();
    if (is_slip) suggest_name(violation, renames, key, *near);
  }

  const std::vector<SchemaFault>& faults_;
  std::int64_t& steps_left_;
  std::vector<Violation> violations_;
};

}  // namespace

std::vector<Violation> explain(const std::vector<SchemaFault>& faults, std::int64_t& steps_left) {
  return Explainer(faults, steps_left).run();
}

}  // namespace smurf
