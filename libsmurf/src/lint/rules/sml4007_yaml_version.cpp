// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml4007_yaml_version_file {

namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "reads what is written",
     "configmaps ConfigAtom.hpp:335-386, run"},
    {&readers::phobos, Effect::changes,
     "follows YAML 1.1: `1e-5` and `-.5` are texts, `010` is 8, `on` and `no` are booleans, `12:30` is 750",
     "PyYAML 6.0 resolver.py, run"},
};

}  // namespace

extern constinit const Rule sml4007_yaml_version{
    .id = "SML4007",
    .name = "yaml-version",
    .severity = Severity::warning,
    .summary = "A value means something else to readers of YAML 1.1, such as Phobos.",
    .remedy = "Write numbers with a point and a sign in the exponent (1.0e-5), and quote texts.",
    .facts = kFacts};

}  // namespace smurf::rules::sml4007_yaml_version_file
