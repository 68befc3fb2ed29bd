// SPDX-License-Identifier: BSD-3-Clause
// Phobos 2, which reads URDF with Python's XML and YAML with PyYAML.
#include "base/findings/readers.hpp"

#include <array>

namespace smurf::readers::phobos_file {
namespace {

/// Rules on invalid numbers in a URDF.
constexpr std::array<std::string_view, 5> kNoNumber = {"SML1801", "SML1805", "SML1806", "SML1807",
                                                       "SML1809"};
/// The attributes that Phobos uses in computations or for colours when it loads them.
constexpr std::array<Where, 5> kComputed = {at("origin/@xyz"), at("origin/@rpy"), at("axis/@xyz"),
                                            at("color/@rgba"), at("inertia/@ixx")};

constexpr auto kFamilies = [] {
  std::array<FamilyFact, kNoNumber.size() * (kComputed.size() + 1)> facts{};
  std::size_t next = 0;
  for (const std::string_view rule : kNoNumber) {
    for (const Where& attribute : kComputed) {
      facts[next++] = {rule,
                       {&phobos, Effect::refuses, "stops with an exception", kRun, attribute}};
    }
    facts[next++] = {rule, {&phobos, Effect::changes, "keeps the text", kRun}};
  }
  return facts;
}();

}  // namespace

extern constinit const Reader phobos{.name = "phobos",
                                     .title = "Phobos 2",
                                     .basis = "a613e31, run; nothing of Blender",
                                     .like = &urdf,
                                     .version = "Phobos a613e31",
                                     .families = kFamilies,
                                     .reads_annotations = true};

}  // namespace smurf::readers::phobos_file
