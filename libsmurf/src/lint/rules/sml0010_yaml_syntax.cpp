// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml0010_yaml_syntax_file {
namespace {

constexpr std::string_view kLastLine = "reads a last line without `:` as a key without a value";

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, kLastLine, "yaml-cpp 0.7, run", when(cases::kLine)},
    {&readers::mars, Effect::changes, "closes the quote at the end of the file",
     "yaml-cpp 0.7, run", when(cases::kQuote, cases::kInMain)},
    {&readers::mars2, Effect::changes, kLastLine, "yaml-cpp 0.7, run", when(cases::kLine)},
    {&readers::envire, Effect::changes, kLastLine, "yaml-cpp 0.7, run", when(cases::kLine)},
    {&readers::mars, Effect::crashes, "ends with an uncaught exception", "configmaps, run"},
    {&readers::mars2, Effect::crashes, "ends with an uncaught exception", "configmaps, run"},
    {&readers::envire, Effect::crashes, "ends with an uncaught exception", "configmaps, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, when(cases::kInMain)},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, when(cases::kInScene)},
    {&readers::phobos, Effect::loses, "logs the error and continues without the annotations",
     "Phobos smurfrobot.py"},
};

}  // namespace

extern constinit const Rule sml0010_yaml_syntax{
    .id = "SML0010",
    .name = "yaml-syntax",
    .severity = Severity::error,
    .summary = "A file is not well-formed YAML.",
    .why = "No reader can use the file.",
    .remedy =
        "Correct the line; indentation (spaces only), an unclosed bracket or quote and an unquoted "
        "`: ` inside a value are the usual causes.",
    .sources = "yaml-cpp 0.7 and PyYAML 6.0, executed.",
    .facts = kFacts};

}  // namespace smurf::rules::sml0010_yaml_syntax_file
