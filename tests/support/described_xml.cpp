// SPDX-License-Identifier: BSD-3-Clause
#include "support/described_xml.hpp"

#include <sstream>

#include "syntax/tinyxml2_referee.hpp"
#include "syntax/xml_reader.hpp"

namespace smurf::test {
namespace {

std::ostream& operator<<(std::ostream& out, Span span) {
  return out << span.begin << '-' << span.end;
}

}  // namespace

std::string described_xml(XmlReader reader, const std::string& text) {
  SourceMap sources;
  DiagnosticSink sink;
  const SourceId id = sources.add("a.urdf", text);
  auto document = parse_xml(sources, id, {}, sink);
  if (reader == XmlReader::tinyxml2 && document && !read_by_tinyxml2(*document, sources, sink)) {
    document.reset();
  }
  std::ostringstream out;
  for (const Diagnostic& diagnostic : sink.diagnostics()) {
    out << diagnostic.rule->id << ' ' << diagnostic.span << ' ' << diagnostic.message << '\n';
  }
  if (!document) return out.str() + "refused";
  for (std::size_t n = 0; n < document->elements.size(); ++n) {
    const xml::View view(*document, xml::ElementId{static_cast<std::uint32_t>(n)});
    const xml::Element& element = view.element();
    out << element.name() << ' ' << element.span << ' ' << element.tag_span() << ' '
        << element.name_span() << " parent " << static_cast<std::uint32_t>(element.parent)
        << " first " << static_cast<std::uint32_t>(document->first_child(view.id())) << " next "
        << static_cast<std::uint32_t>(element.next_sibling) << " text `" << view.text() << "` "
        << view.text_span();
    for (std::uint32_t i = 0; i < element.attribute_count; ++i) {
      const xml::Attribute& attribute = document->attributes[element.first_attribute + i];
      out << ' ' << attribute.name() << "=`" << attribute.value() << "` " << attribute.name_span()
          << ' ' << attribute.value_span() << ' ' << attribute.span();
    }
    out << '\n';
  }
  for (const Span comment : document->comments) out << comment << '\n';
  return out.str();
}

}  // namespace smurf::test
