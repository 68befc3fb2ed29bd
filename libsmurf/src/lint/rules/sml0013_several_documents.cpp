// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml0013_several_documents_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "reads the first document only", "configmaps, run"},
    {&readers::mars2, Effect::loses, "reads the first document only", "configmaps, run"},
    {&readers::envire, Effect::loses, "reads the first document only", "configmaps, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, when(cases::kInMain)},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, when(cases::kInScene)},
    {&readers::phobos, Effect::loses, "refuses the file and continues without the annotations",
     "PyYAML safe_load"},
};

}  // namespace

extern constinit const Rule sml0013_several_documents{
    .id = "SML0013",
    .name = "several-documents",
    .severity = Severity::warning,
    .summary = "A file contains more than one YAML document.",
    .remedy = "Keep one document per file.",
    .facts = kFacts};

}  // namespace smurf::rules::sml0013_several_documents_file
