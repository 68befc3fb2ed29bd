// SPDX-License-Identifier: BSD-3-Clause
#include "schema/json_schema.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/deadline.hpp"
#include "base/text/utf8.hpp"
#include "schema/json_value.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMatchesForStep = 30;  // steps of Pattern::steps_for() in a step of 1 us
constexpr std::uint64_t kWorkOfStep = 5;     // see Deadline::look()
constexpr std::size_t kNodesForStep = 8;     // compared or looked up in a step
/// Each uses some 300 bytes of memory, and nobody reads so many.
constexpr std::size_t kMostFaults = 200'000;
constexpr std::size_t kMostForms = 4;  // faults of forms that are kept

/// Whether the quotient is a whole number, up to the rounding of decimal fractions.
bool is_multiple(double number, double divisor) {
  constexpr double kRounding = 1e-9;
  const double quotient = number / divisor;
  return std::fabs(quotient - std::round(quotient)) <=
             kRounding * std::max(1.0, std::fabs(quotient)) &&
         std::isfinite(quotient);
}

/// The keys of a mapping, for many look-ups.
class Keys {
 public:
  explicit Keys(yaml::View mapping) {
    keys_.reserve(mapping.size());
    for (const yaml::View member : mapping) keys_.push_back(member.key());
    std::sort(keys_.begin(), keys_.end());
  }
  bool has(std::string_view name) const {
    return std::binary_search(keys_.begin(), keys_.end(), name);
  }

 private:
  std::vector<std::string_view> keys_;
};

/// The schema of the name in a check with names; kNoSchema if it has none.
SchemaIndex schema_of(const SchemaCheck* check, std::string_view name) {
  if (check == nullptr) return kNoSchema;
  const auto found = std::lower_bound(check->names.begin(), check->names.end(), name);
  if (found == check->names.end() || *found != name) return kNoSchema;
  return check->schemas[static_cast<std::size_t>(found - check->names.begin())];
}

/// One application of a schema to a value. Without steps, every check succeeds at once.
class Application {
 public:
  Application(const CheckedSchema& schema, yaml::View value, std::int64_t steps)
      : schema_(schema), steps_left_(steps), path_{value} {}

  std::optional<std::vector<SchemaFault>> run(std::int64_t& steps_left) {
    std::vector<SchemaFault> faults;
    faults_ = &faults;
    check(0);
    steps_left = std::max<std::int64_t>(steps_left_, 0);
    if (steps_left_ < 0) return std::nullopt;
    return faults;
  }

 private:
  yaml::View value() const { return path_.back(); }
  bool is_exhausted() const { return steps_left_ < 0; }

  void spend(std::size_t steps) {
    steps_left_ -= static_cast<std::int64_t>(steps);
    Deadline::look(kWorkOfStep * steps);
  }
  void spend_nodes(std::size_t nodes) { spend(nodes / kNodesForStep); }

  /// Returns `fits`; reports the fault if it is false.
  bool expect(bool fits, const SchemaCheck& check, std::string_view name = {}) {
    if (!fits && faults_ != nullptr) report(check).name = name;
    return fits;
  }

  SchemaFault& report(const SchemaCheck& check) {
    spend(1 + path_.size() / kNodesForStep);
    if (faults_->size() >= kMostFaults) steps_left_ = -1;
    SchemaFault& fault = faults_->emplace_back();
    fault.path = path_;
    for (std::size_t i = own_schemas_; i < applied_.size(); ++i) {
      fault.schemas.push_back(schema_.schemas[applied_[i]].node);
    }
    fault.keyword = check.keyword;
    fault.keyword_value = check.value;
    return fault;
  }

  /// Whether the value fits. Reports every fault, unless only the verdict is wanted.
  bool check(SchemaIndex index) {
    spend(1);
    if (is_exhausted()) return true;
    applied_.push_back(index);
    const Subschema& schema = schema_.schemas[index];
    bool fits = true;
    for (const SchemaCheck& one : schema.checks) {
      fits = apply(one, schema) && fits;
      if (!fits && faults_ == nullptr) break;
    }
    applied_.pop_back();
    return fits;
  }

  /// Applies a schema to a member or item of the value.
  bool check_part(SchemaIndex index, yaml::View part) {
    const std::size_t outer = std::exchange(own_schemas_, applied_.size());
    path_.push_back(part);
    const bool fits = check(index);
    path_.pop_back();
    own_schemas_ = outer;
    return fits;
  }

