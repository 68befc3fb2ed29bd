// SPDX-License-Identifier: BSD-3-Clause
// A SMURF model to be written: values, with comments for people.
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

/// One annotation file with one section.
struct NewFile {
  std::string suffix;   ///< part of the file name: "motors" in arm_motors.yml
  std::string comment;  ///< at the top; each line becomes a comment line
  NewValue section;
};

/// The contents of the folder of a SMURF model. Paths start from the folder of the output.
struct NewModel {
  std::string main_path;  ///< "smurf/arm.smurf"; annotation files are written beside it
  std::string modelname;
  std::string urdf_entry;  ///< in `files`, from the folder of the main file
  std::string urdf_path;   ///< "urdf/arm.urdf"; empty if the URDF is not copied
  std::string urdf;        ///< its text
  std::string srdf;        ///< beside the URDF; "": none, since the robot excludes no contacts
  std::string source;      ///< name of the source, for a comment
  std::vector<NewFile> files;
};

/// A file and its content.
struct TextFile {
  std::string path;
  std::string text;
};

}  // namespace smurf
