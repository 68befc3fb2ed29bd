// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/collada_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "mesh/words.hpp"
#include "syntax/xml_reader.hpp"

namespace smurf::collada {

using xml::View;

namespace {

/// Blender once wrote `<` into the values of attributes. XML forbids it; assimp, tinyxml2 and
/// pugixml read it. Keeps the length of the text.
std::string without_brackets_in_values(std::string_view text) {
  std::string plain(text);
  bool is_tag = false;
  char quote = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    char& c = plain[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
      if (c == '<') c = '_';
    } else if (!is_tag && text.substr(i).starts_with("<!--")) {
      i = std::min(text.find("-->", i), text.size() - 1);
    } else if (is_tag && (c == '"' || c == '\'')) {
      quote = c;
    } else if (c == '<' || c == '>') {
      is_tag = c == '<';
    }
  }
  return plain;
}

}  // namespace

File::File(std::string_view text) {
  // The tree needs some hundred bytes per element; real files have few elements, because numbers
  // are in lists.
  constexpr auto kMostElements = 1000000;
  has_too_many_elements_ = std::count(text.begin(), text.end(), '<') > kMostElements;
  if (has_too_many_elements_) return;
  const SourceId source = sources_.add("", std::string(text));
  DiagnosticSink sink;
  document_ = parse_xml(sources_, source, Limits{}, sink);
  if (document_) return;
  DiagnosticSink second_sink;
  const SourceId second = sources_.add("", without_brackets_in_values(text));
  document_ = parse_xml(sources_, second, Limits{}, second_sink);
  if (document_) return;
  defect_ = {"it is not XML", 0, 1};
  for (const Diagnostic& diagnostic : sink.diagnostics()) {
    if (diagnostic.severity != Severity::error) continue;
    defect_ = {diagnostic.message, diagnostic.span.begin,
               sources_.position(source, diagnostic.span.begin).line};
    return;
  }
}

std::uint32_t File::line_of(View element) const {
  return sources_.line_of(document_->source, element.element().name_span().begin);
}

MeshDependency File::dependency_at(View element) const {
  const Span span = element.text_span();
  return {.filename = std::string(trimmed_text(element)),
          .kind = MeshDependency::Kind::texture,
          .line = line_of(element),
          .offset = span.begin,
          .length = span.end - span.begin};
}

MeshDefect File::defect_at(View element, std::string what) const {
  return {std::move(what), element.element().name_span().begin, line_of(element)};
}

std::string_view value(View element, std::string_view attribute) {
  const xml::Attribute* found = element.attribute(attribute);
  return found == nullptr ? std::string_view() : found->value();
}

std::string_view trimmed_text(View element) { return Words(element.text()).rest_of_line(); }

std::string_view id_in(std::string_view reference) {
  return reference.starts_with('#') ? reference.substr(1) : std::string_view();
}

std::vector<double> numbers(std::string_view text) {
  std::vector<double> all;
  all.reserve(text.size() / 8);  // most numbers have seven characters
  Words words(text);
  while (!words.is_at_end()) all.push_back(parse_number(words.next()).value_or(std::nan("")));
  return all;
}

bool is_finite(const std::vector<double>& all) {
  return std::all_of(all.begin(), all.end(), [](double x) { return std::isfinite(x); });
}

View positions_of(View mesh) {
  const View vertices = mesh.child("vertices");
  if (!vertices) return {};
  for (const View input : vertices) {
    const std::string_view id = id_in(value(input, "source"));
    if (value(input, "semantic") != "POSITION" || id.empty()) continue;
    for (const View source : mesh) {
      if (value(source, "id") == id) return source;
    }
    return {};
  }
  return {};
}

std::size_t Layout::points(std::size_t numbers) const {
  const std::size_t needed = offset + std::max({axes[0], axes[1], axes[2]}) + 1;
  return numbers < needed ? 0 : 1 + (numbers - needed) / stride;
}

Layout layout_of(View source) {
  Layout layout;
  const View technique = source.child("technique_common");
  const View accessor = technique ? technique.child("accessor") : View();
  if (!accessor) return layout;
  constexpr std::int64_t kMost = 1 << 30;  // a number out of range would become 0
  const auto stride = parse_integer(value(accessor, "stride"));
  if (stride && *stride >= 3) layout.stride = static_cast<std::size_t>(std::min(*stride, kMost));
  const auto offset = parse_integer(value(accessor, "offset"));
  if (offset && *offset > 0) layout.offset = static_cast<std::size_t>(std::min(*offset, kMost));
  // A parameter without a name skips a number.
  std::size_t place = 0;
  for (const View param : accessor) {
    if (param.name() != "param") continue;
    const std::string_view name = value(param, "name");
    if (name.size() == 1 && name[0] >= 'X' && name[0] <= 'Z' && place < layout.stride) {
      layout.axes[static_cast<std::size_t>(name[0] - 'X')] = place;
    }
    ++place;
  }
  return layout;
}

std::optional<double> unit_of(View asset) {
  const View unit = asset.child("unit");
  const auto meters = unit ? parse_number(value(unit, "meter")) : std::nullopt;
  return meters && *meters > 0 ? meters : std::nullopt;
}

bool transform(View element, Affine& X) {
  const std::string_view name = element.name();
  const std::size_t count = name == "matrix"                         ? 16
                            : name == "rotate"                       ? 4
                            : name == "translate" || name == "scale" ? 3
                                                                     : 0;
  if (count == 0) return true;
  const std::vector<double> all = numbers(element.text());
  if (all.size() != count || !is_finite(all)) return false;
  if (name == "matrix") {
    Affine matrix;
    std::copy_n(all.begin(), matrix.rows.size(), matrix.rows.begin());
    X = X * matrix;
    return true;
  }
  const Vector3 vector{all[0], all[1], all[2]};
  const double length = hypotenuse(vector[0], vector[1], vector[2]);
  if (name == "translate") X = X * translation(vector);
  if (name == "scale") X = X * scaling(vector);
  if (name == "rotate" && length > 0) {
    constexpr double kRadians = std::numbers::pi / 180;
    const Vector3 axis{vector[0] / length, vector[1] / length, vector[2] / length};
    X = X * rotation(from_axis_angle(axis, all[3] * kRadians));
  }
  return true;
}

}  // namespace smurf::collada
