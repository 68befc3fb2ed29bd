// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/show_masses.hpp"

#include <algorithm>
#include <array>

#include "base/numbers/numbers.hpp"
#include "lint/masses.hpp"
#include "render/printable.hpp"
#include "smurf-lint/one_model.hpp"

namespace smurf::tools {
namespace {

using Row = std::array<std::string, 6>;
constexpr std::size_t kNames = 0;
constexpr std::size_t kVerdicts = 5;

std::string verdict_of(const LinkMass& row) {
  std::string verdict;
  for (const Rule* rule : row.reported) {
    verdict += (verdict.empty() ? "" : "; ") + std::string(rule->id) + " ";
    verdict += rule->name;
  }
  if (!verdict.empty()) return verdict;
  return !row.mass ? "no mass" : row.density && row.gyration ? "fits" : "not compared";
}

/// `write` makes text of a number.
template <class Write>
Row cells_of(const LinkMass& row, const Write& write) {
  const auto cell = [&](const std::optional<double>& value) {
    return value ? write(*value) : std::string();
  };
  return {render::escape(row.link), cell(row.mass),     cell(row.volume),
          cell(row.density),        cell(row.gyration), verdict_of(row)};
}

/// Quotes a cell that contains a comma, a quote or the end of a line.
std::string quoted_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string table_of(const std::vector<LinkMass>& masses) {
  std::vector<Row> rows = {{"link", "mass kg", "volume m3", "kg/m3", "gyration m", "verdict"}};
  double total = 0;
  bool has_boxes = false;
  for (const LinkMass& one : masses) {
    rows.push_back(cells_of(one, [](double value) { return format_rounded(value, 3); }));
    if (one.is_box) rows.back()[2].insert(0, "~");
    has_boxes = has_boxes || one.is_box;
    total += one.mass.value_or(0);
  }
  rows.push_back({"total", format_rounded(total, 4), "", "", "", ""});
  std::array<std::size_t, std::tuple_size_v<Row>> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string gap(widths[i] - row[i].size(), ' ');
      line += (i == 0 ? "" : "  ") + (i == kNames || i == kVerdicts ? row[i] + gap : gap + row[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  if (has_boxes) text += "~ the box around the shapes, because a mesh is open\n";
  return text;
}

std::string csv_of(const std::vector<LinkMass>& masses) {
  std::string text = "link,mass_kg,volume_m3,volume_of,density_kg_m3,gyration_m,verdict\n";
  for (const LinkMass& one : masses) {
    const Row cells = cells_of(one, [](double value) { return format_number(value); });
    text += quoted_cell(cells[0]) + "," + cells[1] + "," + cells[2] + "," +
            (!one.volume  ? ""
             : one.is_box ? "box"
                          : "shapes") +
            "," + cells[3] + "," + cells[4] + "," + quoted_cell(cells[5]) + "\n";
  }
  return text;
}

}  // namespace

ExitCode show_masses(const LintOptions& options) {
  return show_model(options, options.masses, [&](const LinkedModel& model) {
    const std::vector<LinkMass> masses = masses_of(model);
    return options.csv ? csv_of(masses) : table_of(masses);
  });
}

}  // namespace smurf::tools
