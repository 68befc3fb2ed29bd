// SPDX-License-Identifier: BSD-3-Clause
#include "schema/explain.hpp"

#include <algorithm>
#include <set>

#include "ast/key_renames.hpp"
#include "ast/keys.hpp"
#include "base/edits.hpp"
#include "base/quoted.hpp"
#include "base/suggest.hpp"
#include "schema/checked_schema.hpp"

namespace smurf {
namespace {

/// A message of valijson, its keyword, and our message with the keyword's value.
struct Phrase {
  std::string_view description;
  std::string_view keyword;
  std::string_view before, after;
};

constexpr Phrase kPhrases[] = {
    {"Value type not permitted", "type", "must be ", ""},
    {"Failed to match against any enum", "enum", "is not one of ", ""},
    {"Failed to match expected value", "const", "must be ", ""},
    {"Expected number less than or equal", "maximum", "must be at most ", ""},
    {"Expected number less than", "exclusiveMaximum", "must be less than ", ""},
    {"Expected number greater than or equal", "minimum", "must be at least ", ""},
    {"Expected number greater than", "exclusiveMinimum", "must be greater than ", ""},
    {"Value should be a multiple", "multipleOf", "must be a multiple of ", ""},
    {"Array should contain no more", "maxItems", "contains at most ", " items"},
    {"Array should contain no fewer", "minItems", "contains at least ", " items"},
    {"String should be no more", "maxLength", "has at most ", " characters"},
    {"String should be no fewer", "minLength", "has at least ", " characters"},
    {"Object should have no more", "maxProperties", "has at most ", " keys"},
    {"Object should have no fewer", "minProperties", "has at least ", " keys"},
    {"Failed to match regex", "pattern", "does not match the pattern ", ""},
    {"Elements at indexes", "uniqueItems", "contains an item twice", ""},
    {"Failed to any values", "contains", "lacks an item that the schema requires", ""},
    {"Target should not validate", "not", "has a form that the schema excludes", ""},
    {"Missing required property", "required", "has no ", ""},
    {"Missing dependency", "dependencies", "has no ", ""},
    {"Object contains a property", "additionalProperties", "has too many keys", ""},
    {"Array contains more items", "items", "contains too many items", ""},
    {"Cannot validate item", "items", "contains too many items", ""},
    {"Failed to validate against any schemas allowed by anyOf", "anyOf",
     "has none of the forms that the schema allows", ""},
    {"Failed to validate against any child schemas", "oneOf",
     "has none of the forms that the schema allows", ""},
    {"Failed to validate against exactly one", "oneOf",
     "has several of the forms of which the schema allows only one", ""},
};

constexpr std::size_t kNodesForStep = 64;  ///< most nodes of the schema and the value to look at
constexpr std::uint64_t kComparisonsForStep = 256;  ///< most compared characters, for suggestions
constexpr std::size_t kMostNotes = 4;

const Phrase* phrase_of(const SchemaFault& fault) {
  for (const Phrase& phrase : kPhrases) {
    if (fault.description.starts_with(phrase.description)) return &phrase;
  }
  return nullptr;
}

bool is_choice(const Phrase* phrase) {
  return phrase != nullptr && phrase->before.starts_with("has none of the forms");
}

bool is_at_or_under(const SchemaFault& inner, const SchemaFault& outer) {
  return inner.steps.size() >= outer.steps.size() &&
         std::equal(outer.steps.begin(), outer.steps.end(), inner.steps.begin());
}

/// The text between quotes in a message of valijson: the name of a property.
std::string name_in(std::string_view description) {
  const std::size_t begin = description.find('\'');
  const std::size_t end = description.rfind('\'');
  if (begin == std::string_view::npos || end <= begin) return {};
  return std::string(description.substr(begin + 1, end - begin - 1));
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

/// All subschemas that may apply to the value at `steps`, outer ones first.
class Candidates {
 public:
  Candidates(yaml::View root, const std::vector<std::string>& steps) : root_(root) {
    add(root);
    for (const std::string& step : steps) {
      std::vector<yaml::View> outer;
      outer.swap(all_);
      for (const yaml::View schema : outer) add_child(schema, step);
    }
  }

  const std::vector<yaml::View>& all() const { return all_; }

  /// The value of a keyword in the first subschema that has it.
  yaml::View find(std::string_view keyword) const {
    for (const yaml::View schema : all_) {
      if (const yaml::View value = schema.find(keyword)) return value;
    }
    return {};
  }

 private:
  void add(yaml::View schema) {
    constexpr std::size_t kMost = 64;
    if (!schema || !schema.is_mapping() || all_.size() >= kMost) return;
    const auto is_same = [&](yaml::View known) { return known.id() == schema.id(); };
    if (std::any_of(all_.begin(), all_.end(), is_same)) return;
    if (const yaml::View reference = schema.find("$ref")) {
      return add(follow_reference(root_, reference.text()));
    }
    all_.push_back(schema);
    for (const std::string_view key : {"allOf", "anyOf", "oneOf"}) {
      const yaml::View list = schema.find(key);
      if (!list || !list.is_sequence()) continue;
      for (const yaml::View inner : list) add(inner);
    }
    for (const std::string_view key : {"then", "else"}) add(schema.find(key));
  }

  void add_child(yaml::View schema, const std::string& step) {
    const yaml::View items = schema.find("items");
    if (items && items.is_sequence()) {
      const yaml::View item = child(items, step);
      add(item ? item : schema.find("additionalItems"));
    } else {
      add(items);
    }
    const yaml::View properties = schema.find("properties");
    const yaml::View property =
        properties && properties.is_mapping() ? properties.find(step) : yaml::View();
    if (property) return add(property);
    if (const yaml::View patterns = schema.find("patternProperties")) {
      for (const yaml::View pattern : patterns) add(pattern);
    }
    add(schema.find("additionalProperties"));
  }

  yaml::View root_;
  std::vector<yaml::View> all_;
};

class Explainer {
 public:
  Explainer(const std::vector<SchemaFault>& faults, yaml::View schema, yaml::View value,
            std::int64_t& steps_left)
      : faults_(faults),
        schema_(schema),
        value_(value),
        steps_left_(steps_left),
        is_dropped_(faults_.size(), false) {}

  std::vector<Violation> run() {
    drop_rejected_forms();
    drop_consequences();
    for (std::size_t i = 0; i < faults_.size(); ++i) {
      if (!is_dropped_[i] && spend(schema_.document().nodes.size())) explain(i);
    }
    return std::move(violations_);
  }

 private:
  /// False if no steps remain.
  bool spend(std::size_t nodes) {
    steps_left_ -= std::min(steps_left_, static_cast<std::int64_t>(nodes / kNodesForStep + 1));
    return steps_left_ > 0;
  }

  /// For a choice of forms, only the choice is reported. The faults of each form precede
  /// it.
  void drop_rejected_forms() {
    notes_.resize(faults_.size());
    for (std::size_t i = 0; i < faults_.size(); ++i) {
      if (!is_choice(phrase_of(faults_[i]))) continue;
      for (std::size_t k = i; k-- > 0 && is_at_or_under(faults_[k], faults_[i]);) {
        if (is_dropped_[k]) {
          if (!spend(0)) return;
          continue;
        }
        is_dropped_[k] = true;
        const Phrase* phrase = phrase_of(faults_[k]);
        if (phrase == nullptr || notes_[i].size() >= kMostNotes) continue;
        if (!spend(schema_.document().nodes.size())) return;
        const Located at(*this, faults_[k]);
        if (at.value) notes_[i].push_back("one form: " + message(faults_[k], *phrase, at));
      }
      std::reverse(notes_[i].begin(), notes_[i].end());
    }
  }

  /// A failed part is reported only if there is no other finding in it.
  void drop_consequences() {
    std::set<std::vector<std::string>> explained;
    for (std::size_t i = 0; i < faults_.size(); ++i) {
      if (is_dropped_[i] || phrase_of(faults_[i]) == nullptr) continue;
      std::vector<std::string> path = faults_[i].steps;
      while (explained.insert(path).second && !path.empty()) path.pop_back();
    }
    for (std::size_t i = 0; i < faults_.size(); ++i) {
      if (phrase_of(faults_[i]) == nullptr && explained.contains(faults_[i].steps)) {
        is_dropped_[i] = true;
      }
    }
  }

  struct Located {
    Located(Explainer& explainer, const SchemaFault& fault)
        : value(explainer.value_), candidates(explainer.schema_, fault.steps) {
      name = value.key();
      for (const std::string& step : fault.steps) {
        const bool is_item = value.is_sequence();
        explainer.spend(value.size());
        value = child(value, step);
        if (!value) return;
        if (!is_item) {
          name = value.key();
          is_inside = false;
        } else {
          is_inside = true;
        }
      }
    }
    std::string subject() const {
      if (name.empty()) return "this value";
      return (is_inside ? "an item of " : "") + quoted(name);
    }
    yaml::View value;
    Candidates candidates;
    std::string_view name;   ///< schemas of the nearest value with a key
    bool is_inside = false;  ///< an item of that value
  };

  static std::string message(const SchemaFault& fault, const Phrase& phrase, const Located& at) {
    std::string text = at.subject() + " " + std::string(phrase.before);
    if (phrase.keyword == "required" || phrase.keyword == "dependencies") {
      return text + smurf::quoted(name_in(fault.description));
    }
    const yaml::View wanted = at.candidates.find(phrase.keyword);
    if (phrase.before.ends_with(' ')) {
      text += wanted ? alternatives(wanted, phrase.keyword == "type") : "something else";
    }
    text += phrase.after;
    if (phrase.keyword == "type") text += ", not " + describe(at.value);
    return text;
  }

  void explain(std::size_t index) {
    const SchemaFault& fault = faults_[index];
    const Located at(*this, fault);
    if (!at.value) return;
    const Phrase* phrase = phrase_of(fault);
    if (phrase == nullptr) {  // a schema `false`, or a message of a newer version of the library
      add(at, "", at.value.place(), at.subject() + " does not fit the schema");
      return;
    }
    if (phrase->keyword == "additionalProperties") return explain_keys(at);
    const bool is_about_key = phrase->keyword == "required" || phrase->keyword == "dependencies";
    Violation& violation =
        add(at, phrase->keyword, is_about_key ? head_of(at.value) : at.value.place(),
            message(fault, *phrase, at));
    violation.notes = notes_[index];
    if (phrase->keyword == "enum") suggest_value(at, violation);
    if (is_about_key && at.value.is_mapping()) {
      violation.add_span = place_to_add(at.value, name_in(fault.description));
    }
    if (is_about_key) suggest_key(at, name_in(fault.description), violation);
  }

  /// Then, the place is a misspelt key that may mean the missing one.
  void suggest_key(const Located& at, const std::string& missing, Violation& violation) {
    if (!spend(kNodesForStep / 4 * at.value.size())) return;
    const std::vector<std::string_view> names = property_names(at);
    const std::set<std::string_view> known(names.begin(), names.end());
    const std::string_view meant[] = {missing};
    for (const yaml::View key : at.value) {
      if (known.contains(key.key())) continue;
      if (!nearest(key.key(), meant)) continue;
      violation.span = key.key_span();
      violation.add_span = {};
      KeyRenames renames(at.value);
      return suggest_name(violation, renames, key, missing);
    }
  }

  static std::vector<std::string_view> property_names(const Located& at) {
    std::vector<std::string_view> names;
    for (const yaml::View schema : at.candidates.all()) {
      const yaml::View properties = schema.find("properties");
      if (!properties || !properties.is_mapping()) continue;
      for (const yaml::View property : properties) names.push_back(property.key());
    }
    return names;
  }

  static bool is_required(const Located& at, std::string_view name) {
    const yaml::View required = at.candidates.find("required");
    if (!required || !required.is_sequence()) return false;
    return std::any_of(required.begin(), required.end(),
                       [&](yaml::View item) { return item.text() == name; });
  }

  Violation& add(const Located& at, std::string_view keyword, Span span, std::string message) {
    Violation& violation = violations_.emplace_back();
    violation.span = span;
    violation.message = std::move(message);
    if (const yaml::View key = at.candidates.find(keyword)) violation.schema_span = key.key_span();
    for (const std::string_view words : {"description", "title"}) {
      const yaml::View text = at.candidates.find(words);
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

  void suggest_value(const Located& at, Violation& violation) {
    const yaml::View values = at.candidates.find("enum");
    if (!values || !values.is_sequence() || !at.value.is_scalar()) return;
    std::vector<std::string_view> names;
    for (const yaml::View value : values) names.push_back(value.text());
    if (const auto near = nearest_of(at.value.text(), names)) {
      violation.help = "did you mean " + quoted(*near) + "?";
      if (!fits_everywhere(*near)) return;
      const Span place = within_quotes(at.value);
      violation.fixes.push_back({Applicability::unsafe, {{place, std::string(*near)}}});
    }
  }

  static void suggest_name(Violation& violation, KeyRenames& renames, yaml::View key,
                           std::string_view name) {
    violation.help = "did you mean " + quoted(name) + "?";
    if (fits_everywhere(name)) renames.offer(violation.fixes, key, name);
  }

  /// valijson names only the first superfluous key; these are all.
  void explain_keys(const Located& at) {
    const std::vector<std::string_view> names = property_names(at);
    const std::set<std::string_view> known(names.begin(), names.end());
    KeyRenames renames(at.value);
    const bool has_patterns = static_cast<bool>(at.candidates.find("patternProperties"));
    for (const yaml::View key : at.value) {
      if (known.contains(key.key())) continue;
      if (has_patterns) {  // the patterns of names are not matched again
        Violation& violation = add(at, "additionalProperties", head_of(at.value),
                                   at.subject() + " has a key that the schema does not know");
        violation.help.clear();
        return;
      }
      if (!spend(at.value.size())) return;
      const auto near = nearest_of(key.key(), names);
      const bool is_slip = near && !renames.has(*near);
      if (is_slip && is_required(at, *near)) continue;  // reported as missing
      Violation& violation =
          add(at, "additionalProperties", key.key_span(),
              at.subject() + " has no key " + quoted(key.key()) + " in its schema");
      violation.help.clear();
      if (is_slip) suggest_name(violation, renames, key, *near);
    }
  }

  const std::vector<SchemaFault>& faults_;
  yaml::View schema_;
  yaml::View value_;
  std::int64_t& steps_left_;
  std::vector<bool> is_dropped_;
  std::vector<std::vector<std::string>> notes_;
  std::vector<Violation> violations_;
};

}  // namespace

std::vector<Violation> explain(const std::vector<SchemaFault>& faults, yaml::View schema,
                               yaml::View value, std::int64_t& steps_left) {
  return Explainer(faults, schema, value, steps_left).run();
}

}  // namespace smurf
