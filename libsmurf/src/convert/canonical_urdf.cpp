// SPDX-License-Identifier: BSD-3-Clause
// Writes a URDF in canonical form, so that two versions differ only where the robots differ:
// materials, then links and joints in the order of the tree, then unchanged extensions; attributes
// in the order of the specification; the shortest numbers; no comments.
#include <algorithm>
#include <map>
#include <tuple>

#include "ast/urdf_schema.hpp"
#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "base/text/edits.hpp"
#include "base/text/words.hpp"
#include "convert/passes.hpp"

namespace smurf {
namespace {

/// The attributes of all elements, in the order of the tables.
std::vector<const urdf::AttributeSpec*> attributes_in_order() {
  std::vector<const urdf::AttributeSpec*> order;
  for (const urdf::ElementSpec& element : urdf::all_element_specs()) {
    for (const urdf::AttributeSpec& attribute : element.attributes) order.push_back(&attribute);
  }
  return order;
}

/// Numbers in their shortest form, separated by single spaces; other texts unchanged.
std::string canonical_value(std::string_view value) {
  std::string text;
  std::string_view rest = value;
  while (!rest.empty()) {
    const std::size_t begin = rest.find_first_not_of(' ');
    if (begin == std::string_view::npos) break;
    const std::size_t end = std::min(rest.find(' ', begin), rest.size());
    const auto number = parse_number(rest.substr(begin, end - begin));
    if (!number) return std::string(value);
    text += (text.empty() ? "" : " ") + format_number(*number);
    rest.remove_prefix(end);
  }
  return text.empty() ? std::string(value) : text;
}

class CanonicalWriter {
 public:
  CanonicalWriter(const LinkedModel& model, std::string_view text) : model_(model), text_(text) {}

  std::string write() {
    const xml::View robot = model_.robot->document.view();
    out_ = "<?xml version=\"1.0\"?>\n";
    open(robot, 0, ">\n");
    for (const xml::View child : robot) {
      if (child.name() == "material") element(child, 1);
    }
    for (const LinkIndex link : model_.tree.order) {
      if (const auto joint = model_.tree.parent_joint[to_size(link)]) {
        element(view(model_.joint(*joint).element), 1);
      }
      element(view(model_.link(link).element), 1);
    }
    for (const xml::View child : robot) {
      if (!written_[static_cast<std::size_t>(child.id())]) raw_or_element(child);
    }
    return out_ + "</robot>\n";
  }

 private:
  xml::View view(xml::ElementId id) const { return {model_.robot->document, id}; }

  void indent(int depth) { out_.append(static_cast<std::size_t>(depth) * 2, ' '); }

  /// The number of rows if no element of URDF has the attribute.
  std::size_t row_of(std::string_view name) const {
    return static_cast<std::size_t>(ranges::find(rows_, name, &urdf::AttributeSpec::name) -
                                    rows_.begin());
  }

  void open(xml::View element, int depth, std::string_view end) {
    std::vector<std::tuple<std::size_t, std::string_view, std::string>> attributes;
    for (const xml::Attribute& one : element.attributes()) {
      const std::size_t row = row_of(one.name());
      const bool is_known = row < rows_.size();
      const bool is_text = is_known && rows_[row]->form == urdf::Form::text;
      attributes.emplace_back(is_known && rows_[row]->is_last ? rows_.size() : row, one.name(),
                              is_text ? std::string(one.value()) : canonical_value(one.value()));
    }
    std::sort(attributes.begin(), attributes.end());
    indent(depth);
    out_ += "<" + std::string(element.name());
    for (const auto& [rank, name, value] : attributes) {
      out_ += " " + std::string(name) + "=\"" + escape_xml(value) + "\"";
    }
    out_ += end;
  }

  void element(xml::View element, int depth) {
    bool& is_written = written_[static_cast<std::size_t>(element.id())];
    if (is_written) return;
    is_written = true;
    std::vector<xml::View> children;
    for (const xml::View child : element) children.push_back(child);
    // Readers use the first child of a geometry as its shape, even if it is something else.
    // Children of an extension keep their order.
    const urdf::ElementSpec* spec = urdf::find_element_spec(element.name());
    if (spec != nullptr && element.name() != "geometry") {
      const auto rank = [&](xml::View child) {
        return ranges::find(spec->children, child.name(), &urdf::ChildSpec::name) -
               spec->children.begin();
      };
      std::stable_sort(children.begin(), children.end(),
                       [&](xml::View a, xml::View b) { return rank(a) < rank(b); });
    }
    const bool has_text = !trimmed(element.text()).empty();
    if (has_text) {  // an extension, in which spaces may have a meaning
      indent(depth);
      out_ += std::string(
                  text_.substr(element.span().begin, element.span().end - element.span().begin)) +
              "\n";
      return;
    }
    if (children.empty()) return open(element, depth, "/>\n");
    open(element, depth, ">\n");
    for (const xml::View child : children) this->element(child, depth + 1);
    indent(depth);
    out_ += "</" + std::string(element.name()) + ">\n";
  }

  /// Links and joints outside the tree are written like the others, extensions byte for byte.
  void raw_or_element(xml::View child) {
    if (child.name() == "link" || child.name() == "joint") return element(child, 1);
    indent(1);
    out_ += std::string(text_.substr(child.span().begin, child.span().end - child.span().begin));
    out_ += "\n";
  }

  const LinkedModel& model_;
  std::string_view text_;
  const std::vector<const urdf::AttributeSpec*> rows_ = attributes_in_order();
  std::string out_;
  std::map<std::size_t, bool> written_;  ///< by element
};

}  // namespace

std::string canonical_urdf(const LinkedModel& model, std::string_view text) {
  return CanonicalWriter(model, text).write();
}

}  // namespace smurf
