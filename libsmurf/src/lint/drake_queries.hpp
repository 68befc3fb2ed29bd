// SPDX-License-Identifier: BSD-3-Clause
// Names and numbers as Drake reads them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/readers.hpp"
#include "smurf/linked.hpp"
#include "smurf/lint.hpp"

namespace smurf::drake {

/// Findings about a joint that is missing to other readers.
inline constexpr Circumstance kDrakeJoint{"joint of Drake", &readers::drake};
/// A note for them.
inline constexpr const char* kJointNote =
    "it is a `drake:joint`, which only Drake reads: check the file with `--target drake`";

/// The `drake:joint` elements of the robot: joints that only Drake reads.
std::vector<xml::View> own_joints(const LinkedModel& model);
/// The values of an attribute of these joints ("name"), or of an element in them ("child", "link").
std::set<std::string_view> names_in(const std::vector<xml::View>& elements,
                                    std::string_view attribute);
std::set<std::string_view> names_in(const std::vector<xml::View>& elements, std::string_view child,
                                    std::string_view attribute);

/// The value of an attribute; empty if it is absent.
std::string_view value_of(xml::View element, std::string_view attribute);
/// Whether Drake is told to ignore a link or joint.
bool is_passed_over(xml::View element);

/// Whether Drake makes an actuator of a `transmission`.
bool is_simple(xml::View transmission);

/// Whether a `drake:joint` has an empty type or an empty name of a link.
bool has_empty_part(xml::View element);

/// The things that have a name in Drake.
class Names {
 public:
  explicit Names(const LinkedModel& model);

  const LinkedModel& model() const { return model_; }
  /// The first thing of this name; false if Drake does not make such a joint.
  xml::View joint(std::string_view name) const { return joints_.find(name); }
  xml::View group(std::string_view name) const { return groups_.find(name); }
  bool is_body(std::string_view name) const;
  bool is_frame(std::string_view name) const;
  /// Whether Drake is told to ignore the link of this name.
  bool is_ignored(std::string_view link) const { return ignored_.contains(link); }
  static void report_ignored(std::string_view link, Span place, Findings& findings);
  /// The earlier frame of the same name; false for the first one.
  xml::View earlier_frame(xml::View frame) const;
  /// Whether earlier joints connect the two links of a joint already.
  bool closes_loop(xml::View joint) const { return loops_.contains(joint.id()); }
  /// Reports that there is no joint, frame or group of this name.
  void report_unknown(std::string_view kind, std::string_view name, Span place,
                      const std::string& subject, Findings& findings) const;

 private:
  struct Table {
    std::map<std::string_view, xml::View> elements;  ///< the first of each name
    std::vector<std::string_view> names;             ///< in the order of the file

    void add(std::string_view name, xml::View element);
    xml::View find(std::string_view name) const;
  };

  const LinkedModel& model_;
  void find_loops();

  Table joints_, frames_, groups_;
  std::set<std::string_view> ignored_;  ///< links
  std::set<xml::ElementId> loops_;      ///< joints
};

}  // namespace smurf::drake
