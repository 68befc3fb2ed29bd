// SPDX-License-Identifier: BSD-3-Clause
#include "unit/parsed.hpp"

#include "syntax/xml_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf::test {
namespace {

std::string slice(const SourceMap& sources, Span span) {
  return "[" + visible(sources.text(span)) + "]";
}

std::string_view word(const yaml::View& view) {
  if (view.document().nodes[static_cast<std::size_t>(view.id())].is_alias()) return "alias";
  switch (view.kind()) {
  case yaml::Kind::null: return "null";
  case yaml::Kind::sequence: return "list";
  case yaml::Kind::mapping: return "map";
  case yaml::Kind::scalar: break;
  }
  switch (view.style()) {
  case yaml::Style::plain: return "plain";
  case yaml::Style::single_quoted: return "single";
  case yaml::Style::double_quoted: return "double";
  case yaml::Style::block: break;
  }
  return "block";
}

void add_lines(const SourceMap& sources, const yaml::View& view, Lines& lines) {
  std::string line = yaml::pointer(view.document(), view.id()) + ":";
  const yaml::Node& node = view.document().nodes[static_cast<std::size_t>(view.id())];
  const bool is_member =
      node.parent != yaml::kNoNode &&
      view.document().nodes[static_cast<std::size_t>(node.parent)].kind() == yaml::Kind::mapping;
  if (is_member) line += " " + slice(sources, view.key_span()) + " ->";
  line.append(" ").append(word(view)).append(" ").append(slice(sources, view.span()));
  const bool shows_text = view.is_scalar() && view.text() != sources.text(view.span());
  if (shows_text) line.append(" = ").append(visible(view.text()));
  lines.push_back(std::move(line));
  if (node.is_alias()) return;
  for (const yaml::View child : view) add_lines(sources, child, lines);
}

void add_lines(const SourceMap& sources, const xml::View& view, Lines& lines) {
  const xml::Element& element = view.element();
  std::string line = xml::xpath(view.document(), view.id());
  line.append(" ").append(slice(sources, element.name_span()));
  line.append(" tag ").append(slice(sources, element.tag_span()));
  line.append(" whole ").append(slice(sources, element.span));
  if (!view.text().empty()) {
    line.append(" text ").append(slice(sources, view.text_span()));
    if (view.text() != sources.text(view.text_span()))
      line.append(" = ").append(visible(view.text()));
  }
  lines.push_back(std::move(line));
  for (const xml::Attribute& a : view.attributes()) {
    line = "  @" + std::string(a.name()) + " " + slice(sources, a.name_span()) + " " +
           slice(sources, a.value_span()) + " in " + slice(sources, a.span());
    if (a.value() != sources.text(a.value_span())) line.append(" = ").append(visible(a.value()));
    lines.push_back(std::move(line));
  }
  for (const xml::View child : view) add_lines(sources, child, lines);
}

}  // namespace

std::string join(const Lines& lines) {
  std::string all;
  for (const std::string& line : lines) all += "\n" + line;
  return all;
}

std::string visible(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n')
      out += "\\n";
    else if (text[i] == '\r')
      out += "\\r";
    else if (text[i] == '\t')
      out += "\\t";
    else if (text.substr(i).starts_with("\xEF\xBB\xBF"))
      out += "<BOM>", i += 2;
    else
      out += text[i];
  }
  return out;
}

Lines briefs(const DiagnosticSink& sink, const SourceMap& sources) {
  Lines lines;
  for (const Diagnostic& diagnostic : sink.diagnostics()) {
    const Position at = sources.position(diagnostic.span.source, diagnostic.span.begin);
    lines.push_back(std::string(diagnostic.rule->id) + " " + std::to_string(at.line) + ":" +
                    std::to_string(at.column) + " " + slice(sources, diagnostic.span));
  }
  return lines;
}

ParsedYaml::ParsedYaml(std::string text, const Limits& limits) {
  const SourceId id = sources.add("test.yml", std::move(text));
  document = parse_yaml(sources, id, limits, sink);
}

Lines ParsedYaml::lines() const {
  Lines lines;
  if (document && document->root != yaml::kNoNode) add_lines(sources, root(), lines);
  return lines;
}

ParsedXml::ParsedXml(std::string text, const Limits& limits) {
  const SourceId id = sources.add("test.urdf", std::move(text));
  document = parse_xml(sources, id, limits, sink);
}

Lines ParsedXml::lines() const {
  Lines lines;
  if (document) add_lines(sources, root(), lines);
  return lines;
}

}  // namespace smurf::test
