// SPDX-License-Identifier: BSD-3-Clause
// Annotations that were made with a robot, as the files of a new model.
#include "convert/import.hpp"

namespace smurf::import {
namespace {

NewValue value_of(std::string key, yaml::View view) {
  if (view.is_mapping()) {
    std::vector<NewValue> members;
    for (const yaml::View one : view) members.push_back(value_of(std::string(one.key()), one));
    return mapping_value(std::move(key), std::move(members));
  }
  if (view.is_sequence()) {
    std::vector<NewValue> entries;
    for (const yaml::View one : view) entries.push_back(value_of({}, one));
    return list_value(std::move(key), std::move(entries));
  }
  if (const auto boolean = view.boolean()) return boolean_value(std::move(key), *boolean);
  const auto number = view.number();
  return number ? number_value(std::move(key), *number)
                : text_value(std::move(key), std::string(view.text()));
}

}  // namespace

std::vector<NewFile> made_sections(const LinkedModel& model) {
  std::vector<NewFile> files;
  for (const ModelFile& file : model.files) {
    if (file.kind != ModelFile::Kind::annotation || !file.document) continue;
    for (const yaml::View section : file.document->view()) {
      NewFile& made = files.emplace_back();
      made.suffix = section.key();
      made.section = value_of(made.suffix, section);
    }
  }
  return files;
}

}  // namespace smurf::import
