// SPDX-License-Identifier: BSD-3-Clause
#include "schema/json_schema.hpp"

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "schema/checked_schema.hpp"

namespace smurf {
namespace {

namespace vj = valijson;

/// Schemas that apply themselves to the parts of a value several times double the work with every
/// level.
constexpr std::int64_t kMostSteps = 100000;
constexpr std::int64_t kMostStepsPerValue = 20;
constexpr std::size_t kLongestText = 10000;
/// Comparing each item with each.
constexpr std::size_t kMostUniqueItems = 2000;

struct TooMuchWork {};

/// Counts every schema that is applied, and stands in for `pattern`.
class Guard final : public vj::constraints::PolyConstraint {
 public:
  Guard(std::int64_t& steps_left, const std::string& pattern) : steps_left_(&steps_left) {
    if (!pattern.empty()) pattern_.emplace(pattern, kPatternSyntax);
  }

  bool validate(const vj::adapters::Adapter& target, const std::vector<std::string>& context,
                vj::ValidationResults* results) const override {
    if (--*steps_left_ < 0) throw TooMuchWork{};
    if (!pattern_ || !target.isString()) return true;
    const std::string text = target.asString();
    if (text.size() > kLongestText) throw TooMuchWork{};
    if (std::regex_search(text, *pattern_)) return true;
    if (results != nullptr) results->pushError(context, "Failed to match regex");
    return false;
  }

 private:
  vj::constraints::Constraint* cloneInto(void* place) const override {
    return new (place) Guard(*this);
  }
  size_t sizeOf() const override { return sizeof(Guard); }

  std::int64_t* steps_left_;
  std::optional<std::regex> pattern_;
};

class GuardBuilder final : public vj::ConstraintBuilder {
 public:
  explicit GuardBuilder(std::int64_t& steps_left) : steps_left_(steps_left) {}
  vj::constraints::Constraint* make(const vj::adapters::Adapter& pattern) const override {
    return new Guard(steps_left_, pattern.asString());
  }

 private:
  std::int64_t& steps_left_;
};

std::int64_t count(const nlohmann::json& value) {
  std::int64_t values = 1;
  if (!value.is_structured()) return values;
  for (const nlohmann::json& item : value) values += count(item);
  return values;
}

bool has_long_list(const nlohmann::json& value) {
  if (value.is_array() && value.size() > kMostUniqueItems) return true;
  if (!value.is_structured()) return false;
  for (const nlohmann::json& item : value) {
    if (has_long_list(item)) return true;
  }
  return false;
}

bool asks_for_unique_items(const nlohmann::json& schema) {
  if (!schema.is_structured()) return false;
  if (schema.is_object() && schema.contains("uniqueItems")) return true;
  for (const nlohmann::json& item : schema) {
    if (asks_for_unique_items(item)) return true;
  }
  return false;
}

}  // namespace

struct JsonSchema::Parsed {
  std::int64_t steps_left = 0;
  vj::Schema schema;
  bool has_unique_items = false;
};

JsonSchema::JsonSchema(const nlohmann::json& checked) : parsed_(std::make_unique<Parsed>()) {
  vj::SchemaParser parser(vj::SchemaParser::kDraft7);
  // The parser deletes it.
  parser.addConstraintBuilder(kGuardKey, new GuardBuilder(parsed_->steps_left));
  parser.populateSchema(vj::adapters::NlohmannJsonAdapter(checked), parsed_->schema);
  parsed_->has_unique_items = asks_for_unique_items(checked);
}

JsonSchema::~JsonSchema() = default;

std::optional<std::vector<SchemaFault>> JsonSchema::check(const nlohmann::json& value) const {
  if (parsed_->has_unique_items && has_long_list(value)) return std::nullopt;
  parsed_->steps_left = kMostSteps + kMostStepsPerValue * count(value);
  vj::ValidationResults results;
  try {
    vj::Validator().validate(parsed_->schema, vj::adapters::NlohmannJsonAdapter(value), &results);
  } catch (const TooMuchWork&) {
    return std::nullopt;
  } catch (const std::exception&) {  // a recursion or conversion that valijson refuses
    return std::nullopt;
  }
  std::vector<SchemaFault> faults;
  for (const vj::ValidationResults::Error& error : results) {
    SchemaFault& fault = faults.emplace_back();
    fault.description = error.description;
    // The first is "<root>"; the others are keys and indices in brackets.
    for (std::size_t i = 1; i < error.context.size(); ++i) {
      fault.steps.push_back(error.context[i].substr(1, error.context[i].size() - 2));
    }
  }
  return faults;
}

}  // namespace smurf
