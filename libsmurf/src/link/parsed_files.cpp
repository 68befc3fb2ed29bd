// SPDX-License-Identifier: BSD-3-Clause
#include "link/parsed_files.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "base/findings/rules.hpp"
#include "link/sections_of.hpp"

namespace smurf {
namespace {

bool is_same(const SourceMap& a, const SourceMap& b, SourceId source) {
  return static_cast<std::size_t>(source) < b.size() && a.path(source) == b.path(source) &&
         a.text(source) == b.text(source);
}

/// The adjacent entries of one file.
template <class T>
void move_entries(std::vector<T>& from, SourceId source, std::vector<T>& to) {
  const auto is_here = [&](const T& entry) { return entry.span.source == source; };
  const auto begin = std::find_if(from.begin(), from.end(), is_here);
  const auto end = std::find_if_not(begin, from.end(), is_here);
  if (begin == from.begin() && end == from.end()) {
    to = std::move(from);
    from.clear();
  } else {
    to.assign(std::make_move_iterator(begin), std::make_move_iterator(end));
    from.erase(begin, end);
  }
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
    for_each_section(model.annotations, kept->second.annotations,
                     [&](auto& from, auto& to) { move_entries(from, file.source, to); });
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
