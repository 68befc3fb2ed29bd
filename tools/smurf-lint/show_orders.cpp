// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/show_orders.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <string_view>

#include "base/text/lists.hpp"
#include "render/printable.hpp"
#include "smurf-lint/one_model.hpp"
#include "smurf/joint_order.hpp"
#include "smurf/write.hpp"

namespace smurf::tools {
namespace {

using Names = std::vector<std::string>;

const Names& names_of(const JointOrder& order, bool is_of_bodies) {
  return is_of_bodies ? order.bodies : order.joints;
}

/// One row per name, those of the first order first; one column per order.
std::string table_of(std::span<const JointOrder> orders, bool is_of_bodies) {
  Names names;
  std::set<std::string_view> seen;
  std::vector<Names> columns{{is_of_bodies ? "body" : "joint"}};
  for (const JointOrder& order : orders) {
    for (const std::string& name : names_of(order, is_of_bodies)) {
      if (seen.insert(name).second) names.push_back(name);
    }
  }
  for (const std::string& name : names) columns[0].push_back(render::escape(name));
  for (const JointOrder& order : orders) {
    Names& column = columns.emplace_back(Names{std::string(order.reader->name)});
    for (const auto& place : permutation(names_of(order, is_of_bodies), names)) {
      column.push_back(place ? std::to_string(*place) : "-");
    }
  }
  std::vector<std::size_t> widths;
  for (const Names& column : columns) {
    std::size_t width = 0;
    for (const std::string& cell : column) width = std::max(width, cell.size());
    widths.push_back(width);
  }
  std::string text;
  for (std::size_t row = 0; row <= names.size(); ++row) {
    text += columns[0][row] + std::string(widths[0] - columns[0][row].size(), ' ');
    for (std::size_t i = 1; i < columns.size(); ++i) {
      text += "  " + std::string(widths[i] - columns[i][row].size(), ' ') + columns[i][row];
    }
    text += "\n";
  }
  return text;
}

/// "mujoco = pinocchio[[1, 0]]"; with the name of a joint that is missing, if there is one.
std::string permutation_line(const JointOrder& from, const JointOrder& to) {
  std::string text = std::string(to.reader->name) + " = " + std::string(from.reader->name) + "[[";
  const auto places = permutation(from.joints, to.joints);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) {
      return std::string(to.reader->name) + " has '" + render::escape(to.joints[i]) + "', which " +
             std::string(from.reader->name) + " does not have\n";
    }
    text += (i == 0 ? "" : ", ") + std::to_string(*places[i]);
  }
  return text + "]]\n";
}

std::string text_of(std::span<const JointOrder> orders) {
  std::string text;
  std::vector<JointOrder> known;
  for (const JointOrder& order : orders) {
    text += std::string(order.reader->name) + ": " + std::string(order.walk) +
            (order.is_known ? " (" : "") + std::string(order.basis) + (order.is_known ? ")" : "") +
            "\n";
    if (order.is_known) known.push_back(order);
  }
  if (known.empty()) return text;
  text += "\n" + table_of(known, false);
  for (std::size_t i = 1; i < known.size(); ++i) {
    text += (i == 1 ? "\n" : "") + permutation_line(known[i], known[0]) +
            permutation_line(known[0], known[i]);
  }
  return text + "\n" + table_of(known, true);
}

/// Targets, or `all` for those whose orders are known.
Setter append_orders(std::vector<const Reader*>& readers) {
  return [&readers, append = append_targets(readers)](std::string_view value) {
    if (value != "all") return append(value);
    readers = readers_with_joint_order();
    return std::optional<std::string>{};
  };
}

std::vector<std::string_view> order_names() {
  std::vector<std::string_view> names{"all"};
  for (const Reader* reader : readers_with_joint_order()) names.push_back(reader->name);
  return names;
}

std::string_view order_help() {
  static const std::string help = [] {
    return "Show the order of joints and bodies that these readers build of the robot PATH, and the "
           "permutations between the first and the others; check nothing else. Known: " +
           listed(order_names()) + ". --format json writes all permutations.";
  }();
  return help;
}

/// An error message if the options do not fit; "" if they do.
std::string_view find_mistake(const LintOptions& options) {
  const std::vector<ReportRequest>& reports = options.reports;
  const auto is_usable = [](const ReportRequest& one) {
    return one.file.empty() && (one.format->name == "json" || one.format->name == "full");
  };
  if (reports.size() > 1 || !std::all_of(reports.begin(), reports.end(), is_usable)) {
    return "--joint-order writes text, or JSON with --format json; -o names the file";
  }
  if (options.paths.size() == 1) return "";
  return "--joint-order needs one PATH: smurf-lint --joint-order mujoco,pinocchio robot.urdf";
}

}  // namespace

Option joint_order_option(LintOptions& options) {
  return {.group = "Input",
          .name = "joint-order",
          .metavar = "LIST",
          .help = order_help(),
          .suggestions = order_names,
          .set = append_orders(options.joint_orders)};
}

ExitCode show_joint_orders(const LintOptions& options) {
  if (const std::string_view mistake = find_mistake(options); !mistake.empty()) {
    complain(kSmurfLint, mistake);
    return kFailed;
  }
  return show_model(options, options.paths.front(), [&](const LinkedModel& model) {
    std::vector<JointOrder> orders;
    for (const Reader* reader : options.joint_orders) orders.push_back(joint_order(model, *reader));
    const bool is_json = !options.reports.empty() && options.reports.front().format->name == "json";
    return is_json ? write_joint_orders_json(orders) : text_of(orders);
  });
}

}  // namespace smurf::tools