  /// Without reports.
  bool fits_silently(SchemaIndex index) {
    std::vector<SchemaFault>* const reported = std::exchange(faults_, nullptr);
    const bool fits = check(index);
    faults_ = reported;
    return fits;
  }

  bool apply(const SchemaCheck& check, const Subschema& schema) {
    switch (check.keyword) {
    case Keyword::never: return expect(false, check);
    case Keyword::reference: return this->check(check.schemas.front());
    case Keyword::type: return expect(has_one_type(check.value), check);
    case Keyword::constant: return expect(is_equal_to(check.value), check);
    case Keyword::enumeration: return expect(is_listed(check), check);
    case Keyword::all_of:
    case Keyword::any_of:
    case Keyword::one_of:
    case Keyword::not_allowed:
    case Keyword::if_then_else: return apply_combination(check);
    default: break;
    }
    switch (json_type(value())) {
    case JsonType::number: return expect(fits_number(check), check);
    case JsonType::text: return expect(fits_text(check, value().text()), check);
    case JsonType::list: return apply_to_list(check, schema);
    case JsonType::mapping: return apply_to_mapping(check, schema);
    default: return true;
    }
  }

  bool has_one_type(yaml::View types) {
    if (!types.is_sequence()) return has_type(value(), types.text());
    spend_nodes(types.size());
    return std::any_of(types.begin(), types.end(),
                       [&](yaml::View type) { return has_type(value(), type.text()); });
  }

  bool is_equal_to(yaml::View other) {
    std::size_t visited = 0;
    const bool is_equal = are_equal(value(), other, visited);
    spend_nodes(visited);
    return is_equal;
  }

  bool is_listed(const SchemaCheck& check) {
    std::size_t visited = 0;
    const std::size_t hash = hash_of(value(), visited);
    spend_nodes(visited);
    auto allowed = std::lower_bound(check.hashes.begin(), check.hashes.end(), hash,
                                    [](const auto& one, std::size_t h) { return one.first < h; });
    for (; allowed != check.hashes.end() && allowed->first == hash && !is_exhausted(); ++allowed) {
      if (is_equal_to(allowed->second)) return true;
    }
    return is_exhausted();
  }

  bool apply_combination(const SchemaCheck& check) {
    switch (check.keyword) {
    case Keyword::all_of: {
      bool fits = true;
      for (const SchemaIndex part : check.schemas) {
        fits = this->check(part) && fits;
        if (!fits && faults_ == nullptr) break;
      }
      return fits;
    }
    case Keyword::not_allowed:
      return expect(!fits_silently(check.schemas.front()) || is_exhausted(), check);
    case Keyword::if_then_else: {
      if (check.schemas[0] == kNoSchema) return true;
      const SchemaIndex then = check.schemas[fits_silently(check.schemas[0]) ? 1 : 2];
      return then == kNoSchema || this->check(then);
    }
    default: return apply_choice(check);
    }
  }

  bool apply_choice(const SchemaCheck& check) {
    std::vector<SchemaFault> refusals;
    std::vector<SchemaFault>* const reported = std::exchange(faults_, nullptr);
    if (reported != nullptr) faults_ = &refusals;
    std::size_t fitting = 0;
    for (const SchemaIndex form : check.schemas) {
      fitting += this->check(form) ? 1 : 0;
      if (check.keyword == Keyword::any_of && fitting > 0) break;
    }
    faults_ = reported;
    const bool fits = check.keyword == Keyword::any_of ? fitting > 0 : fitting == 1;
    if (fits || is_exhausted() || faults_ == nullptr) return fits || is_exhausted();
    SchemaFault& fault = report(check);
    fault.fits_several = fitting > 1;
    if (fitting > 1) return false;
    if (refusals.size() > kMostForms) {
      refusals.erase(refusals.begin(), refusals.end() - std::ptrdiff_t{kMostForms});
    }
    fault.forms = std::move(refusals);
    return false;
  }

  bool fits_number(const SchemaCheck& check) const {
    const double number = *value().number();
    switch (check.keyword) {
    case Keyword::maximum: return number <= check.number;
    case Keyword::minimum: return number >= check.number;
    case Keyword::exclusive_maximum: return number < check.number;
    case Keyword::exclusive_minimum: return number > check.number;
    case Keyword::multiple_of: return is_multiple(number, check.number);
    default: return true;
    }
  }

