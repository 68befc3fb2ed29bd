// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS smurf.cpp:465-480, ControllerData.cpp:41-92, Controller.cpp:173.
#include "ast/sections.hpp"

namespace smurf::sections::controllers_file {
namespace {

using enum ValueType;

constexpr Key<Controller> kKeys[] = {
    {{.name = "name", .type = text, .doc = "Name of the controller."}, &Controller::name},
    {{.name = "rate",
      .type = number,
      .doc = "Time between two calls, in whole milliseconds.",
      .unit = "ms",
      .fallback = "20",
      .minimum = 0},
     &Controller::rate},
    {{.name = "dylib_path",
      .type = text,
      .doc = "Shared library; without it the controller is a program reached over TCP."},
     &Controller::dylib_path},
    {{.name = "sensors",
      .type = name_list,
      .doc = "Sensors that the controller reads, in order.",
      .names = {NameKind::sensor}},
     &Controller::sensors},
    {{.name = "motors",
      .type = name_list,
      .doc = "Motors that the controller drives, in order.",
      .names = {NameKind::motor}},
     &Controller::motors},
};

constexpr KeySpec kMoreKeys[] = {
    {.name = "sensorid", .type = number_list, .doc = "Sensors by number."},
    {.name = "motorid", .type = number_list, .doc = "Motors by number."},
    {.name = "nodeid", .type = number_list, .doc = "Nodes by number."},
};

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<Controller>(kKeys, {kMoreKeys}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<Controller>(kKeys, {kMoreKeys}, "controller", entry, section, out.controllers, sink);
}

constexpr std::string_view kAliases[] = {"controller"};

}  // namespace

constinit const SectionSpec controllers{
    .name = "controllers",
    .aliases = kAliases,
    .entry = "controller",
    .doc = "Controllers; they come after the sensors and motors that they use.",
    .read_by = "MARS 1; Phobos 2 stops with an error at this section",
    .filtered_keys = keys,
    .read = read,
    .list = list_of<&Annotations::controllers>()};

}  // namespace smurf::sections::controllers_file
