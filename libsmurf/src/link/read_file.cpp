// SPDX-License-Identifier: BSD-3-Clause
#include "link/read_file.hpp"
#include "base/edits.hpp"

#include "base/limits.hpp"
#include "base/path.hpp"
#include "base/rules.hpp"
#include "base/suggest.hpp"
#include "base/utf8.hpp"

namespace smurf {
namespace {

bool has_room(const std::string& path, std::size_t bytes, LoadContext& context) {
  ReadFiles& read = *context.read;
  if (read.known.insert(context.files.identity(path)).second) return true;
  read.repeated += bytes;
  return read.repeated <= context.limits.repeated_bytes;
}

}  // namespace

std::optional<SourceId> read_source(const std::string& path, Span reference, const Rule& rule,
                                    LoadContext& context) {
  FileContent content = context.files.read(path, context.limits.file_bytes);
  if (content.status == ReadStatus::ok && !has_room(path, content.text.size(), context)) {
    if (reference.empty())
      reference = {context.sources.add_unreadable(path::normalize(path)), 0, 0};
    context.sink
        .report(rules::sml0002_file_too_large, reference,
                "with this file, more than " + std::to_string(context.limits.repeated_bytes) +
                    " bytes are read again of files that other models read before")
        .help(raise_limit("repeated-bytes"));
    return std::nullopt;
  }
  if (content.status == ReadStatus::ok) {
    return context.sources.add(path::normalize(path), std::move(content.text));
  }
  const bool is_too_large = content.status == ReadStatus::too_large;
  const Rule& reported = is_too_large ? rules::sml0002_file_too_large : rule;
  const bool is_named = !reference.empty();
  if (!is_named) reference = {context.sources.add_unreadable(path::normalize(path)), 0, 0};
  Diagnostic& diagnostic = context.sink.report(
      reported, reference, "cannot read `" + path::normalize(path) + "`: " + content.reason);
  const std::string extension = path::to_lower(path::extension(path));
  if (extension.size() > 1) diagnostic.construct = extension.substr(1);
  if (is_too_large) {
    diagnostic.message += "; at most " + std::to_string(context.limits.file_bytes) + " are read";
    diagnostic.help(raise_limit("file-bytes"));
  }
  if (content.status != ReadStatus::not_found) return std::nullopt;
  diagnostic.message = "there is no file `" + path::normalize(path) + "`";
  if (const auto similar = similar_file(path, reported, context)) {
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

std::optional<std::string> similar_file(const std::string& path, const Rule& rule,
                                        const LoadContext& context) {
  constexpr std::uint64_t kMostSought = 20;  // a file may list a hundred thousand
  if (context.sink.count_of(rule) > kMostSought) return std::nullopt;
  const std::vector<std::string> names = context.files.list(std::string(path::parent(path)));
  std::vector<std::string_view> same_kind;
  const std::string extension = path::to_lower(path::extension(path));
  for (const std::string& name : names) {
    const bool is_kind = path::to_lower(path::extension(name)) == extension;
    if (is_kind && utf8::is_printable(name)) same_kind.push_back(name);
  }
  if (const auto near = nearest(path::file_name(path), same_kind)) return std::string(*near);
  return std::nullopt;
}

}  // namespace smurf
