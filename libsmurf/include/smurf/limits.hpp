// SPDX-License-Identifier: BSD-3-Clause
// Limits for untrusted files. Reaching one is a diagnostic, never a crash or a hang.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace smurf {

/// kLimits explains each of them.
struct Limits {
  std::uint64_t file_bytes = 256ULL << 20U;
  std::uint64_t mesh_bytes = 128ULL << 20U;
  std::uint64_t image_pixels = 16'000'000;
  std::uint64_t archive_bytes = 128ULL << 20U;
  std::uint64_t archive_files = 10'000;
  std::uint64_t archive_growth = 8;
  std::uint64_t yaml_cpp_bytes = 8ULL << 20U;
  std::uint64_t yaml_depth = 100;
  std::uint64_t yaml_nodes = 2'000'000;
  std::uint64_t yaml_expanded_nodes = 100'000;
  std::uint64_t xml_depth = 90;
  std::uint64_t xml_elements = 5'500'000;
  std::uint64_t xml_attributes = 100;
  std::uint64_t annotation_entries = 500'000;
  std::uint64_t urdf_parts = 500'000;
  std::uint64_t repeated_bytes = 16'000'000;
  std::uint64_t rechecked_bytes = 50'000'000;
  std::uint64_t include_depth = 64;
  std::uint64_t instances = 150'000;
  std::uint64_t scene_bytes = 100'000'000;
  std::uint64_t srdf_bytes = 64'000'000;
  std::uint64_t findings = 10'000;
  std::uint64_t all_findings = 25'000;
  std::uint64_t differences = 100'000;
  std::uint64_t folder_entries = 1'000'000;
  std::uint64_t ignore_checks = 20'000'000;
  std::uint64_t path_checks = 4'000'000;
  std::uint64_t suggestions = 200'000'000;
  std::uint64_t xacro_elements = 500'000;
  std::uint64_t xacro_bytes = 100'000'000;
  std::uint64_t xacro_depth = 240;
  std::uint64_t xacro_files = 1'000;
  std::uint64_t xacro_steps = 10'000'000;
  std::uint64_t xacro_text_bytes = 1'000'000;
  std::uint64_t xacro_items = 100'000;
  std::uint64_t xacro_integer_bits = 4'096;
  std::uint64_t xacro_variants = 64;
};

/// A limit with the name that `--limit` and docs/limits.md use.
struct LimitInfo {
  std::string_view name;
  std::uint64_t Limits::*value;
  std::uint64_t most;           ///< the largest safe value
  std::string_view counts;      ///< "nested lists and mappings"
  std::string_view diagnostic;  ///< the rule that reports an excess; empty: the tool fails
  std::string_view reason;      ///< the reason for the default and the largest value
};