  bool fits_text(const SchemaCheck& check, std::string_view text) {
    const auto length = [&] { return static_cast<double>(utf8::count_code_points(text)); };
    switch (check.keyword) {
    case Keyword::max_length: return length() <= check.number;
    case Keyword::min_length: return length() >= check.number;
    case Keyword::pattern: return check.patterns.empty() || matches(check.patterns.front(), text);
    default: return true;
    }
  }

  bool matches(const Pattern& pattern, std::string_view text) {
    spend(1 + pattern.steps_for(text) / kMatchesForStep);
    return is_exhausted() || pattern.is_in(text);
  }

  bool apply_to_list(const SchemaCheck& check, const Subschema& schema) {
    const auto size = static_cast<double>(value().size());
    switch (check.keyword) {
    case Keyword::max_items: return expect(size <= check.number, check);
    case Keyword::min_items: return expect(size >= check.number, check);
    case Keyword::unique_items:
      return expect(!check.value.boolean().value_or(false) || are_unique(), check);
    case Keyword::contains: {
      std::vector<SchemaFault>* const reported = std::exchange(faults_, nullptr);
      bool has = is_exhausted();
      for (auto item = value().begin(); item != value().end() && !has; ++item) {
        has = check_part(check.schemas.front(), *item);
      }
      faults_ = reported;
      return expect(has, check);
    }
    case Keyword::items: return apply_items(check, schema);
    default: return true;
    }
  }

  bool apply_items(const SchemaCheck& check, const Subschema& schema) {
    const bool is_tuple = check.value.is_sequence();
    const SchemaCheck* more = is_tuple ? schema.find(Keyword::additional_items) : nullptr;
    std::size_t index = 0;
    bool fits = true;
    for (const yaml::View item : value()) {
      if (is_exhausted()) break;
      const std::size_t place = index++;
      if (!is_tuple) {
        fits = check_part(check.schemas.front(), item) && fits;
      } else if (place < check.schemas.size()) {
        fits = check_part(check.schemas[place], item) && fits;
      } else if (more == nullptr) {
        break;
      } else if (is_never(more->schemas.front())) {
        return expect(false, check);
      } else {
        fits = check_part(more->schemas.front(), item) && fits;
      }
    }
    return fits;
  }

  bool is_never(SchemaIndex index) const {
    return schema_.schemas[index].find(Keyword::never) != nullptr;
  }

