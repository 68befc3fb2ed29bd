// SPDX-License-Identifier: BSD-3-Clause
#include "ast/drawing_reader.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/findings/rules.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

/// The pieces between separators, without the blanks around them.
std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> pieces;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    pieces.push_back(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return pieces;
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> pieces = split(text, kBlanks);
  std::erase_if(pieces, [](std::string_view piece) { return piece.empty(); });
  return pieces;
}

std::optional<std::vector<double>> numbers(const std::vector<std::string_view>& pieces) {
  std::vector<double> values;
  for (const std::string_view piece : pieces) {
    const std::optional<double> value = parse_number(piece);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

/// A rigid motion in the page.
struct Motion {
  double cosine = 1, sine = 0, x = 0, y = 0;

  Motion operator*(const Motion& inner) const {
    return {cosine * inner.cosine - sine * inner.sine, sine * inner.cosine + cosine * inner.sine,
            x + cosine * inner.x - sine * inner.y, y + sine * inner.x + cosine * inner.y};
  }
};

/// The parts of a group that MARS reads: the first elements of these names anywhere in it.
struct Group {
  xml::View element;
  std::optional<std::size_t> outer;  ///< the group around it
  xml::View title, description, path;
  bool has_groups = false;
  std::optional<Motion> motion;  ///< combined with those of outer groups; none if unreadable
};

class DrawingReader {
 public:
  DrawingReader(const xml::Document& document, DiagnosticSink& sink)
      : document_(document), sink_(sink) {}

  std::vector<DrawnEntity> run() {
    collect();
    if (groups_.empty()) return {};
    const std::optional<double> width = read_width();
    std::vector<DrawnEntity> entities;
    double z = 0;
    for (Group& group : groups_) {
      group.motion = read_motion(group);
      if (group.has_groups) report_nesting(group);
      if (group.has_groups && !group.title) continue;  // its contents are the entities
      if (auto entity = read(group, width, z)) entities.push_back(std::move(*entity));
    }
    return entities;
  }

 private:
  /// Elements come in document order, so that an element's parent is known before it.
  void collect() {
    constexpr auto kNone = static_cast<std::size_t>(-1);
    std::vector<std::size_t> group_of(document_.elements.size(), kNone);
    for (std::size_t i = 0; i < document_.elements.size(); ++i) {
      const xml::View element(document_, xml::ElementId{static_cast<std::uint32_t>(i)});
      const xml::View parent = element.parent();
      const std::size_t around = parent ? group_of[static_cast<std::size_t>(parent.id())] : kNone;
      group_of[i] = around;
      if (element.name() == "g" && parent) {
        group_of[i] = groups_.size();
        Group& group = groups_.emplace_back();
        group.element = element;
        if (around == kNone) continue;
        group.outer = around;
        groups_[around].has_groups = true;
      } else if (around != kNone) {
        take(element, groups_[around]);
      }
    }
  }

  static void take(xml::View element, Group& group) {
    const auto keep_first = [&](std::string_view name, xml::View& place) {
      if (element.name() == name && !place) place = element;
    };
    keep_first("title", group.title);
    keep_first("desc", group.description);
    keep_first("path", group.path);
  }

  std::optional<double> read_width() {
    const xml::View root = document_.view();
    const xml::Attribute* width = root.attribute("width");
    if (width == nullptr) {
      sink_.report(rules::sml5042_drawing_width, root.name_span(),
                   "the drawing has no `width`, from which MARS computes y");
      return std::nullopt;
    }
    const std::optional<double> value = parse_number(trimmed(width->value()));
    if (value) return value;
    Diagnostic& diagnostic = sink_.report(rules::sml5042_drawing_width, width->value_span(),
                                          "the `width` is not a plain number, so MARS reads 0");
    const std::size_t end = width->value().find_first_not_of("0123456789.");
    if (end != std::string_view::npos && parse_number(width->value().substr(0, end))) {
      diagnostic.help("write it without a unit: " + std::string(width->value().substr(0, end)));
    }
    return std::nullopt;
  }

  void refuse_transform(const xml::Attribute& transform, const std::string& why) {
    sink_.report(rules::sml5041_drawing_transform, transform.value_span(), why)
        .help("write `matrix(a,b,c,d,e,f)` or `translate(x,y)`");
  }

  std::optional<Motion> read_motion(const Group& group) {
    const std::optional<Motion> own = own_motion(group);
    if (!group.outer || !own) return own;
    const std::optional<Motion>& around = groups_[*group.outer].motion;
    return around ? std::optional(*around * *own) : std::nullopt;
  }

  std::optional<Motion> own_motion(const Group& group) {
    const xml::Attribute* transform = group.element.attribute("transform");
    if (transform == nullptr || trimmed(transform->value()).empty()) return Motion{};
    const std::string_view text = trimmed(transform->value());
    const std::size_t open = text.find('(');
    const std::size_t close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
      refuse_transform(*transform, "this is not a transform");
      return std::nullopt;
    }
    const std::string name(trimmed(text.substr(0, open)));
    const std::string_view inside = text.substr(open + 1, close - open - 1);
    const bool is_matrix = name == "matrix";
    if (!is_matrix && name != "translate") {
      refuse_transform(*transform, "MARS does not know `" + name + "` and reads its numbers as " +
                                       "a translation, or ignores them");
      return std::nullopt;
    }
    if (close + 1 != text.size()) {
      refuse_transform(*transform, "MARS reads the first transform only");
      return std::nullopt;
    }
    const std::size_t count = is_matrix ? 6 : 2;
    const auto values = numbers(split(inside, ","));
    if (!values || values->size() != count) {
      const auto by_blanks = numbers(words(inside));
      const bool has_blanks = by_blanks && by_blanks->size() == count;
      refuse_transform(*transform,
                       has_blanks
                           ? "MARS expects commas between the numbers, and finds no transform here"
                           : "`" + name + "` must have " + std::to_string(count) +
                                 " numbers with commas between them");
      return std::nullopt;
    }
    if (!is_matrix) return Motion{1, 0, (*values)[0], (*values)[1]};
    return matrix_motion(*transform, *values);
  }

  /// MARS computes the angle from the first column and ignores the rest.
  std::optional<Motion> matrix_motion(const xml::Attribute& transform,
                                      const std::vector<double>& m) {
    const double length = hypotenuse(m[0], m[1]);
    if (!(length > 1e-9)) {
      refuse_transform(transform, "the matrix makes everything flat, so it has no angle");
      return std::nullopt;
    }
    const double cosine = m[0] / length;
    const double sine = m[1] / length;
    constexpr double kSame = 1e-3;  // drawing programs write six digits or more
    const auto is_near = [](double a, double b) { return std::fabs(a - b) <= kSame; };
    const bool is_rigid = is_near(m[0], cosine) && is_near(m[1], sine) && is_near(m[2], -sine) &&
                          is_near(m[3], cosine);
    if (!is_rigid) {
      Diagnostic& diagnostic =
          sink_.report(rules::sml5041_drawing_transform, transform.value_span(),
                       "the matrix stretches or mirrors, but MARS uses only its angle and place");
      diagnostic.severity = Severity::warning;
    }
    return Motion{cosine, sine, m[4], m[5]};
  }

  void report_nesting(const Group& group) {
    const std::string what = group.title ? "this entity contains other groups"
                                         : "this group is not an entity, but MARS loads it as a "
                                           "copy of the first group in it";
    const bool moves = group.element.attribute("transform") != nullptr;
    Diagnostic& diagnostic = sink_.report(
        rules::sml5043_nested_drawing_group, group.element.name_span(),
        what + (moves ? "; MARS does not apply its transform to the groups inside it" : ""));
    diagnostic.help("ungroup the inner groups");
  }

  void refuse_group(Span place, const std::string& why) {
    sink_.report(rules::sml5040_incomplete_drawn_entity, place, why);
  }

  std::optional<DrawnEntity> read(const Group& group, std::optional<double> width, double& z) {
    DrawnEntity entity;
    entity.group = group.element.name_span();
    const std::string_view title = group.title ? trimmed(group.title.text()) : std::string_view();
    if (title.empty()) {
      refuse_group(group.title ? group.title.name_span() : entity.group,
                   "this group has no title that names the file of its entity");
      return std::nullopt;
    }
    entity.file = {std::string(title), inner(group.title.text_span(), group.title, title)};
    entity.height = entity.group;
    const bool has_height = read_height(group, entity, z);
    const auto local = read_origin(group);
    if (!has_height || !local || !group.motion || !width) return std::nullopt;
    const Motion placed = *group.motion * Motion{1, 0, (*local)[0], (*local)[1]};
    entity.x = placed.x;
    entity.y = *width - placed.y;
    entity.yaw = -arc_tangent(placed.sine, placed.cosine) * 180 / std::numbers::pi;
    const xml::Attribute* transform = group.element.attribute("transform");
    const bool is_moved = transform != nullptr && !transform->value_span().empty();
    entity.place = is_moved ? transform->value_span() : group.path.attribute("d")->value_span();
    return entity;
  }

  /// The bytes of a text without the spaces around it, if the text contains no XML references.
  static Span inner(Span span, xml::View element, std::string_view text) {
    const std::string_view whole = element.text();
    if (span.end - span.begin != whole.size()) return span;
    const auto skipped = static_cast<std::uint32_t>(text.data() - whole.data());
    return {span.source, span.begin + skipped,
            span.begin + skipped + static_cast<std::uint32_t>(text.size())};
  }

  /// Without `origin_z:`, the height of the previous group applies.
  bool read_height(const Group& group, DrawnEntity& entity, double& z) {
    const std::string_view text =
        group.description ? trimmed(group.description.text()) : std::string_view();
    if (text.empty()) {
      refuse_group(
          group.description ? group.description.name_span() : entity.group,
          "this group has no `<desc>origin_z: NUMBER</desc>`, without which MARS stops with an "
          "uncaught exception");
      return false;
    }
    const Span place = inner(group.description.text_span(), group.description, text);
    const std::vector<std::string_view> parts = words(text);
    if (parts.front() != "origin_z:") {
      Diagnostic& diagnostic = sink_.report(
          rules::sml5040_incomplete_drawn_entity, place,
          "the description does not begin with `origin_z:`, so the entity is as high as the one "
          "before it");
      diagnostic.severity = Severity::warning;
      entity.z = z;
      return true;
    }
    const std::optional<double> value = parts.size() > 1 ? parse_number(parts[1]) : std::nullopt;
    if (!value) {
      refuse_group(place, "`origin_z:` is not followed by a number");
      return false;
    }
    entity.z = z = *value;
    entity.height = place;
    return true;
  }

  /// The point at which the first path begins is the origin of the entity.
  std::optional<std::vector<double>> read_origin(const Group& group) {
    if (!group.path) {
      refuse_group(group.element.name_span(),
                   "this group has no path, whose first point is the origin of its entity");
      return std::nullopt;
    }
    const xml::Attribute* data = group.path.attribute("d");
    const std::vector<std::string_view> parts =
        data != nullptr ? words(data->value()) : std::vector<std::string_view>();
    const bool begins = parts.size() > 1 && (parts[0] == "m" || parts[0] == "M");
    auto point = begins ? numbers(split(parts[1], ",")) : std::nullopt;
    if (point && point->size() == 2) return point;
    refuse_group(
        data != nullptr ? data->value_span() : group.path.name_span(),
        "the path does not begin with `m X,Y`, from which MARS reads the origin of the entity");
    return std::nullopt;
  }

  const xml::Document& document_;
  DiagnosticSink& sink_;
  std::vector<Group> groups_;
};

}  // namespace

std::vector<DrawnEntity> read_drawing(const xml::Document& document, DiagnosticSink& sink) {
  return DrawingReader(document, sink).run();
}

}  // namespace smurf
