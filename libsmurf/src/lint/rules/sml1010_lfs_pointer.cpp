// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1010_lfs_pointer_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "finds no document in the file", "urdfdom, run"},
};

}  // namespace

extern constinit const Rule sml1010_lfs_pointer{
    .id = "SML1010",
    .name = "no-content",
    .severity = Severity::error,
    .summary = "A file is empty, or has a Git LFS pointer instead of its content.",
    .why = "Readers report \"document empty\", not the cause.",
    .remedy = "Run `git lfs pull`, or restore the file.",
    .sources = "urdfdom, executed: 31 of 941 public files.",
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1010_lfs_pointer_file
