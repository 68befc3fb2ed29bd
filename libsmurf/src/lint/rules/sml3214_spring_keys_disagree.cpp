// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "ast/keys.hpp"
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3214_spring_keys_disagree_file {
namespace {

struct Pair {
  std::string_view mars, others;
};
constexpr Pair kPairs[] = {{"spring_const_constraint_axis1", "springStiffness"},
                           {"damping_const_constraint_axis1", "springDamping"}};

/// rock-cpp/smurf reads the four keys if all are there, and otherwise none.
void check_count(yaml::View mapping, const Subject& who, Findings& findings) {
  std::string_view missing;
  int count = 0;
  for (const Pair& pair : kPairs) {
    for (const std::string_view key : {pair.mars, pair.others}) {
      const yaml::View value = mapping.find(key);
      if (value && !value.is_null()) {
        ++count;
      } else {
        missing = key;
      }
    }
  }
  if (count != 3 || has_misspelt(mapping, missing)) return;
  Diagnostic& diagnostic = findings.report(place_to_add(mapping, missing),
                                           who + " has no " + quoted(missing) +
                                               ", but the other three keys of its spring");
  diagnostic.note("rock-cpp/smurf reads all four of them, or none");
}

void check(const LinkedModel& model, Findings& findings) {
  for (const JointAnnotation& joint : model.annotations.joints) {
    const yaml::View mapping = mapping_of(model, joint);
    if (!mapping) continue;
    for (const Pair& pair : kPairs) {
      const auto in_mars = number_at(mapping, pair.mars);
      const auto elsewhere = number_at(mapping, pair.others);
      if (!in_mars || !elsewhere || *in_mars == *elsewhere) continue;
      if (*in_mars < 0 || *elsewhere < 0) continue;  // reported
      Diagnostic& diagnostic =
          findings.report(mapping.find(pair.others).span(),
                          quoted(pair.others) + " of " + subject("joint", joint) + " is " +
                              format_number(*elsewhere) + ", but " + quoted(pair.mars) + " is " +
                              format_number(*in_mars));
      diagnostic.label(mapping.find(pair.mars).span(), "what MARS reads");
    }
    check_count(mapping, subject("joint", joint), findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "reads the keys with `constraint`",
     "MARS JointData.cpp:89-164"},
    {&readers::mars2, Effect::changes, "reads both names; the one with `constraint` wins",
     "mars_ode_physics Joint.cpp:180-193"},
    {&readers::envire, Effect::changes, "reads the four keys together or not at all",
     "rock-cpp/smurf Joint.cpp:101-124"},
};

}  // namespace

extern constinit const Rule sml3214_spring_keys_disagree{
    .id = "SML3214",
    .name = "spring-keys-disagree",
    .severity = Severity::warning,
    .summary =
        "The two names for the spring or the damping of a joint have different values, or one is "
        "missing.",
    .why = "The joint differs from reader to reader.",
    .remedy = "Write the same value under both names.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3214_spring_keys_disagree_file
