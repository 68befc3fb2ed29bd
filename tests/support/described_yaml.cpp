// SPDX-License-Identifier: BSD-3-Clause
#include "support/described_yaml.hpp"

#include <sstream>

namespace smurf::test {

std::string described_yaml(YamlEngine engine, const std::string& text) {
  SourceMap sources;
  DiagnosticSink sink;
  const SourceId id = sources.add("a.yml", text);
  const auto document = parse_yaml_by(engine, sources, id, {}, sink);
  std::ostringstream out;
  for (const Diagnostic& diagnostic : sink.diagnostics()) {
    out << diagnostic.rule->id << ' ' << diagnostic.span.begin << '-' << diagnostic.span.end << ' '
        << diagnostic.message << '\n';
  }
  if (!document) return out.str() + "refused";
  for (const yaml::Node& node : document->nodes) {
    out << static_cast<int>(node.kind()) << ' ' << static_cast<int>(node.style) << ' '
        << node.is_repeated << ' ' << node.position() << ' ' << node.child_count() << " parent "
        << static_cast<std::uint32_t>(node.parent) << " first "
        << static_cast<std::uint32_t>(node.first_child()) << " target "
        << static_cast<std::uint32_t>(node.target()) << " next "
        << static_cast<std::uint32_t>(node.next_sibling) << ' ' << node.span.begin << '-'
        << node.span.end << ' ' << node.key_span().begin << '-' << node.key_span().end << " `"
        << node.key() << "` `" << node.text() << "`\n";
  }
  return out.str();
}

}  // namespace smurf::test
