// SPDX-License-Identifier: BSD-3-Clause
#include "schema/json_schema.hpp"

#include <mutex>
#include <utility>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace smurf {
namespace {

namespace vj = valijson;

constexpr std::size_t kMatchesForStep = 30;  // steps of Pattern::steps_for() in a step of 1 us
constexpr std::size_t kPairsForStep = 64;    // items that are compared with each other
/// The library matches names with std::regex, which needs a stack frame per character, and
/// quadratic time in the length of the name.
constexpr std::size_t kLongestMatchedName = 256;
constexpr std::size_t kNameForStep = 250;  // characters, squared
/// Each uses 300 bytes of memory, and nobody reads so many.
constexpr std::size_t kMostErrors = 300'000;

struct TooMuchWork {};

/// Counts the work of every applied schema, and replaces `pattern`.
class Guard final : public vj::constraints::PolyConstraint {
 public:
  Guard(std::int64_t& steps_left, const SchemaGuard& guard)
      : steps_left_(&steps_left), guard_(&guard) {}

  bool validate(const vj::adapters::Adapter& target, const std::vector<std::string>& context,
                vj::ValidationResults* results) const override {
    spend(guard_->steps);
    if (results != nullptr && results->numErrors() > kMostErrors) throw TooMuchWork{};
    if (guard_->has_unique_items && target.isArray()) {
      const std::size_t items = target.getArraySize();
      spend(static_cast<std::int64_t>(items * items / kPairsForStep));
    }
    if (guard_->has_name_patterns && target.isObject()) spend_for_names(target);
    if (!guard_->pattern || !target.isString()) return true;
    const std::string text = target.asString();
    spend(static_cast<std::int64_t>(guard_->pattern->steps_for(text) / kMatchesForStep));
    if (guard_->pattern->is_in(text)) return true;
    if (results != nullptr) results->pushError(context, "Failed to match regex");
    return false;
  }

 private:
  void spend(std::int64_t steps) const {
    *steps_left_ -= steps;
    if (*steps_left_ < 0) throw TooMuchWork{};
  }

  void spend_for_names(const vj::adapters::Adapter& target) const {
    target.applyToObject([&](const std::string& name, const vj::adapters::Adapter&) {
      if (name.size() > kLongestMatchedName) throw TooMuchWork{};
      spend(static_cast<std::int64_t>(1 + name.size() * name.size() / kNameForStep) *
            guard_->steps / kStepsForNamePattern);
      return true;
    });
  }

  vj::constraints::Constraint* cloneInto(void* place) const override {
    return new (place) Guard(*this);
  }
  size_t sizeOf() const override { return sizeof(Guard); }

  std::int64_t* steps_left_;
  const SchemaGuard* guard_;
};

class GuardBuilder final : public vj::ConstraintBuilder {
 public:
  GuardBuilder(std::int64_t& steps_left, const std::vector<SchemaGuard>& guards)
      : steps_left_(steps_left), guards_(guards) {}
  vj::constraints::Constraint* make(const vj::adapters::Adapter& index) const override {
    return new Guard(steps_left_, guards_[static_cast<std::size_t>(index.asInteger())]);
  }

 private:
  std::int64_t& steps_left_;
  const std::vector<SchemaGuard>& guards_;
};

}  // namespace

struct JsonSchema::Parsed {
  std::vector<SchemaGuard> guards;
  std::int64_t steps_left = 0;
  std::mutex is_in_use;  ///< files take turns, because the guards count for one file
  vj::Schema schema;
};

JsonSchema::JsonSchema(CheckedSchema checked) : parsed_(std::make_unique<Parsed>()) {
  parsed_->guards = std::move(checked.guards);
  vj::SchemaParser parser(vj::SchemaParser::kDraft7);
  // The parser deletes it.
  parser.addConstraintBuilder(kGuardKey, new GuardBuilder(parsed_->steps_left, parsed_->guards));
  parser.populateSchema(vj::adapters::NlohmannJsonAdapter(checked.schema), parsed_->schema);
}

JsonSchema::~JsonSchema() = default;

std::optional<std::vector<SchemaFault>> JsonSchema::check(const nlohmann::json& value,
                                                          std::int64_t& steps_left) const {
  const std::lock_guard lock(parsed_->is_in_use);
  parsed_->steps_left = std::exchange(steps_left, 0);
  vj::ValidationResults results;
  try {
    vj::Validator().validate(parsed_->schema, vj::adapters::NlohmannJsonAdapter(value), &results);
  } catch (const TooMuchWork&) {
    return std::nullopt;
  } catch (const std::exception&) {  // a recursion or conversion that valijson refuses
    return std::nullopt;
  }
  steps_left = parsed_->steps_left;
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
