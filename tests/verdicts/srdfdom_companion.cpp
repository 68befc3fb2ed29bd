// SPDX-License-Identifier: BSD-3-Clause
// What srdfdom reads of SRDFs, for companion_verdicts.py --record. Built by hand, with srdfdom's
// src/model.cpp and a header urdf/model.h that includes those of urdfdom:
//   c++ -std=c++17 -I SRDFDOM/include srdfdom_companion.cpp SRDFDOM/src/model.cpp
//       -lurdfdom_model -ltinyxml2 -lconsole_bridge
#include <console_bridge/console.h>
#include <srdfdom/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

namespace {

struct Log : console_bridge::OutputHandler {
  std::string text;
  void log(const std::string& line, console_bridge::LogLevel level, const char*, int) override {
    text += (level == console_bridge::CONSOLE_BRIDGE_LOG_ERROR ? "E:" : "W:") + line + " ";
  }
};

void print_groups(const srdf::Model& model, std::ostream& out) {
  for (const auto& group : model.getGroups()) {
    out << "group " << group.name_ << " {";
    for (const auto& one : group.joints_) out << "j " << one << " ";
    for (const auto& one : group.links_) out << "l " << one << " ";
    for (const auto& one : group.chains_) out << "c " << one.first << ">" << one.second << " ";
    for (const auto& one : group.subgroups_) out << "g " << one << " ";
    out << "}; ";
  }
  for (const auto& state : model.getGroupStates()) {
    out << "state " << state.name_ << "/" << state.group_ << " {";
    for (const auto& [joint, values] : state.joint_values_) {
      out << joint << "=";
      for (const double value : values) out << value << ",";
    }
    out << "}; ";
  }
}

void print_pairs(const srdf::Model& model, std::ostream& out) {
  for (const auto& one : model.getNoDefaultCollisionLinks()) out << "default " << one << "; ";
  for (const auto& one : model.getEnabledCollisionPairs()) {
    out << "enabled " << one.link1_ << "," << one.link2_ << "; ";
  }
  for (const auto& one : model.getDisabledCollisionPairs()) {
    out << "disabled " << one.link1_ << "," << one.link2_ << "," << one.reason_ << "; ";
  }
  for (const auto& link : model.getLinkSphereApproximations()) {
    out << "spheres " << link.link_ << " {";
    for (const auto& one : link.spheres_) {
      out << one.center_x_ << "," << one.center_y_ << "," << one.center_z_ << "," << one.radius_
          << " ";
    }
    out << "}; ";
  }
}

void print(const srdf::Model& model, std::ostream& out) {
  out << "name " << model.getName() << "; ";
  for (const auto& one : model.getVirtualJoints()) {
    out << "virtual " << one.name_ << "," << one.type_ << "," << one.parent_frame_ << ","
        << one.child_link_ << "; ";
  }
  print_groups(model, out);
  for (const auto& one : model.getEndEffectors()) {
    out << "effector " << one.name_ << "," << one.parent_link_ << "," << one.parent_group_ << ","
        << one.component_group_ << "; ";
  }
  print_pairs(model, out);
  for (const auto& one : model.getPassiveJoints()) out << "passive " << one.name_ << "; ";
  for (const auto& [joint, properties] : model.getJointProperties()) {
    for (const auto& one : properties) {
      out << "property " << joint << "," << one.property_name_ << "," << one.value_ << "; ";
    }
  }
}

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

int main() {
  Log log;
  console_bridge::useOutputHandler(&log);
  std::map<std::string, urdf::ModelInterfaceSharedPtr> robots;
  for (std::string line; std::getline(std::cin, line);) {
    const std::string robot = line.substr(0, line.find('\t'));
    const std::string file = line.substr(line.find('\t') + 1);
    if (!robots.count(robot)) robots[robot] = urdf::parseURDFFile(robot);
    log.text.clear();
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    srdf::Model model;
    std::ostringstream out;
    const bool is_read = robots[robot] && model.initString(*robots[robot], text.str());
    if (is_read) print(model, out);
    std::cout << file << "\t" << (is_read ? "ok" : "refuses") << "\t" << on_one_line(out.str())
              << "\t" << on_one_line(log.text) << "\n";
  }
}
