// SPDX-License-Identifier: BSD-3-Clause
// Annotations of GitHub workflows, and GitLab's code quality report.
#include <array>
#include <charconv>
#include <cstdint>
#include <map>

#include "render/advice.hpp"
#include "render/json_text.hpp"
#include "render/printable.hpp"
#include "smurf/render.hpp"

namespace smurf {
namespace {

std::string_view command(Severity severity) {
  switch (severity) {
  case Severity::error: return "error";
  case Severity::warning: return "warning";
  case Severity::info: break;
  }
  return "notice";
}

/// Workflow commands end at the line end and separate properties by ':' and ','.
std::string escape_command(std::string_view value, bool is_property) {
  std::string out;
  for (const char c : value) {
    switch (c) {
    case '%': out += "%25"; break;
    case '\r': out += "%0D"; break;
    case '\n': out += "%0A"; break;
    case ':': out += is_property ? "%3A" : ":"; break;
    case ',': out += is_property ? "%2C" : ","; break;
    default: out += c;
    }
  }
  return out;
}

std::string_view gitlab_severity(Severity severity) {
  switch (severity) {
  case Severity::error: return "major";
  case Severity::warning: return "minor";
  case Severity::info: break;
  }
  return "info";
}

/// FNV-1a, because a fingerprint only needs to be stable.
std::string fingerprint(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001B3U;
  }
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), hash, 16).ptr;
  const std::string value(digits.data(), end);
  return std::string(digits.size() - value.size(), '0') + value;
}

}  // namespace

std::string render_github(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                          const RepositoryPath& in_repository) {
  std::string out;
  for (const Diagnostic& diagnostic : diagnostics) {
    const auto [begin, end] = render::region_of(diagnostic.span, sources);
    const Rule& rule = *diagnostic.rule;
    out += "::" + std::string(command(diagnostic.severity));
    const std::string path = in_repository(render::path_of(diagnostic.span, sources));
    out += " file=" + escape_command(render::escape(path), true);
    out += ",line=" + std::to_string(begin.line) + ",endLine=" + std::to_string(end.line);
    if (begin.line == end.line) {
      out += ",col=" + std::to_string(begin.column) + ",endColumn=" + std::to_string(end.column);
    }
    out += ",title=" + std::string(rule.id) + " " + std::string(rule.name) + "::";
    std::string message = render::escape(diagnostic.message);
    for (const std::string& note : diagnostic.notes) message += "\nnote: " + render::escape(note);
    const std::string help = render::advice_on(diagnostic);
    if (!help.empty()) message += "\nhelp: " + render::escape(help);
    out += escape_command(message, false) + "\n";
  }
  return out;
}

std::string render_gitlab(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                          const RepositoryPath& in_repository) {
  using render::Json;
  std::map<std::string, std::size_t> occurrences;
  const auto to_json = [&](const Diagnostic& diagnostic) -> Json {
    const auto [begin, end] = render::region_of(diagnostic.span, sources);
    const std::string path = in_repository(render::path_of(diagnostic.span, sources));
    const std::string id(diagnostic.rule->id);
    // Without the line number: a finding is the same after lines or entries were added above it.
    const std::string identity = id + "\n" + path + "\n" + diagnostic.named_pointer;
    const std::string number = std::to_string(++occurrences[identity]);
    // GitLab shows the description only.
    return {
        {"description", id + " " + std::string(diagnostic.rule->name) + ": " + diagnostic.message},
        {"check_name", id},
        {"fingerprint", fingerprint(identity + "\n" + number)},
        {"severity", render::text(gitlab_severity(diagnostic.severity))},
        {"location", {{"path", path}, {"lines", {{"begin", begin.line}, {"end", end.line}}}}}};
  };
  return render::dump_with_list(Json::array(), "", 0, diagnostics, to_json);
}

}  // namespace smurf
