// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules::sml1801_not_a_number_file {
namespace {

constexpr std::string_view kAbsent = "reads an empty number as absent";

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::changes, kAbsent, kRun, "/limit/@lower/#empty"},
    {&readers::mujoco, Effect::changes, kAbsent, kRun, "/limit/@upper/#empty"},
    {&readers::mujoco, Effect::changes, kAbsent, kRun, "/limit/@effort/#empty"},
    {&readers::mujoco, Effect::changes, kAbsent, kRun, "/dynamics/@damping/#empty"},
    {&readers::mujoco, Effect::changes, kAbsent, kRun, "/dynamics/@friction/#empty"},
    {&readers::mujoco, Effect::changes, kAbsent, kRun, "/mimic/@multiplier/#empty"},
    {&readers::mujoco, Effect::changes, kAbsent, kRun, "/mimic/@offset/#empty"},
    {&readers::mujoco, Effect::takes, "reads an empty vector as absent", kRun,
     "/origin/@xyz/#empty"},
    {&readers::mujoco, Effect::takes, "reads an empty vector as absent", kRun,
     "/origin/@rpy/#empty"},
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
