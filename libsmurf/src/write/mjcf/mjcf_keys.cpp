// SPDX-License-Identifier: BSD-3-Clause
#include "write/mjcf/mjcf_keys.hpp"

#include <utility>

#include "base/numbers/numbers.hpp"
#include "base/text/unique_names.hpp"

namespace smurf {

bool MjcfKeys::has_room_for(std::size_t sets) const {
  constexpr std::size_t kMostNumbers = 1'000'000;
  return sets * (positions_.size() + commands_.size()) <= kMostNumbers;
}

void MjcfKeys::write(XmlText& xml, const std::vector<Posed>& sets,
                     const PositionOf& position_of) const {
  if (positions_.empty()) return;
  UniqueNames names;
  const auto add = [&](const std::string& name, const Posed* set) {
    std::vector<XmlText::Attribute> key{{"name", names.add(name)},
                                        {"qpos", text_of(positions_, set, position_of)}};
    if (!commands_.empty()) key.emplace_back("ctrl", text_of(commands_, set, position_of));
    xml.empty("key", key);
  };
  xml.open("keyframe");
  add("initial", nullptr);
  for (const Posed& set : sets) add(set.name, &set);
  xml.close();
}

std::string MjcfKeys::text_of(const std::vector<Number>& numbers, const Posed* set,
                              const PositionOf& position_of) {
  std::string text;
  for (const Number& number : numbers) {
    if (!text.empty()) text += ' ';
    const bool is_posed =
        set != nullptr && number.joint != nullptr && number.instance == set->instance;
    if (!number.free.empty()) {
      text += number.free;
    } else {
      text += format_number(is_posed ? position_of(number.instance, *number.joint, set->positions)
                                     : number.start);
    }
  }
  return text;
}

}  // namespace smurf
