// SPDX-License-Identifier: BSD-3-Clause
// What a launch file starts, read without executing it.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "smurf/surroundings.hpp"
#include "smurf/xml.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Looks up a file of a package; sets `path`, `exists`, `is_judged` and `similar`.
using FindLaunchPath = std::function<void(LaunchPath&)>;

/// A launch file in Python.
void read_python_launch(std::string_view text, const FindLaunchPath& find, LaunchFile& file);
/// A launch file in XML, of ROS 1 or ROS 2.
void read_xml_launch(const xml::Document& document, const FindLaunchPath& find, LaunchFile& file);
/// A launch file in YAML, of ROS 2.
void read_yaml_launch(const yaml::Document& document, const FindLaunchPath& find, LaunchFile& file);

}  // namespace smurf
