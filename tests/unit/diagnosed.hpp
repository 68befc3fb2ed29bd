// SPDX-License-Identifier: BSD-3-Clause
// Diagnostics about made-up files, and their text.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "smurf/render.hpp"

namespace smurf::test {

inline constexpr Rule kRule{.id = "SML3101",
                            .name = "unknown-joint",
                            .severity = Severity::error,
                            .summary = "A name is not that of a joint.",
                            .why = "MARS drives joint 0 instead.",
                            .remedy = "",
                            .sources = "smurf.cpp:156"};
inline constexpr Rule kOtherRule{.id = "SML0011",
                                 .name = "duplicate-key",
                                 .severity = Severity::warning,
                                 .summary = "",
                                 .why = "",
                                 .remedy = "",
                                 .sources = ""};

/// The first occurrence of `token` in the source.
inline Span find(const SourceMap& sources, SourceId id, std::string_view token) {
  const std::size_t at = sources.text(id).find(token);
  REQUIRE(at != std::string_view::npos);
  return {id, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + token.size())};
}

inline Diagnostic diagnose(Span span, std::string message, std::string caret = {}) {
  Diagnostic diagnostic;
  diagnostic.rule = &kRule;
  diagnostic.severity = Severity::error;
  diagnostic.span = span;
  diagnostic.message = std::move(message);
  diagnostic.caret = std::move(caret);
  return diagnostic;
}

/// Full text of a bare diagnostic at `token` in a file `a.yml`.
inline std::string show(std::string_view text, std::string_view token, int width = 0) {
  SourceMap sources;
  const SourceId id = sources.add("a.yml", std::string(text));
  return render_full(diagnose(find(sources, id, token), "bad", "here"), sources, {false, width});
}

/// The same without the header and the arrow.
inline std::string frame(std::string_view text, std::string_view token, int width = 0) {
  const std::string full = show(text, token, width);
  return full.substr(full.find('\n', full.find("-->")) + 1);
}

inline constexpr std::string_view kMotors = "motors:\n"
                                            "  - name: elbow_motor\n"
                                            "    joint: elbow_jiont\n"
                                            "    type: PID\n";

}  // namespace smurf::test
