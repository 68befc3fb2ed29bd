// SPDX-License-Identifier: BSD-3-Clause
#include "syntax/xml_reader.hpp"

#include "base/findings/rules.hpp"
#include "base/text/words.hpp"
#include "syntax/text_check.hpp"
#include "syntax/xml_scanner.hpp"

namespace smurf {

std::optional<xml::Document> parse_xml(const SourceMap& sources, SourceId id, const Limits& limits,
                                       DiagnosticSink& sink) {
  const std::string_view text = sources.text(id);
  constexpr std::string_view kLfsPointer = "version https://git-lfs";
  if (text.starts_with(kLfsPointer) || trimmed(text).empty()) {
    Diagnostic& diagnostic =
        sink.report(rules::sml1010_lfs_pointer, {id, 0, 0},
                    text.starts_with(kLfsPointer) ? "the file is a Git LFS pointer, not XML"
                                                  : "the file is empty");
    diagnostic.help(text.starts_with(kLfsPointer) ? "run `git lfs pull`"
                                                  : "restore its content, or delete the file");
    return std::nullopt;
  }
  if (!check_text(sources, id, TextFormat::xml, sink)) return std::nullopt;
  return scan_xml(sources, id, limits, sink);
}

}  // namespace smurf
