// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <utility>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4119_approximation_coefficients_file {
namespace {

struct Function {
  std::string_view name;
  std::size_t coefficients;
};
constexpr Function kFunctions[] = {
    {"polynom2", 3}, {"polynom3", 4}, {"polynom4", 5}, {"polynom5", 6}};

constexpr std::pair<std::string_view, std::string_view> kKeys[] = {
    {"maxeffort_approximation", "maxeffort_coefficients"},
    {"maxspeed_approximation", "maxspeed_coefficients"}};

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    const yaml::View mapping = mapping_of(model, motor);
    for (const auto& [approximation, coefficients] : kKeys) {
      const auto name = text_at(mapping, approximation);
      if (!name) continue;
      const yaml::View list = mapping.find(coefficients);
      const std::size_t count = list && list.is_sequence() ? list.size() : 0;
      for (const Function& function : kFunctions) {
        if (name->value != function.name || count >= function.coefficients) continue;
        findings.report(list ? list.key_span() : name->span,
                        quoted(function.name) + " needs " + std::to_string(function.coefficients) +
                            " coefficients, but there are " + std::to_string(count));
      }
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "reads memory beyond the end of the list",
     "MARS MotorData.cpp"},
};

}  // namespace

extern constinit const Rule sml4119_approximation_coefficients{
    .id = "SML4119",
    .name = "approximation-coefficients",
    .severity = Severity::error,
    .summary = "An approximation of a motor has fewer coefficients than its function needs.",
    .remedy = "Write all coefficients.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4119_approximation_coefficients_file
