// SPDX-License-Identifier: BSD-3-Clause
// What raises an error when a launch file is executed: words that launch does not have, arguments
// that nothing sets, values that cannot be.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "base/text/suggest.hpp"
#include "link/surroundings/launch_elements.hpp"
#include "link/surroundings/launch_texts.hpp"
#include "link/surroundings/python_calls.hpp"
#include "smurf/surroundings.hpp"

namespace smurf::launch {

/// In the elements of a launch file of ROS 2; `texts` knows its arguments.
void find_mistakes(const Element& root, const Texts& texts, LaunchFile& file);
/// In the calls of a launch file in Python.
void find_mistakes(const python::File& python, const Texts& texts, LaunchFile& file);

/// What is wrong with the value of a condition, the name or the namespace of a node.
void check_condition(const LaunchText& value, LaunchFile& file);
void check_node_name(const LaunchText& name, LaunchFile& file);
void check_namespace(const LaunchText& name, LaunchFile& file);
/// Names of packages with a slash.
void check_packages(LaunchFile& file);
/// The name that FindExecutable, or `$(find-exec NAME)`, looks for.
void check_program(std::string_view name, Span span, LaunchFile& file);
/// The nearest of some names. All searches in a file together compare few; later ones find none.
class NearNames {
 public:
  std::optional<std::string_view> of(std::string_view name,
                                     std::span<const std::string_view> known) {
    constexpr std::size_t kMost = 200'000;
    compared_ += known.size();
    return compared_ > kMost ? std::nullopt : near_name(name, known);
  }

 private:
  std::size_t compared_ = 0;
};
/// An argument that is read: `known` are all that the file sets.
void check_argument(std::string_view name, Span span, std::span<const std::string_view> known,
                    bool is_below, NearNames& near_names, LaunchFile& file);

}  // namespace smurf::launch
