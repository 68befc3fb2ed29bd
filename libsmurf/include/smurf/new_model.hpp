// SPDX-License-Identifier: BSD-3-Clause
// A SMURF model that is to be written: values with the comments a person would have left.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace smurf {

/// A value of a YAML file. The order of children is the order in the file.
struct NewValue {
  enum class Kind : std::uint8_t { text, number, boolean, list, mapping };

  Kind kind = Kind::mapping;
  std::string key;    ///< in a mapping
  std::string text;   ///< kind text
  double number = 0;  ///< kind number; finite
  bool boolean = false;
  std::vector<NewValue> children;
  std::string comment;          ///< above a list entry or mapping, behind a scalar; may be empty
  bool is_on_one_line = false;  ///< {x: 0, y: 0, z: 1} on one line
};

NewValue text_value(std::string key, std::string text, std::string comment = {});
NewValue number_value(std::string key, double number, std::string comment = {});
NewValue boolean_value(std::string key, bool value);
NewValue mapping_value(std::string key, std::vector<NewValue> members);
NewValue list_value(std::string key, std::vector<NewValue> entries);
/// A mapping of numbers on one line: "position", {{"x", 0}, {"y", 0}, {"z", 1}}.
NewValue numbers_value(std::string key, const std::vector<std::pair<std::string, double>>& numbers);

/// One annotation file; it holds one section.
struct NewFile {
  std::string suffix;   ///< of its name: "motors" in arm_motors.yml
  std::string comment;  ///< at the top; several lines are several comments
  NewValue section;
};

/// All that a folder of a SMURF model is made from. Paths start from the folder of the output.
struct NewModel {
  std::string main_path;  ///< "smurf/arm.smurf"; annotation files stand beside it
  std::string modelname;
  std::string urdf_entry;  ///< in `files`, from the folder of the main file
  std::string urdf_path;   ///< "urdf/arm.urdf"; empty when the URDF stays where it is
  std::string urdf;        ///< its text
  std::string source;      ///< what it was made from, for a comment
  std::vector<NewFile> files;
};

/// A file and its content.
struct TextFile {
  std::string path;
  std::string text;
};

}  // namespace smurf
