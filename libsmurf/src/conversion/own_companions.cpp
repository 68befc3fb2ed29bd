// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/own_companions.hpp"

#include <algorithm>

#include "link/companions/read_companion.hpp"

namespace smurf {
namespace {

LoadContext quiet_context(const LoadContext& context, DiagnosticSink& quiet) {
  LoadContext own{context.sources,  context.files,           quiet,  context.limits,
                  context.packages, context.package_folders, nullptr};
  own.read = context.read;
  own.xacro = context.xacro;
  own.ties = context.ties;
  own.package_search = context.package_search;
  return own;
}

}  // namespace

OwnCompanions::OwnCompanions(Session& session, LoadedScene& loaded)
    : quiet_(session.limits()), context_(quiet_context(session.context_of(loaded), quiet_)) {}

const Companions& OwnCompanions::of(const LinkedModel& model) {
  const auto [known, is_new] = known_.try_emplace(&model);
  if (is_new) {
    known->second = load_companions(model, context_);
    auto& files = known->second.files;
    std::stable_sort(files.begin(), files.end(), [](const Companion& a, const Companion& b) {
      return a.evidence < b.evidence;
    });
  }
  return known->second;
}

std::optional<Companion> OwnCompanions::named(const std::string& path, CompanionKind kind) {
  const FileContent content = context_.files.read(path, context_.limits.file_bytes);
  if (content.status != ReadStatus::ok) return std::nullopt;
  // An SRDF is recognised by the ending of its name, which a file that the user names may lack.
  const CompanionSpec* spec =
      kind == CompanionKind::srdf ? &spec_of(kind) : find_companion_kind(path, content.text);
  if (spec == nullptr || spec->kind != kind) return std::nullopt;
  auto companion = CompanionReader(context_).read(path, *spec);
  if (!companion || companion->is_broken) return std::nullopt;
  return companion;
}

}  // namespace smurf
