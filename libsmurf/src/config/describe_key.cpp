// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "config/key_help.hpp"

namespace smurf {

std::vector<std::string> describe(const KeyHelp& help) {
  std::vector<std::string> lines{quoted(help.name) + " (" + help.owner + ")" +
                                 (help.required ? ", required" : "")};
  if (!help.doc.empty()) lines.emplace_back(help.doc);
  std::string value = "Value: " + std::string(help.value);
  if (!help.unit.empty()) value += ", in " + std::string(help.unit);
  lines.push_back(value);
  if (!help.choices.empty() && help.form == ValueForm::scalar) {
    lines.push_back("One of " + listed(all_quoted(help.choices)));
  }
  if (!help.fallback.empty()) lines.push_back("Absent, it is " + quoted(help.fallback));
  if (!help.read_by.empty()) lines.push_back("Read by " + std::string(help.read_by));
  return lines;
}

}  // namespace smurf
