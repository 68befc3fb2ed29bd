// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml0003_invalid_utf8_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses bytes that are not UTF-8, or shows other characters",
     "urdf-loader, run", at("robot")},
    {&readers::mars, Effect::changes, "passes the bytes on", "yaml-cpp 0.7, run"},
    {&readers::phobos, Effect::loses, "logs the error and continues without the annotations", kRun,
     when(cases::kInAnnotations)},
    {&readers::phobos, Effect::refuses, "refuses the file", "PyYAML 6.0, run"},
};

}  // namespace

extern constinit const Rule sml0003_invalid_utf8{
    .id = "SML0003",
    .name = "invalid-utf8",
    .severity = Severity::error,
    .summary = "A file contains bytes that are not valid UTF-8.",
    .why =
        "Names with such bytes differ from reader to reader: some refuse the file, others pass the "
        "bytes on.",
    .remedy = "Save the file as UTF-8.",
    .sources = "YAML 1.2 section 5.2; XML 1.0 section 2.2.",
    .facts = kFacts};

}  // namespace smurf::rules::sml0003_invalid_utf8_file
