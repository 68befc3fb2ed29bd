// SPDX-License-Identifier: BSD-3-Clause
#include "link/read_file.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <vector>

#include "base/deadline.hpp"
#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/edits.hpp"
#include "base/text/suggest.hpp"
#include "base/text/utf8.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

bool has_room(const std::string& path, std::size_t bytes, LoadContext& context) {
  ReadFiles& read = *context.read;
  if (read.known.insert(context.files.identity(path)).second) return true;
  read.repeated += bytes;
  return read.repeated <= context.limits.repeated_bytes;
}

bool is_of_known_kind(std::string_view name) {
  return is_one_of(path::to_lower(path::extension(name)),
                   {".smurf", ".smurfs", ".smurfa", ".urdf", ".sdf", ".srdf", ".yml", ".yaml",
                    ".json", ".stl", ".obj", ".bobj", ".dae", ".ply", ".glb", ".gltf", ".png"});
}

/// What a file is by its first bytes, and what to do; empty for a text.
struct Binary {
  std::string_view begin, name, help;
};
constexpr Binary kBinaries[] = {
    {"PK\x03\x04", "a zip archive", "unpack it, or name it .zsmurf if it contains a SMURF model"},
    {"\x1F\x8B", "a gzip archive", "unpack it"},
    {"\x89PNG", "a PNG image", "name the robot, and not a picture of it"},
    {"\xFF\xD8\xFF", "a JPEG image", "name the robot, and not a picture of it"},
    {"%PDF-", "a PDF document", "name the robot, and not a document about it"},
    {"glTF", "a mesh in glTF", "name the robot that uses the mesh"}};

const Binary* binary_of(std::string_view text) {
  const auto* found = std::find_if(std::begin(kBinaries), std::end(kBinaries),
                                   [&](const Binary& one) { return text.starts_with(one.begin); });
  return found == std::end(kBinaries) ? nullptr : found;
}

}  // namespace

std::optional<SourceId> read_source(const std::string& path, Span reference, const Rule& rule,
                                    LoadContext& context,
                                    const std::function<bool(const std::string&)>& is_taken) {
  Deadline::look();
  FileContent content = context.files.read(path, context.limits.file_bytes);
  if (content.status == ReadStatus::ok && !has_room(path, content.text.size(), context)) {
    if (reference.empty())
      reference = {context.sources.add_unreadable(path::normalize(path)), 0, 0};
    context.sink
        .report(rules::sml0002_file_too_large, reference,
                "with this file, more than " + std::to_string(context.limits.repeated_bytes) +
                    " bytes of files that other models have read are read again")
        .help(raise_limit("repeated-bytes"));
    return std::nullopt;
  }
  if (content.status == ReadStatus::ok) {
    if (const Binary* binary = binary_of(content.text)) {
      if (reference.empty()) {
        reference = {context.sources.add_unreadable(path::normalize(path)), 0, 0};
      }
      context.sink
          .report(rules::sml0003_invalid_utf8, reference,
                  "`" + path::normalize(path) + "` is " + std::string(binary->name) +
                      ", and not a text file")
          .help(std::string(binary->help));
      return std::nullopt;
    }
    return context.sources.add(path::normalize(path), std::move(content.text));
  }
  const bool is_too_large = content.status == ReadStatus::too_large;
  const Rule& reported = is_too_large ? rules::sml0002_file_too_large : rule;
  const bool is_named = !reference.empty();
  if (!is_named) reference = {context.sources.add_unreadable(path::normalize(path)), 0, 0};
  Diagnostic& diagnostic = context.sink.report(
      reported, reference, "cannot read `" + path::normalize(path) + "`: " + content.reason);
  if (path::to_lower(path::extension(path)) == ".urdf") diagnostic.when(cases::kTheUrdf);
  if (is_too_large) {
    diagnostic.message += "; at most " + std::to_string(context.limits.file_bytes) + " are read";
    diagnostic.help(raise_limit("file-bytes"));
  }
  if (content.status != ReadStatus::not_found) return std::nullopt;
  diagnostic.message = "there is no file `" + path::normalize(path) + "`";
  if (const auto similar = similar_file(path, reported, context, is_taken)) {
    diagnostic.help("did you mean `" + *similar + "`?");
    const std::string_view written =
        is_named ? context.sources.text(reference) : std::string_view{};
    const std::string_view name = path::file_name(path);
    const std::size_t at = written.rfind(name);
    if (at != std::string_view::npos && fits_everywhere(*similar)) {
      const auto begin = static_cast<std::uint32_t>(reference.begin + at);
      const auto end = static_cast<std::uint32_t>(begin + name.size());
      diagnostic.fixes.push_back(
          {Applicability::unsafe, {{{reference.source, begin, end}, *similar}}});
    }
  }
  return std::nullopt;
}

std::optional<std::string> similar_name(std::string_view name, std::span<const std::string> names,
                                        const std::function<bool(const std::string&)>& may_be) {
  const std::string extension = path::to_lower(path::extension(name));
  std::map<std::string_view, const std::string*> by_stem;
  for (const std::string& one : names) {
    const bool is_kind = path::to_lower(path::extension(one)) == extension;
    if (is_kind && may_be(one)) by_stem.emplace(path::stem(one), &one);
  }
  std::vector<std::string_view> stems;
  for (const auto& [stem, one] : by_stem) stems.push_back(stem);
  if (const auto near = only_nearest(path::stem(name), stems)) return *by_stem.at(*near);
  std::vector<std::string_view> others;  // those whose extension may be misspelt
  for (const std::string& one : names) {
    if (path::stem(one) == path::stem(name) && may_be(one)) others.push_back(one);
  }
  const auto near = is_of_known_kind(name) ? std::nullopt : only_nearest(name, others);
  return near && is_of_known_kind(*near) ? std::optional(std::string(*near)) : std::nullopt;
}

std::optional<std::string> similar_file(const std::string& path, const Rule& rule,
                                        const LoadContext& context,
                                        const std::function<bool(const std::string&)>& is_taken) {
  constexpr std::uint64_t kMostSought = 20;  // `files` may have a hundred thousand entries
  if (context.sink.count_of(rule) > kMostSought) return std::nullopt;
  const std::string folder(path::parent(path));
  return similar_name(
      path::file_name(path), context.files.list(folder), [&](const std::string& name) {
        return utf8::is_printable(name) && !(is_taken && is_taken(path::join(folder, name)));
      });
}

}  // namespace smurf
