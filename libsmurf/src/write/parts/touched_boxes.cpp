// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/touched_boxes.hpp"

#include <algorithm>

#include "lint/geometry_queries.hpp"

namespace smurf {
namespace {

/// Contacts are within the margin of the shapes, which penetrate each other.
constexpr double kMargin = 0.01;  // m

Box with_margin(Box box) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] -= kMargin;
    box.high[i] += kMargin;
  }
  return box;
}

void add(TouchedBoxes& boxes, std::size_t link, const Box& box) {
  const auto [known, is_new] = boxes.try_emplace(link, box);
  if (!is_new) known->second = united(known->second, box);
}

}  // namespace

void CollisionBoxes::read() {
  if (is_read_) return;
  is_read_ = true;
  const auto& links = model_.robot->links;
  of_links_.resize(links.size());
  const auto add_to = [](Boxes& boxes, std::size_t link, const std::optional<Box>& box) {
    if (box) {
      add(boxes.of_links, link, *box);
    } else {
      boxes.unknown.insert(link);
    }
  };
  for (std::size_t link = 0; link < links.size(); ++link) {
    for (const urdf::Collision& collision : links[link].collisions) {
      std::optional<Box> box = bounding_box(model_, collision.geometry);
      if (box) box = with_margin(moved(*box, urdf::to_pose(collision.origin)));
      add_to(of_links_[link], link, box);
      if (collision.name) add_to(by_name_[*collision.name], link, box);
    }
  }
}

TouchedBoxes CollisionBoxes::of(std::size_t link, std::string_view collision) {
  read();
  const auto named = by_name_.find(collision);
  const Boxes* boxes = named != by_name_.end() ? &named->second : nullptr;
  if (boxes != nullptr && boxes->unknown.contains(link)) return {};
  if (boxes == nullptr || !boxes->of_links.contains(link)) boxes = &of_links_[link];
  const auto found = boxes->of_links.find(link);
  if (found == boxes->of_links.end() || boxes->unknown.contains(link)) return {};
  return {*found};
}

const CollisionBoxes::Boxes* CollisionBoxes::find(std::string_view name) const {
  if (const auto named = by_name_.find(name); named != by_name_.end()) return &named->second;
  const auto link = model_.link_names.find(name);
  return link ? &of_links_[*link] : nullptr;
}

TouchedBoxes CollisionBoxes::of(std::vector<std::string> names, std::size_t most) {
  read();
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  // Checks all boxes before copying any, because many sensors may name shapes of many links.
  std::size_t count = 0;
  for (const std::string& name : names) {
    const Boxes* boxes = find(name);
    if (boxes == nullptr || !boxes->unknown.empty() || boxes->of_links.empty()) return {};
    count += boxes->of_links.size();
  }
  TouchedBoxes all;
  if (count > std::max(most, names.size())) return all;
  for (const std::string& name : names) {
    for (const auto& [link, box] : find(name)->of_links) add(all, link, box);
  }
  return all;
}

}  // namespace smurf
