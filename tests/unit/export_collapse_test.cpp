// SPDX-License-Identifier: BSD-3-Clause
// Exports without fixed joints.
#include <doctest/doctest.h>

#include "unit/exported.hpp"

using namespace smurf;
using namespace smurf::test;

TEST_CASE("a link on a fixed joint becomes part of the link that carries it") {
  UrdfExport options;
  options.collapses_fixed = true;
  const Exported collapsed(Read(kUrdf), options);
  CHECK_FALSE(collapsed.has("bulb"));
  CHECK(collapsed.has("<mass value=\"0.75\"/>"));
  CHECK(collapsed.has("    <visual>\n"
                      "      <origin xyz=\"0 0.1 0.2\" rpy=\"0 0 1."));
  // A sensor is on `eye`, so it stays a link, now on the arm; the shade is also attached to the
  // arm.
  CHECK(collapsed.has("<link name=\"eye\"/>"));
  CHECK(collapsed.has("<parent link=\"arm\"/>\n    <child link=\"shade\"/>\n"
                      "    <axis xyz=\"1 0 0\"/>\n    <limit effort=\"1\" velocity=\"1\"/>\n"));
  CHECK(collapsed.has("    <origin xyz=\"0 0.1 0.2\" rpy=\"0 0 1."));
  CHECK(collapsed.loses("SML8005 the link `bulb` becomes part of `arm`"));
  options.keep = {"mount"};
  CHECK(Exported(Read(kUrdf), options).text == kUrdf);
}

TEST_CASE("a text that moves does not grow by the indentation of its new place") {
  UrdfExport options;
  options.collapses_fixed = true;
  const std::string text = "<robot name=\"r\">\n" + std::string(999, ' ') +
                           "<link name=\"a\"/>\n<link name=\"b\"><visual>" +
                           std::string(10'000, '\n') +
                           "<geometry><box size=\"1 1 1\"/></geometry></visual></link>"
                           "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/>"
                           "<child link=\"b\"/></joint></robot>";
  const Exported collapsed(Read(text), options);
  CHECK_FALSE(collapsed.has("<joint"));
  CHECK(collapsed.text.size() < 2 * text.size());
}

TEST_CASE("a link with two parents hangs on both of them still") {
  UrdfExport options;
  options.collapses_fixed = true;
  const std::string second = R"(  <joint name="c" type="fixed">
    <parent link="base"/><child link="top"/>
  </joint>
)";
  const Exported collapsed(Read(tower(second)), options);
  CHECK_FALSE(collapsed.has("floor"));
  CHECK(collapsed.has("<link name=\"top\"></link>"));
  CHECK(collapsed.has("<joint name=\"b\""));
  CHECK(collapsed.has("<joint name=\"c\""));
}

TEST_CASE("sensors on a collapsed link stand on the carrying one, where they stood") {
  UrdfExport options;
  options.collapses_fixed = true;
  const Exported collapsed(
      Read(tower("<gazebo reference=\"top\"><sensor name=\"top\" type=\"camera\">"
                 "<pose>1 0 0 0 0 0</pose></sensor></gazebo>\n"
                 "<gazebo reference=\"floor\"><sensor name=\"s\" type=\"imu\"/></gazebo>\n"
                 "<sensor name=\"r\"><parent link=\"top\"/><origin rpy=\"0 0 1\"/></sensor>\n")),
      options);
  CHECK_FALSE(collapsed.has("<link name=\"top\">"));
  CHECK(collapsed.has("<gazebo reference=\"base\"><sensor name=\"top\" type=\"camera\">"
                      "<pose>0.877582561890372"));
  CHECK(collapsed.has("<pose>0 1 1 0 0 0</pose>"));
  CHECK(collapsed.has("<parent link=\"base\"/><origin xyz=\"0 1 2\" rpy=\"0 0 1."));
}

TEST_CASE("a link stays when the carrying one cannot answer for it") {
  UrdfExport options;
  options.collapses_fixed = true;
  const auto stays = [&](const std::string& extensions, const std::string& shape = {}) {
    return Exported(Read(tower(extensions, shape)), options).has("<link name=\"top\">");
  };
  const std::string red = "<gazebo reference=\"top\"><material>Red</material></gazebo>";
  const std::string sphere = "<visual><geometry><sphere radius=\"1\"/></geometry></visual>";
  CHECK_FALSE(stays(""));
  CHECK(stays(red));
  CHECK_FALSE(stays(red + "<gazebo reference=\"base\"><material> Red </material></gazebo>"));
  CHECK(stays("<gazebo reference=\"base\"><mu1>2</mu1></gazebo>", sphere));
  CHECK_FALSE(stays("<gazebo reference=\"base\"><mu1>2</mu1></gazebo>"));  // a mere frame
  CHECK(stays("<gazebo reference=\"top\"><plugin name=\"p\"/></gazebo>"));
  CHECK(stays("<gazebo><plugin name=\"p\"><frame>top</frame></plugin></gazebo>"));
  CHECK(stays("<gazebo reference=\"b\"><preserveFixedJoint>1</preserveFixedJoint></gazebo>"));
  CHECK(stays("<gazebo reference=\"top\"><sensor name=\"s\" type=\"contact\"><contact/></sensor>"
              "</gazebo>"));
  CHECK(stays("<gazebo reference=\"top\"><sensor name=\"s\" type=\"imu\">"
              "<pose degrees=\"true\">0 0 0 0 0 90</pose></sensor></gazebo>"));
  CHECK(stays("", "<contact><lateral_friction value=\"2\"/></contact>"));
  CHECK(stays("<transmission name=\"t\"><joint name=\"b\"/></transmission>"));
}

TEST_CASE("the proof finds a mass that went missing on the way") {
  const Read lamp(kUrdf);
  UrdfExport options;
  options.collapses_fixed = true;
  DiagnosticSink sink;
  const std::string text = export_urdf(lamp.model, lamp.sources, options, sink);
  const Read wrong(replaced(text, "<mass value=\"0.75\"/>", "<mass value=\"0.5\"/>"));
  const Proof proof = compare_models(lamp.model, wrong.model, proof_scope(options));
  CHECK(proof.difference == "the total mass differs");
  // Links that move must not vanish.
  CHECK_FALSE(compare_models(lamp.model, Read(replaced(text, "\"shade\"", "\"shape\"")).model,
                             proof_scope(options))
                  .holds());
}
