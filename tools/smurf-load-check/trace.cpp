// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/trace.hpp"

#include "base/numbers/numbers.hpp"
#include "render/printable.hpp"

namespace smurf::load_check {
namespace {

void add_numbers(std::string& line, const Pose& pose) {
  const Vector3& p = pose.position;
  const Quaternion& q = pose.orientation;
  for (const double value : {p[0], p[1], p[2], q.w, q.x, q.y, q.z}) {
    line.append(",").append(format_number(value));
  }
}

}  // namespace

/// Quotes a CSV field (RFC 4180). An apostrophe in front keeps a spreadsheet from treating a name
/// as a formula. Characters that the format cannot escape, such as control characters,
/// are as in messages.
std::string field_of(std::string_view name) {
  constexpr std::string_view kFormula = "=+-@";
  std::string text = render::escape(name);
  if (!text.empty() && kFormula.find(text.front()) != std::string::npos) text.insert(0, 1, '\'');
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

void append_row(std::string& rows, std::string_view file, Stage stage, double time,
                std::string_view link, const Pose& X_WL) {
  rows.append(file).append(",").append(to_string(stage)).append(",").append(format_number(time));
  rows.append(",").append(link);
  add_numbers(rows, X_WL);
  rows += "\n";
}

}  // namespace smurf::load_check
