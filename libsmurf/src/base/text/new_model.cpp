// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/new_model.hpp"

#include <utility>

namespace smurf {

NewValue text_value(std::string key, std::string text, std::string comment) {
  NewValue value;
  value.kind = NewValue::Kind::text;
  value.key = std::move(key);
  value.text = std::move(text);
  value.comment = std::move(comment);
  return value;
}

NewValue number_value(std::string key, double number, std::string comment) {
  NewValue value;
  value.kind = NewValue::Kind::number;
  value.key = std::move(key);
  value.number = number;
  value.comment = std::move(comment);
  return value;
}

NewValue boolean_value(std::string key, bool boolean) {
  NewValue value;
  value.kind = NewValue::Kind::boolean;
  value.key = std::move(key);
  value.boolean = boolean;
  return value;
}

NewValue mapping_value(std::string key, std::vector<NewValue> members) {
  NewValue value;
  value.key = std::move(key);
  value.children = std::move(members);
  return value;
}

NewValue list_value(std::string key, std::vector<NewValue> entries) {
  NewValue value = mapping_value(std::move(key), std::move(entries));
  value.kind = NewValue::Kind::list;
  return value;
}

NewValue numbers_value(std::string key,
                       const std::vector<std::pair<std::string, double>>& numbers) {
  NewValue value = mapping_value(std::move(key), {});
  for (const auto& [name, number] : numbers) value.children.push_back(number_value(name, number));
  value.is_on_one_line = true;
  return value;
}

}  // namespace smurf
