// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1801_not_a_number_file {
namespace {

constexpr std::string_view kAbsent = "reads an empty number as absent";

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::changes, kAbsent, kRun,
     at("limit/@lower").when(cases::kEmpty).since({3, 2, 3})},
    {&readers::mujoco, Effect::changes, kAbsent, kRun,
     at("limit/@upper").when(cases::kEmpty).since({3, 2, 3})},
    {&readers::mujoco, Effect::changes, kAbsent, kRun,
     at("limit/@effort").when(cases::kEmpty).since({3, 2, 3})},
    {&readers::mujoco, Effect::changes, kAbsent, kRun,
     at("dynamics/@").when(cases::kEmpty).since({3, 2, 3})},
    {&readers::mujoco, Effect::changes, kAbsent, kRun,
     at("mimic/@").when(cases::kEmpty).since({3, 2, 3})},
    {&readers::mujoco, Effect::takes, "reads an empty vector as absent", kRun,
     at("origin/@xyz").when(cases::kEmpty).since({3, 2, 3})},
    {&readers::mujoco, Effect::takes, "reads an empty vector as absent", kRun,
     at("origin/@rpy").when(cases::kEmpty).since({3, 2, 3})},
};

}  // namespace

extern constinit const Rule sml1801_not_a_number{
    .id = "SML1801",
    .name = "not-a-number",
    .severity = Severity::error,
    .summary = "The value of a numeric attribute is not a number.",
    .why = "urdf-loader reads NaN.",
    .remedy = "Write a decimal number.",
    .sources = "urdf-loader 0.13, executed; 35 of 941 public files.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1801_not_a_number_file
