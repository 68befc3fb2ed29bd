// SPDX-License-Identifier: BSD-3-Clause
// Phobos 2, which reads URDF with Python's XML and YAML with PyYAML.
#include <array>
#include <iterator>

#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::readers::phobos_file {
namespace {

using namespace rules;

/// Rules on invalid numbers in a URDF.
constexpr const Rule* kNoNumber[] = {&sml1801_not_a_number, &sml1805_decimal_comma,
                                     &sml1806_comma_separator, &sml1807_vector_count,
                                     &sml1809_hex_or_suffix};
/// The attributes that Phobos uses in computations or for colours when it loads them.
constexpr std::array<Where, 5> kComputed = {at("origin/@xyz"), at("origin/@rpy"), at("axis/@xyz"),
                                            at("color/@rgba"), at("inertia/@ixx")};

constexpr auto kFamilies = [] {
  std::array<FamilyFact, std::size(kNoNumber) * (kComputed.size() + 1)> facts{};
  std::size_t next = 0;
  for (const Rule* rule : kNoNumber) {
    for (const Where& attribute : kComputed) {
      facts[next++] = {*rule,
                       {&phobos, Effect::refuses, "stops with an exception", kRun, attribute}};
    }
    facts[next++] = {*rule, {&phobos, Effect::changes, "keeps the text", kRun}};
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
