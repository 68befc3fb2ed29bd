// SPDX-License-Identifier: BSD-3-Clause
// What the parser of ros2_control reads of robots, for companion_verdicts.py --record. Built by
// hand from a branch of ros2_control, with -DHUMBLE for that one, and with headers of a few lines
// for fmt/compile.h, fmt/format.h, rclcpp/version.h and urdf/model.hpp:
//   c++ -std=c++17 -I STUBS -I hardware_interface/include -I joint_limits/include
//       hardware_companion.cpp hardware_interface/src/component_parser.cpp
//       hardware_interface/src/lexical_casts.cpp -lurdfdom_model -ltinyxml2
#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "hardware_interface/component_parser.hpp"
#include "hardware_interface/hardware_info.hpp"

namespace {

template <class Parameters>
void print_parameters(const Parameters& parameters, std::ostream& out) {
  const std::map<std::string, std::string> sorted(parameters.begin(), parameters.end());
  for (const auto& [name, value] : sorted) out << name << "=" << value << ",";
}

template <class Interface>
void print_interface(const char* kind, const Interface& one, std::ostream& out) {
  out << kind << ":" << one.name << "[" << one.min << "|" << one.max << "|" << one.initial_value
      << "|" << one.data_type << "|" << one.size;
#ifndef HUMBLE
  out << "|" << one.enable_limits << "|";
  print_parameters(one.parameters, out);
#endif
  out << "]";
}

template <class Component>
void print_component(const Component& one, std::ostream& out) {
  out << "{" << one.type << " " << one.name << " ";
#ifndef HUMBLE
  out << "mimic" << static_cast<int>(one.is_mimic) << " limits" << one.enable_limits << " ";
#endif
  for (const auto& inner : one.command_interfaces) print_interface("c", inner, out);
  for (const auto& inner : one.state_interfaces) print_interface("s", inner, out);
  print_parameters(one.parameters, out);
  out << "}";
}

template <class Gears>
void print_gears(const char* kind, const Gears& gears, std::ostream& out) {
  for (const auto& one : gears) {
    out << kind << one.name << "/" << one.role << "/" << one.mechanical_reduction << "/"
        << one.offset << " ";
  }
}

template <class Hardware>
void print(const Hardware& one, std::ostream& out) {
  out << "(" << one.name << " " << one.type << " ";
#ifdef HUMBLE
  out << one.hardware_class_type << " ";
#else
  out << one.hardware_plugin_name << " group " << one.group << " rate " << one.rw_rate << " async "
      << one.is_async << " " << one.async_params.thread_priority << " "
      << one.async_params.scheduling_policy << " " << one.async_params.print_warnings << " ";
  for (const int core : one.async_params.cpu_affinity_cores) out << core << ",";
#endif
  print_parameters(one.hardware_parameters, out);
  for (const auto& part : one.joints) print_component(part, out);
  for (const auto& part : one.sensors) print_component(part, out);
  for (const auto& part : one.gpios) print_component(part, out);
  for (const auto& part : one.transmissions) {
    out << "<" << part.name << " " << part.type << " ";
    print_gears("j", part.joints, out);
    print_gears("a", part.actuators, out);
    print_parameters(part.parameters, out);
    out << ">";
  }
#ifndef HUMBLE
  for (const auto& mimic : one.mimic_joints) {
    out << "mimic(" << mimic.joint_index << "," << mimic.mimicked_joint_index << ")";
  }
  std::map<std::string, std::string> limits;
  for (const auto& [joint, limit] : one.limits) limits[joint] = limit.to_string();
  print_parameters(limits, out);
#endif
  out << ")";
}

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    const std::string file = line.substr(line.find('\t') + 1);
    std::stringstream text, messages;
    text << std::ifstream(file).rdbuf();
    std::streambuf* before = std::cerr.rdbuf(messages.rdbuf());
    std::ostringstream out;
    bool is_read = true;
    try {
      for (const auto& one : hardware_interface::parse_control_resources_from_urdf(text.str())) {
        print(one, out);
      }
    } catch (const std::exception& error) {
      is_read = false;
      out << error.what();
    }
    std::cerr.rdbuf(before);
    std::cout << file << "\t" << (is_read ? "ok" : "refuses") << "\t" << on_one_line(out.str())
              << "\t" << on_one_line(messages.str()) << "\n";
  }
}