inline constexpr std::array kLimits{
    LimitInfo{"file-bytes", &Limits::file_bytes, 2047ULL << 20U, "bytes of a file of text",
              "SML0002",
              "a model of 100,000 links needs half of them; offsets in a file are 32-bit numbers"},
    LimitInfo{"mesh-bytes", &Limits::mesh_bytes, 2047ULL << 20U, "bytes of a mesh or an image",
              "SML1644", "2.7 million triangles of STL"},
    LimitInfo{"image-pixels", &Limits::image_pixels, 1'000'000'000,
              "pixels of a heightmap or a texture", "SML6107",
              "a tiny file can claim billions of pixels"},
    LimitInfo{"archive-bytes", &Limits::archive_bytes, 2047ULL << 20U,
              "bytes of all files in an archive, unpacked", "",
              "a small archive can contain any number"},
    LimitInfo{"archive-files", &Limits::archive_files, 1'000'000, "files in an archive", "",
              "a small archive can contain any number"},
    LimitInfo{
        "archive-growth", &Limits::archive_growth, 1'100,
        "unpacked bytes for each packed byte, beyond the first 8 MB", "",
        "text usually shrinks to a fifth; no archive unpacks to more than 1,032 times its size"},
    LimitInfo{"yaml-cpp-bytes", &Limits::yaml_cpp_bytes, 2047ULL << 20U,
              "bytes of a YAML file with anchors, tags, tabs, carriage returns or a mistake",
              "SML0002",
              "yaml-cpp reads them in one second; other YAML is read fifty times faster"},
    LimitInfo{"yaml-depth", &Limits::yaml_depth, 240, "levels of nested lists and mappings",
              "SML0014", "SMURF sections nest ten levels at most; yaml-cpp gives up at 250"},
    LimitInfo{
        "yaml-nodes", &Limits::yaml_nodes, 1'000'000'000, "texts, lists and mappings of a file",
        "SML0002",
        "100,000 entities with poses need two thirds of them; each uses 60 to 120 bytes of memory"},
    LimitInfo{"yaml-expanded-nodes", &Limits::yaml_expanded_nodes, 1'000'000'000,
              "texts, lists and mappings that the aliases of a file repeat", "SML0015",
              "no known model repeats 10,000; nine aliases in nine levels repeat 400 million"},
    LimitInfo{"xml-depth", &Limits::xml_depth, 98, "levels of nested elements", "SML0014",
              "URDF nests seven levels; tinyxml2 gives up at 99"},
    LimitInfo{"xml-elements", &Limits::xml_elements, 1'000'000'000,
              "elements and attributes of a file", "SML0002",
              "100,000 links and joints have nearly as many; each uses about 50 bytes of memory"},
    LimitInfo{"xml-attributes", &Limits::xml_attributes, 10'000, "attributes of one element",
              "SML0002", "URDF elements have six at most; each is compared with all before it"},
    LimitInfo{"annotation-entries", &Limits::annotation_entries, 100'000'000,
              "motors, sensors and other entries of the annotations of a model", "SML0002",
              "a model of 100,000 links has three fifths of them; each uses up to 2 kB of memory"},
    LimitInfo{
        "urdf-parts", &Limits::urdf_parts, 100'000'000,
        "links, joints, extensions, visuals and collisions of a robot", "SML0002",
        "a robot of 100,000 links has four fifths of them; each uses 300 to 700 bytes of memory"},
    LimitInfo{"repeated-bytes", &Limits::repeated_bytes, 1'000'000'000,
              "bytes of files that several models of a scene read again", "SML0002",
              "a hundred models with a URDF of 160 kB; each byte uses 14 bytes of memory"},
    LimitInfo{
        "rechecked-bytes", &Limits::rechecked_bytes, 100'000'000'000,
        "bytes of files that `smurf-lint` checks again for further models and scenes that read "
        "them, or checks in total while it applies fixes; a finding counts as 1200 bytes",
        "SML0002", "a hundred scenes with a robot of 500 kB; two seconds"},
    LimitInfo{"include-depth", &Limits::include_depth, 1'000,
              "levels of nested scenes, and of xacro files that include each other", "SML5021",
              "scenes written by people have three levels"},
    LimitInfo{"instances", &Limits::instances, 100'000'000,
              "entities of a scene, including nested scenes", "SML5022",
              "18 levels of scenes that each include the next one twice reach the limit"},
    LimitInfo{"scene-bytes", &Limits::scene_bytes, 100'000'000'000,
              "bytes of an expanded scene: names and keys of each entity and, in a format that "
              "repeats models, its URDF; also of the meshes in a preview, and of files that "
              "`--copy-assets` copies more than once",
              "SML5022", "1,000 humanoids of 60 links have 70 MB"},
    LimitInfo{"srdf-bytes", &Limits::srdf_bytes, 10'000'000'000,
              "bytes of an SRDF, which has a line for each pair of links that do not collide", "",
              "a robot of 800 links that never collide needs half of them"},
    LimitInfo{"findings", &Limits::findings, 100'000'000,
              "findings of one rule in a model or scene", "SML0002",
              "longer reports are useless; each uses 500 bytes of memory and of the report"},
    LimitInfo{"all-findings", &Limits::all_findings, 100'000'000, "findings of a run", "SML0002",
              "a megabyte of input can break two dozen rules everywhere"},
    LimitInfo{"differences", &Limits::differences, 100'000'000,
              "differences that smurf-diff reports", "",
              "longer reports are useless; each uses 2 kB of memory and of the report"},
    LimitInfo{"folder-entries", &Limits::folder_entries, 1'000'000'000,
              "files and folders below a folder that is searched", "",
              "searching a whole machine is a mistake; a million takes some seconds"},
    LimitInfo{"ignore-checks", &Limits::ignore_checks, 1'000'000'000'000,
              "comparisons of a file or folder with a pattern of an ignore file", "",
              "a second; 20,000 models with a thousand patterns each"},
    LimitInfo{
        "path-checks", &Limits::path_checks, 1'000'000'000'000,
        "comparisons of a file that has findings with a pattern of `paths` in a configuration",
        "SML0002", "a second; 20,000 files with two hundred patterns"},
    LimitInfo{"suggestions", &Limits::suggestions, 100'000'000'000,
              "characters compared to find suggestions for misspelt names", "",
              "every misspelt name is compared with all known ones, which takes a second for a "
              "billion characters"},
    LimitInfo{"xacro-elements", &Limits::xacro_elements, 100'000'000,
              "elements of an expanded xacro file, and of the blocks in its calls", "SML3312",
              "16 macros that each call the next one twice make 65,536; the largest public robot "
              "has 40,806"},
    LimitInfo{"xacro-bytes", &Limits::xacro_bytes, 2047ULL << 20U,
              "bytes of an expanded xacro file, and of the values in it", "SML3312",
              "a text that is doubled 30 times has a gigabyte"},
    LimitInfo{"xacro-depth", &Limits::xacro_depth, 240,
              "macros that call each other, and properties that use each other", "SML3312",
              "xacro itself fails at 250, where the stack of Python ends"},
    LimitInfo{"xacro-files", &Limits::xacro_files, 1'000'000,
              "files that a xacro file includes, each as often as it is included", "SML3312",
              "the largest public robot includes 60"},
    LimitInfo{"xacro-steps", &Limits::xacro_steps, 10'000'000'000,
              "steps of an expansion: elements, calls and parts of expressions", "SML3312",
              "two seconds; the largest public robot needs half a million"},
    LimitInfo{"xacro-text-bytes", &Limits::xacro_text_bytes, 1'000'000'000,
              "bytes of a text that an expression computes", "SML3312",
              "`'a'*10**8` has a hundred million"},
    LimitInfo{"xacro-items", &Limits::xacro_items, 100'000'000,
              "items of a list that an expression computes", "SML3312",
              "`[0]*10**8` has a hundred million"},
    LimitInfo{"xacro-integer-bits", &Limits::xacro_integer_bits, 1'000'000,
              "bits of an integer that an expression computes", "SML3312",
              "`10**10**10` has 33 billion"},
    LimitInfo{"xacro-variants", &Limits::xacro_variants, 100'000,
              "combinations of the arguments of a xacro file in a configuration", "SML9002",
              "six lists of ten values have a million; each is a whole robot"},
};

}  // namespace smurf