  bool are_unique() {
    std::size_t visited = 0;
    std::vector<std::pair<std::size_t, yaml::View>> items;
    for (const yaml::View item : value()) items.emplace_back(hash_of(item, visited), item);
    spend_nodes(visited + items.size());
    std::sort(items.begin(), items.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t k = i + 1; k < items.size() && items[k].first == items[i].first; ++k) {
        if (is_exhausted()) return true;
        std::size_t compared = 0;
        if (are_equal(items[i].second, items[k].second, compared)) return false;
        spend_nodes(kNodesForStep + compared);
      }
    }
    return true;
  }

  bool apply_to_mapping(const SchemaCheck& check, const Subschema& schema) {
    switch (check.keyword) {
    case Keyword::max_properties:
      return expect(static_cast<double>(member_count(value())) <= check.number, check);
    case Keyword::min_properties:
      return expect(static_cast<double>(member_count(value())) >= check.number, check);
    case Keyword::required: return apply_required(check, check.value);
    case Keyword::dependencies: return apply_dependencies(check);
    case Keyword::property_names: return apply_property_names(check);
    case Keyword::properties:
      return apply_members(check, [&](yaml::View member) {
        const SchemaIndex own = schema_of(&check, member.key());
        return own == kNoSchema || check_part(own, member);
      });
    case Keyword::pattern_properties:
      return apply_members(check, [&](yaml::View member) {
        bool fits = true;
        for (std::size_t i = 0; i < check.patterns.size() && !is_exhausted(); ++i) {
          if (matches(check.patterns[i], member.key())) {
            fits = check_part(check.schemas[i], member) && fits;
          }
        }
        return fits;
      });
    case Keyword::additional_properties: return apply_additional(check, schema);
    default: return true;
    }
  }

  template <class Function>
  bool apply_members(const SchemaCheck&, Function function) {
    spend_nodes(value().size());
    bool fits = true;
    for (const yaml::View member : value()) {
      if (is_exhausted() || (!fits && faults_ == nullptr)) break;
      if (!member.is_repeated()) fits = function(member) && fits;
    }
    return fits;
  }

  bool apply_additional(const SchemaCheck& check, const Subschema& schema) {
    const SchemaCheck* named = schema.find(Keyword::properties);
    const SchemaCheck* patterns = schema.find(Keyword::pattern_properties);
    const SchemaIndex others = check.schemas.front();
    return apply_members(check, [&](yaml::View member) {
      if (schema_of(named, member.key()) != kNoSchema) return true;
      if (patterns != nullptr) {
        for (const Pattern& pattern : patterns->patterns) {
          if (matches(pattern, member.key())) return true;
        }
      }
      return is_never(others) ? expect(false, check, member.key()) : check_part(others, member);
    });
  }

  bool apply_required(const SchemaCheck& check, yaml::View names) {
    spend_nodes(names.size() + value().size());
    const Keys keys(value());
    bool fits = true;
    for (const yaml::View name : names) {
      fits = expect(keys.has(name.text()), check, name.text()) && fits;
      if (is_exhausted()) break;
    }
    return fits;
  }

  bool apply_dependencies(const SchemaCheck& check) {
    return apply_members(check, [&](yaml::View member) {
      const auto found = std::lower_bound(check.names.begin(), check.names.end(), member.key());
      if (found == check.names.end() || *found != member.key()) return true;
      const SchemaIndex schema =
          check.schemas[static_cast<std::size_t>(found - check.names.begin())];
      if (schema != kNoSchema) return this->check(schema);
      return apply_required(check, check.value.find(member.key()));
    });
  }

  /// The names are texts, also where YAML would type them as numbers.
  bool apply_property_names(const SchemaCheck& check) {
    return apply_members(check, [&](yaml::View member) {
      return expect(name_fits(check.schemas.front(), member.key()), check, member.key());
    });
  }

  bool name_fits(SchemaIndex index, std::string_view name) {
    spend(1);
    if (is_exhausted()) return true;
    for (const SchemaCheck& check : schema_.schemas[index].checks) {
      if (!name_fits(check, name)) return false;
    }
    return true;
  }

  bool name_fits(const SchemaCheck& check, std::string_view name) {
    const auto fits = [&](SchemaIndex index) { return name_fits(index, name); };
    const std::vector<SchemaIndex>& parts = check.schemas;
    switch (check.keyword) {
    case Keyword::never: return false;
    case Keyword::type: return is_text_type(check.value);
    case Keyword::constant: return is_text(check.value, name);
    case Keyword::enumeration:
      spend_nodes(check.value.size());
      return std::any_of(check.value.begin(), check.value.end(),
                         [&](yaml::View one) { return is_text(one, name); });
    case Keyword::reference:
    case Keyword::all_of: return std::all_of(parts.begin(), parts.end(), fits);
    case Keyword::any_of: return std::any_of(parts.begin(), parts.end(), fits);
    case Keyword::one_of: return std::count_if(parts.begin(), parts.end(), fits) == 1;
    case Keyword::not_allowed: return !fits(parts.front());
    case Keyword::if_then_else: {
      if (parts[0] == kNoSchema) return true;
      const SchemaIndex then = parts[fits(parts[0]) ? 1 : 2];
      return then == kNoSchema || fits(then);
    }
    default: return fits_text(check, name);
    }
  }

  static bool is_text(yaml::View value, std::string_view text) {
    return json_type(value) == JsonType::text && value.text() == text;
  }
  static bool is_text_type(yaml::View types) {
    if (!types.is_sequence()) return types.text() == "string";
    return std::any_of(types.begin(), types.end(),
                       [](yaml::View type) { return type.text() == "string"; });
  }

  const CheckedSchema& schema_;
  std::int64_t steps_left_;
  std::vector<SchemaFault>* faults_ = nullptr;  ///< null when only the verdict is wanted
  std::vector<yaml::View> path_;
  std::vector<SchemaIndex> applied_;  ///< from the whole schema to the current one
  std::size_t own_schemas_ = 0;       ///< the first of `applied_` that applies to the value itself
};

}  // namespace

std::optional<std::vector<SchemaFault>> apply_schema(const CheckedSchema& schema, yaml::View value,
                                                     std::int64_t& steps_left) {
  return Application(schema, value, steps_left).run(steps_left);
}

}  // namespace smurf
