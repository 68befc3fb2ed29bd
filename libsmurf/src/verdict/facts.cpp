// SPDX-License-Identifier: BSD-3-Clause
// Which fact applies to a place of a finding.
#include <string_view>
#include <utility>

#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "smurf/verdict.hpp"
#include "verdict/targets.hpp"

namespace smurf {
namespace {

constexpr Fact kNoAnnotations{.makes = "reads no annotations",
                              .evidence = "it opens the URDF only"};

constexpr Fact kNoCompanions{.makes = "does not read it", .evidence = "it opens the URDF only"};

/// SRDFs, elements `ros2_control` and `gazebo`, and the files of ROS around a robot.
bool is_about_companions(const Rule& rule) {
  for (const std::string_view family :
       {"SML35", "SML36", "SML37", "SML38", "SML39", "SML42", "SML44", "SML45"}) {
    if (rule.id.starts_with(family)) return true;
  }
  return false;
}

constexpr Fact kNoExpansion{.effect = Effect::refuses,
                            .makes = "gets no robot, because xacro fails",
                            .evidence = "xacro 2.1.1, run"};

/// Faults of xacro, which runs before all readers.
bool is_about_expansion(const Rule& rule) { return rule.id.starts_with("SML33"); }

constexpr Fact kReadsFileItself{.makes = "reads the file itself, and no URDF of it",
                                .evidence = "MuJoCo 4.0.0 and libsdformat 12, run"};

/// Whether a finding is about the URDF that was made of an MJCF or SDF file, while this reader
/// reads the file directly.
bool is_beside(const Reader& reader, const Rule& rule, const Circumstances& where) {
  for (const Circumstance* language : {&cases::kOfMjcf, &cases::kOfSdf}) {
    if (where.contains(*language) && reads_itself(reader, *language))
      return !is_taken_over(rule, where, *language);
  }
  return false;
}

/// Whether a rule is about references from annotations, or about their keys.
bool is_about_annotations(const Rule& rule) {
  return rule.id.starts_with("SML3") || rule.id.starts_with("SML4");
}

/// The rule whose facts apply: for "further findings are left out", the rule of the omitted
/// findings.
const Rule& subject_of(const Diagnostic& diagnostic) {
  return diagnostic.left_out == nullptr ? *diagnostic.rule : *diagnostic.left_out;
}

/// Malformed XML and invalid text are faults wherever they are.
bool is_about_content(const Rule& rule) {
  if (!rule.id.starts_with("SML1")) return false;
  return !rule.id.starts_with("SML10") || rule.id == "SML1009" || rule.id == "SML1012";
}

/// The version of a reader that is meant by a target.
Version version_in(const Reader& target, const Reader& of) {
  const auto parts = target.parts.empty() && !target.releases.empty()
                         ? target.releases.front()->parts
                         : target.parts;
  for (const auto& [reader, version] : parts) {
    if (reader == &of) return version;
  }
  return of.number;
}

/// What facts see of a finding.
struct Finding {
  const Reader& target;
  std::span<const PlaceName> path;
  const Circumstances& cases;

  bool fits(const Fact& fact) const {
    const Where& where = fact.where;
    for (const Circumstance* one : where.cases) {
      if (one != nullptr && !cases.contains(*one)) return false;
    }
    if (where.except != nullptr && cases.contains(*where.except)) return false;
    if (!contains(path, where)) return false;
    if (where.from == Version{} && where.until == Version{}) return true;
    const Version version = version_in(target, *fact.reader);
    return where.from <= version && (where.until == Version{} || version < where.until);
  }
};

const Fact* find_unread(const Reader& reader, const Rule& rule, const Finding& finding) {
  if (!is_about_content(rule)) return nullptr;
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    for (const Fact& fact : known->unread) {
      if (finding.fits(fact)) return &fact;
    }
  }
  return nullptr;
}

/// Whether a reader opens SRDFs or parameter files of ROS.
bool reads_companions(const Reader& reader) {
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    if (known == &readers::moveit || known == &readers::ros2_control) return true;
  }
  return false;
}

const Fact* find_fact(const Reader& reader, const Rule& rule, const Finding& finding) {
  if (finding.cases.contains(cases::kInCompanion) && !reads_companions(reader)) {
    return &kNoCompanions;
  }
  if (is_beside(reader, rule, finding.cases)) return &kReadsFileItself;
  if (const Fact* fact = find_unread(reader, rule, finding)) return fact;
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    if (known->drops != nullptr && finding.cases.contains(*known->drops)) continue;
    for (const Fact& fact : rule.facts) {
      if (fact.reader == known && finding.fits(fact)) return &fact;
    }
    for (const auto& [family, fact] : known->families) {
      if (family.covers(rule) && finding.fits(fact)) return &fact;
    }
  }
  if (is_about_companions(rule)) return &kNoCompanions;
  if (is_about_expansion(rule)) return rule.may_pass_elsewhere ? nullptr : &kNoExpansion;
  const bool is_read = reader.reads_annotations || !is_about_annotations(rule);
  return is_read ? nullptr : &kNoAnnotations;
}

}  // namespace

bool reads_itself(const Reader& reader, const Circumstance& language) {
  const Reader& native = &language == &cases::kOfMjcf ? readers::mujoco : readers::gazebo;
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    if (known == &native) return true;
  }
  return false;
}

bool is_taken_over(const Rule& rule, const Circumstances& where, const Circumstance& language) {
  if (where.contains(kMerged)) return false;
  return rule.taken_over == TakenOver::always ||
         (rule.taken_over == TakenOver::from_sdf && &language == &cases::kOfSdf);
}

const Fact* find_fact(const Reader& reader, const Diagnostic& diagnostic, const PlaceView& place) {
  const Finding finding{reader, place.names, place.cases};
  const Fact* worst = find_fact(reader, subject_of(diagnostic), finding);
  for (const Rule* rule : place.consequences) {
    const Fact* fact = find_fact(reader, *rule, finding);
    if (fact != nullptr && (worst == nullptr || fact->effect > worst->effect)) worst = fact;
  }
  return worst;
}

const Fact* find_fact(const Reader& reader, const Diagnostic& diagnostic) {
  const Fact* worst = nullptr;
  for_each_place(diagnostic, [&](const PlaceView& place) {
    const Fact* fact = find_fact(reader, diagnostic, place);
    if (fact != nullptr && (worst == nullptr || fact->effect > worst->effect)) worst = fact;
  });
  return worst;
}

}  // namespace smurf
