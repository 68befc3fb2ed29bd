// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "smurf/write.hpp"
#include "write/text/yaml_text.hpp"

namespace smurf {
namespace {

std::string main_text(const NewModel& model) {
  const std::string stem(path::stem(model.main_path));
  NewValue files = list_value("files", {});
  files.children.push_back(text_value({}, model.urdf_entry));
  for (const NewFile& file : model.files) {
    files.children.push_back(text_value({}, stem + "_" + file.suffix + ".yml"));
  }
  return yaml_comment("made by urdf2smurf from " + model.source) + "\n" +
         yaml_text(text_value("modelname", model.modelname)) + yaml_text(files);
}

}  // namespace

std::vector<TextFile> write_smurf(const NewModel& model) {
  const std::string stem = path::join(path::parent(model.main_path), path::stem(model.main_path));
  std::vector<TextFile> files;
  if (!model.urdf_path.empty()) files.push_back({model.urdf_path, model.urdf});
  if (!model.srdf.empty()) {
    const std::string_view folder = path::parent(model.urdf_path);
    const std::string name = std::string(path::stem(model.urdf_path)) + ".srdf";
    files.push_back({path::join(folder, name), model.srdf});
  }
  for (const NewFile& file : model.files) {
    files.push_back({stem + "_" + file.suffix + ".yml",
                     yaml_comment(file.comment) + "\n" + yaml_text(file.section)});
  }
  // The main file is last, so a program that watches the folder finds a complete model as soon as
  // it exists.
  files.push_back({model.main_path, main_text(model)});
  return files;
}

}  // namespace smurf
