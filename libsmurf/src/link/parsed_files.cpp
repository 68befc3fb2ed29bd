// SPDX-License-Identifier: BSD-3-Clause
#include "link/parsed_files.hpp"

#include <algorithm>
#include <string>

#include "ast/sections.hpp"
#include "base/findings/rules.hpp"

namespace smurf {
namespace {

bool is_same(const SourceMap& a, const SourceMap& b, SourceId source) {
  return static_cast<std::size_t>(source) < b.size() && a.path(source) == b.path(source) &&
         a.text(source) == b.text(source);
}

}  // namespace

ParsedFiles::File* ParsedFiles::find(const SourceMap& sources, SourceId source) {
  const auto known = files_.find(source);
  if (known == files_.end() || !is_same(sources, known->second.text, source)) return nullptr;
  File& file = known->second;
  if (!file.document && !file.robot) return nullptr;
  asked_for_.insert(source);
  return &file;
}

const SourceMap& ParsedFiles::home_of(const SourceMap& sources, SourceId source) {
  if (!is_same(sources, before_, source)) return sources;  // for example those of the edited file
  asked_for_.insert(source);
  File& file = files_[source] = {};
  for (std::size_t i = 0; i < static_cast<std::size_t>(source); ++i) file.text.add_unreadable({});
  file.text.add(sources.path(source), std::string(sources.text(source)));
  return file.text;
}

void ParsedFiles::end_loading(const SourceMap& sources, const DiagnosticSink& found) {
  std::erase_if(files_, [&](const auto& one) { return !asked_for_.contains(one.first); });
  asked_for_.clear();
  with_findings_.clear();
  has_lost_findings_ = false;
  for (const Diagnostic& one : found.diagnostics()) {
    with_findings_.insert(one.span.source);
    has_lost_findings_ = has_lost_findings_ || one.rule == &rules::sml0002_file_too_large;
  }
  before_ = sources;
}

void ParsedFiles::keep(LinkedModel&& model) {
  for (ModelFile& file : model.files) {
    const auto kept = files_.find(file.source);
    if (kept == files_.end() || has_lost_findings_ || with_findings_.contains(file.source))
      continue;
    kept->second.document = std::move(file.document);
    move_sections(model.annotations, file.source, kept->second.annotations);
    if (model.robot && model.robot->document.source == file.source) {
      kept->second.robot = std::move(model.robot);
      model.robot.reset();
    }
  }
}

std::size_t ParsedFiles::bytes() const {
  std::size_t sum = 0;
  for (const auto& [source, file] : files_) sum += file.text.text(source).size();
  return sum;
}

}  // namespace smurf
