// SPDX-License-Identifier: BSD-3-Clause
#include "check/xacro_places.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "imports/imports.hpp"
#include "verdict/targets.hpp"

namespace smurf {
namespace {

/// The calls and includes around a part of the result, the innermost first.
std::vector<const xacro::Frame*> frames_around(const xacro::Expansion& expansion,
                                               xacro::FrameId at) {
  std::vector<const xacro::Frame*> frames;
  while (at != xacro::kNoFrame) {
    const xacro::Frame& frame = expansion.frame(at);
    if (!frame.call.empty()) frames.push_back(&frame);
    at = frame.parent;
  }
  return frames;
}

void add_labels(const xacro::Expansion& expansion, const xacro::Origin& origin,
                Diagnostic& diagnostic) {
  constexpr std::size_t kMostFrames = 8;
  for (const xacro::Input& input : origin.inputs) {
    if (input.place.empty() || input.place == origin.span) continue;
    diagnostic.label(input.place, quoted(input.name) + " comes from here");
  }
  const auto frames = frames_around(expansion, origin.frame);
  for (std::size_t i = 0; i < std::min(frames.size(), kMostFrames); ++i) {
    diagnostic.label(frames[i]->call, xacro::label_of(*frames[i]));
  }
}

/// The fix with its bytes in the xacro files; false if one of them was computed.
bool place(const xacro::Expansion& expansion, Fix& fix) {
  if (fix.new_name && fix.new_name->among.source == expansion.source) return false;
  for (Edit& edit : fix.edits) {
    if (edit.span.source != expansion.source) continue;
    const xacro::Origin origin = expansion.origin_of(edit.span);
    if (!origin.is_exact || edit.span.empty()) return false;
    // In a macro, an expression would be read where a text is meant.
    if (edit.text.find_first_of("$&<\"'") != std::string::npos) return false;
    edit.span = origin.span;
  }
  return true;
}

/// A mesh that is not there is one cause, although it lacks as a shape and as a mass.
void join_missing_meshes(std::vector<Diagnostic>& found) {
  std::set<std::tuple<SourceId, std::uint32_t>> weighed;
  for (const Diagnostic& one : found) {
    if (one.rule == &rules::sml9302_mjcf_file_missing)
      weighed.emplace(one.span.source, one.span.begin);
  }
  if (weighed.empty()) return;
  std::erase_if(found, [&](const Diagnostic& one) {
    return one.rule == &rules::sml1604_mesh_missing &&
           weighed.contains({one.span.source, one.span.begin});
  });
}

/// Moves a finding to its place in the xacro files, and notes the call around it.
void move_to_xacro(const xacro::Expansion& expansion, Diagnostic& diagnostic) {
  const xacro::Origin origin = expansion.origin_of(diagnostic.span);
  diagnostic.expanded = diagnostic.span;
  diagnostic.span = origin.span;
  for (Label& label : diagnostic.labels) {
    if (label.span.source == expansion.source) label.span = expansion.origin_of(label.span).span;
  }
  std::erase_if(diagnostic.fixes, [&](Fix& fix) { return !place(expansion, fix); });
  add_labels(expansion, origin, diagnostic);
  const auto frames = frames_around(expansion, origin.frame);
  if (!frames.empty()) diagnostic.call = frames.front()->call;
}

/// Whether the reader of a language is known to load files with the fault of a rule, which is about
/// what programs make of a file.
bool is_loaded(const Rule& rule, const Circumstance& language) {
  if (rule.about != About::readers) return false;
  const Reader& native = &language == &cases::kOfMjcf ? readers::mujoco : readers::gazebo;
  bool loads = false;
  for (const Fact& one : rule.facts) {
    if (one.reader != &native) continue;
    if (one.effect > Effect::loses) return false;
    loads = true;
  }
  return loads;
}

/// Marks findings in a URDF that was made of another language. What programs make of a URDF does
/// not matter to somebody who has none, unless a target asks for it.
void mark_imports(const xacro::Expansions& expansions, std::vector<Diagnostic>& found) {
  std::map<SourceId, const Circumstance*> kinds;
  for (const auto& [source, expansion] : expansions)
    kinds.emplace(source, mark_of(expansion.language));
  for (Diagnostic& one : found) {
    const auto kind = kinds.find(one.span.source);
    if (kind == kinds.end() || kind->second == nullptr) continue;
    one.cases.add(*kind->second);
    for (Occurrence& other : one.others) other.cases.add(*kind->second);
    if (one.rule->about != About::robot && !is_taken_over(*one.rule, one.cases, *kind->second))
      one.severity = Severity::info;
    if (one.severity == Severity::error && is_loaded(*one.rule, *kind->second))
      one.severity = Severity::warning;
  }
}

}  // namespace

const Circumstance* mark_of(Language language) {
  return language == Language::mjcf  ? &cases::kOfMjcf
         : language == Language::sdf ? &cases::kOfSdf
                                     : nullptr;
}

void place_in_xacro(const xacro::Expansions& expansions, const SourceMap& sources,
                    std::vector<Diagnostic>& found) {
  // A part that only a URDF needs is nobody's, and no rule on masses or on writing is meant for it.
  std::erase_if(found, [&](const Diagnostic& diagnostic) {
    const auto expansion = expansions.find(diagnostic.span.source);
    const bool is_about_masses = diagnostic.rule->id.starts_with("SML15");
    // What a conversion loses was written in some way.
    if (expansion == expansions.end() || diagnostic.rule->reported_by != Tool::lint) return false;
    if (diagnostic.severity == Severity::error && !is_about_masses) return false;
    const auto is_made = [&](const auto& place) {
      return imports::is_made(expansion->second, place.span);
    };
    // The density of a shape is that of its mass.
    return is_made(diagnostic) ||
           (is_about_masses &&
            std::any_of(diagnostic.labels.begin(), diagnostic.labels.end(), is_made));
  });
  mark_imports(expansions, found);
  for (Diagnostic& diagnostic : found) {
    const auto expansion = expansions.find(diagnostic.span.source);
    if (expansion != expansions.end()) {
      move_to_xacro(expansion->second, diagnostic);
    } else if (xacro::is_xacro_file(sources.path(diagnostic.span.source))) {
      diagnostic.expanded = diagnostic.span;  // where each call finds the same fault
    }
  }
  join_missing_meshes(found);
}

}  // namespace smurf
