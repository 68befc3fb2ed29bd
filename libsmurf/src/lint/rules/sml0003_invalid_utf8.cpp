// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/file_cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"

namespace smurf::rules::sml0003_invalid_utf8_file {
namespace {

constexpr std::string_view kPasses = "passes the bytes on";
constexpr std::string_view kUnreadable = "passes the bytes on, and Python cannot read such a name";

constexpr Fact kFacts[] = {
    {&readers::dart, Effect::refuses, kUnreadable, "6.20.0, run",
     when(cases::kInUrdf, cases::kInName, kUncertain).since({6, 20})},
    {&readers::urdfdom, Effect::refuses,
     "takes the quote, or the `<`, behind such a byte for a part of a longer character, and refuses "
     "the file",
     "TinyXML, run", when(cases::kInUrdf, cases::kLosesQuote).before({4, 0})},
    {&readers::urdfdom, Effect::takes, kPasses, kRun, when(cases::kInUrdf)},
    {&readers::pinocchio, Effect::refuses, kUnreadable, kRun,
     when(cases::kInUrdf, cases::kInName, kUncertain)},
    {&readers::urdf, Effect::refuses, kUnreadable, "MuJoCo, Drake, PyBullet, run",
     when(cases::kInUrdf, cases::kInName, kUncertain)},
    {&readers::urdf, Effect::takes, kPasses, "MuJoCo, Drake, PyBullet, run", when(cases::kInUrdf)},
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
        "Names with such bytes differ from reader to reader: xacro, browsers and Python refuse the "
        "file or show other characters, others pass the bytes on.",
    .remedy = "Save the file as UTF-8.",
    .sources = "YAML 1.2 section 5.2; XML 1.0 section 2.2.",
    .facts = kFacts};

}  // namespace smurf::rules::sml0003_invalid_utf8_file
