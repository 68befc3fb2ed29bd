// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml0001_unreadable_file_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "cannot read the file", "any reader"},
};

}  // namespace

extern constinit const Rule sml0001_unreadable_file{
    .id = "SML0001",
    .name = "unreadable-file",
    .severity = Severity::error,
    .summary = "A file that was to be checked cannot be read.",
    .why = "Nothing in the file was checked.",
    .remedy = "Check the path and its permissions.",
    .sources = "The operating system.",
    .facts = kFacts};

}  // namespace smurf::rules::sml0001_unreadable_file_file
