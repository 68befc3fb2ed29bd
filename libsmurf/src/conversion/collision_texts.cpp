// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/collision_texts.hpp"

#include <algorithm>
#include <utility>

#include "base/text/edits.hpp"
#include "convert/xml_edits.hpp"

namespace smurf {

CollisionTexts::CollisionTexts(const LinkedModel& model, std::string_view text, bool makes_names)
    : model_(model), text_(text), source_(model.robot->document.source), makes_names_(makes_names) {
  for (const std::string_view name : model.collision_names.names()) names_.emplace(name);
}

const urdf::Collision& CollisionTexts::collision(CollisionPlace place) const {
  return model_.robot->links[place.link].collisions[place.collision];
}

std::vector<Edit> CollisionTexts::changes(const urdf::Collision& collision, const NewShape& shape,
                                          const NameOfFile& name_of) const {
  const xml::Document& document = model_.robot->document;
  const auto span_of = [&](xml::ElementId id) { return xml::View(document, id).span(); };
  const std::string element =
      shape.file.empty() ? shape.element : new_element("mesh", {{"filename", name_of(shape.file)}});
  std::vector<Edit> edits{{span_of(collision.geometry.shape_element), element}};
  // The new shape has the scale of the mesh in it, but not the pose of the collision.
  if (!shape.is_moved) return edits;
  const Pose X_LS = urdf::to_pose(collision.origin) * shape.X_CS;
  const std::string origin = new_element("origin", origin_attributes(X_LS));
  if (collision.origin.element != xml::kNoElement) {
    edits.push_back({span_of(collision.origin.element), origin});
  } else {
    const Span geometry = span_of(collision.geometry.element);
    edits.push_back(
        {{geometry.source, geometry.begin, geometry.begin}, origin + line_before(geometry)});
  }
  return edits;
}

/// The line end and the indentation before an element; "" if it does not begin its line.
std::string CollisionTexts::line_before(Span span) const {
  constexpr std::size_t kMost = 80;
  const std::size_t line = text_.substr(0, span.begin).rfind('\n');
  if (line == std::string_view::npos || span.begin - line > kMost) return {};
  const std::string_view indentation = text_.substr(line, span.begin - line);
  if (indentation.find_first_not_of(" \t\n") != std::string_view::npos) return {};
  const bool is_dos = line > 0 && text_[line - 1] == '\r';
  return (is_dos ? "\r" : "") + std::string(indentation);
}

/// The element with the changes, whose places are in the whole text.
std::string CollisionTexts::copy(const urdf::Collision& collision,
                                 std::vector<Edit> changes) const {
  for (Edit& change : changes) {
    change.span.begin -= collision.span.begin;
    change.span.end -= collision.span.begin;
  }
  return apply_edits(text_.substr(collision.span.begin, collision.span.end - collision.span.begin),
                     changes);
}

void CollisionTexts::replace(CollisionPlace place, const std::vector<NewShape>& shapes,
                             const NameOfFile& name_of) {
  const urdf::Collision& before = collision(place);
  const xml::View element(model_.robot->document, before.element);
  const Span blame = xml::View(model_.robot->document, before.geometry.shape_element).span();
  for (Edit& edit : changes(before, shapes.front(), name_of))
    edits_.push_back({std::move(edit), blame});
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    std::vector<Edit> edits = changes(before, shapes[i], name_of);
    const xml::Attribute* name = element.attribute("name");
    if (name != nullptr && makes_names_) {
      const std::string base = std::string(name->value()) + shapes[i].ending;
      std::string unique = base;
      for (std::size_t number = 2; !names_.insert(unique).second; ++number)
        unique = base + "_" + std::to_string(number);
      edits.push_back({name->value_span(), escape_xml(unique)});
    }
    const std::string line = line_before(before.span);
    appended_[place.link] += line + copy(before, std::move(edits));
    appended_for_.try_emplace(place.link, blame);
    origins_[place.link].push_back(place.collision);
  }
}

bool CollisionTexts::follow_contacts(const LinkedModel& changed) {
  const std::vector<ContactName> written = contact_names(model_);
  if (written.empty() || origins_.empty() || !contacts_.empty()) return false;
  const GazeboNames before = gazebo_names(model_);
  const GazeboNames after = gazebo_names(changed);
  for (const ContactName& name : written) {
    const auto place = find_collision(before, name.link, name.text);
    const auto origins = place ? origins_.find(place->link) : origins_.end();
    if (origins == origins_.end()) continue;
    const std::size_t first = model_.robot->links[place->link].collisions.size();
    const Span span = name.element.span();
    std::string more;
    for (std::size_t i = 0; i < origins->second.size(); ++i) {
      if (origins->second[i] != place->collision) continue;
      more += "<collision>" + escape_xml(after.collisions[place->link][first + i]) + "</collision>";
    }
    if (!more.empty()) contacts_.push_back({{{span.source, span.end, span.end}, more}, span});
  }
  return !contacts_.empty();
}

std::string CollisionTexts::text() {
  std::vector<Replacement> all = edits_;
  all.insert(all.end(), contacts_.begin(), contacts_.end());
  for (const auto& [link, text] : appended_) {
    std::uint32_t end = 0;
    for (const urdf::Collision& each : model_.robot->links[link].collisions)
      end = std::max(end, each.span.end);
    const Span blame = appended_for_.at(link);
    all.push_back({{{blame.source, end, end}, text}, blame});
  }
  std::stable_sort(all.begin(), all.end(), [](const Replacement& a, const Replacement& b) {
    return a.edit.span.begin < b.edit.span.begin;
  });
  std::string changed;
  pieces_.clear();
  std::uint32_t at = 0;
  const auto add = [&](std::string_view text, Piece piece) {
    piece.begin = static_cast<std::uint32_t>(changed.size());
    changed += text;
    piece.end = static_cast<std::uint32_t>(changed.size());
    if (piece.end > piece.begin) pieces_.push_back(piece);
  };
  for (const Replacement& one : all) {
    add(text_.substr(at, one.edit.span.begin - at), {.original = at, .is_copy = true, .blame = {}});
    add(one.edit.text, {.blame = one.blame});
    at = one.edit.span.end;
  }
  add(text_.substr(at), {.original = at, .is_copy = true, .blame = {}});
  return changed;
}

const CollisionTexts::Piece& CollisionTexts::piece_at(std::uint32_t offset) const {
  const auto after =
      std::upper_bound(pieces_.begin(), pieces_.end(), offset,
                       [](std::uint32_t at, const Piece& piece) { return at < piece.begin; });
  return after == pieces_.begin() ? pieces_.front() : *std::prev(after);
}

Span CollisionTexts::original(Span changed) const {
  const Piece& first = piece_at(changed.begin);
  if (!first.is_copy) return first.blame;
  const std::uint32_t begin = first.original + (changed.begin - first.begin);
  const Piece& last = piece_at(changed.empty() ? changed.end : changed.end - 1);
  const std::uint32_t end =
      last.is_copy ? last.original + (changed.end - last.begin) : last.blame.end;
  return {source_, begin, std::max(begin, end)};
}

}  // namespace smurf
