// SPDX-License-Identifier: BSD-3-Clause
#include "write/touched_boxes.hpp"

#include "lint/geometry_queries.hpp"

namespace smurf {
namespace {

/// Contacts lie within the margin of the shapes, which sink into each other.
constexpr double kMargin = 0.01;  // m

Box with_margin(Box box) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] -= kMargin;
    box.high[i] += kMargin;
  }
  return box;
}

/// False when there is no box.
bool add(TouchedBoxes& boxes, std::size_t link, const std::optional<Box>& box) {
  if (!box) return false;
  const auto [known, is_new] = boxes.try_emplace(link, *box);
  if (!is_new) known->second = united(known->second, *box);
  return true;
}

}  // namespace

void CollisionBoxes::read() {
  if (is_read_) return;
  is_read_ = true;
  const auto& links = model_.robot->links;
  of_links_.resize(links.size());
  for (std::size_t link = 0; link < links.size(); ++link) {
    TouchedBoxes all;
    bool is_known = true;
    for (const urdf::Collision& collision : links[link].collisions) {
      std::optional<Box> box = bounding_box(model_, collision.geometry);
      if (box) box = with_margin(moved(*box, urdf::to_pose(collision.origin)));
      is_known = add(all, link, box) && is_known;
      if (collision.name) by_name_.emplace(*collision.name, OfLink(link, box));
    }
    if (is_known && !all.empty()) of_links_[link] = all.begin()->second;
  }
}

TouchedBoxes CollisionBoxes::of(std::size_t link, std::string_view collision) {
  read();
  TouchedBoxes boxes;
  const auto [first, last] = by_name_.equal_range(collision);
  for (auto named = first; named != last; ++named) {
    const auto& [of_link, box] = named->second;
    if (of_link == link && !add(boxes, link, box)) return {};
  }
  if (boxes.empty()) add(boxes, link, of_links_[link]);
  return boxes;
}

TouchedBoxes CollisionBoxes::of(const std::vector<std::string>& names) {
  read();
  TouchedBoxes boxes;
  for (const std::string& name : names) {
    const auto [first, last] = by_name_.equal_range(name);
    for (auto named = first; named != last; ++named) {
      if (!add(boxes, named->second.first, named->second.second)) return {};
    }
    if (first != last) continue;
    const auto link = model_.link_names.find(name);
    if (!link || !add(boxes, *link, of_links_[*link])) return {};
  }
  return boxes;
}

}  // namespace smurf
