// SPDX-License-Identifier: BSD-3-Clause
// Bounds on what a file may demand. Reaching one is a diagnostic, never a crash or a hang.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace smurf {

/// What each of them means is said in kLimits.
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
  std::uint64_t folder_entries = 1'000'000;
  std::uint64_t ignore_checks = 20'000'000;
  std::uint64_t path_checks = 4'000'000;
  std::uint64_t suggestions = 200'000'000;
};

/// A limit as people know it: what `--limit` and docs/limits.md call it.
struct LimitInfo {
  std::string_view name;
  std::uint64_t Limits::*value;
  std::uint64_t most;           ///< what is still safe to ask for
  std::string_view counts;      ///< "nested lists and mappings"
  std::string_view diagnostic;  ///< the rule that tells of more; empty: a tool says so and ends
  std::string_view reason;      ///< for the usual value, and for the most
};

inline constexpr std::array kLimits{
    LimitInfo{"file-bytes", &Limits::file_bytes, 2047ULL << 20U, "bytes of a file of text",
              "SML0002", "a model of 100,000 links has half of it; places in a file have 32 bits"},
    LimitInfo{"mesh-bytes", &Limits::mesh_bytes, 2047ULL << 20U, "bytes of a mesh or an image",
              "SML1644", "2.7 million triangles of STL"},
    LimitInfo{"image-pixels", &Limits::image_pixels, 1'000'000'000, "pixels of a heightmap",
              "SML6107", "a small file may say it has thousands of millions"},
    LimitInfo{"archive-bytes", &Limits::archive_bytes, 2047ULL << 20U,
              "bytes of all files in an archive, unpacked", "", "a small file may hold any number"},
    LimitInfo{"archive-files", &Limits::archive_files, 1'000'000, "files in an archive", "",
              "as for its bytes"},
    LimitInfo{
        "archive-growth", &Limits::archive_growth, 1'100,
        "bytes that archives unpack to for each of their own, beyond the first 8 MB", "",
        "text is packed to a fifth or less; no archive unpacks to more than 1,032 times its size"},
    LimitInfo{"yaml-cpp-bytes", &Limits::yaml_cpp_bytes, 2047ULL << 20U,
              "bytes of a file of YAML that is not plain: it has anchors, tags, tabs, carriage "
              "returns or a mistake",
              "SML0002", "yaml-cpp needs a second for it; plain YAML is read fifty times as fast"},
    LimitInfo{"yaml-depth", &Limits::yaml_depth, 240, "lists and mappings in each other", "SML0014",
              "no section of SMURF has more than ten; yaml-cpp gives up at 250"},
    LimitInfo{
        "yaml-nodes", &Limits::yaml_nodes, 1'000'000'000, "texts, lists and mappings of a file",
        "SML0002",
        "100,000 entities with poses have two thirds of it; each takes 60 to 120 bytes of memory"},
    LimitInfo{"yaml-expanded-nodes", &Limits::yaml_expanded_nodes, 1'000'000'000,
              "the same that the aliases of a file repeat", "SML0015",
              "no known model repeats 10,000; nine aliases in nine levels repeat 400 million"},
    LimitInfo{"xml-depth", &Limits::xml_depth, 98, "elements in each other", "SML0014",
              "URDF has seven; tinyxml2 gives up at 99"},
    LimitInfo{"xml-elements", &Limits::xml_elements, 1'000'000'000,
              "elements and attributes of a file", "SML0002",
              "100,000 links and joints have nearly as many; each takes about 50 bytes of memory"},
    LimitInfo{"xml-attributes", &Limits::xml_attributes, 10'000, "attributes of one element",
              "SML0002", "URDF has six; each is compared with those before it"},
    LimitInfo{"annotation-entries", &Limits::annotation_entries, 100'000'000,
              "motors, sensors and other entries of the annotations of a model", "SML0002",
              "a model of 100,000 links has three fifths of it; each takes up to 2 kB of memory"},
    LimitInfo{
        "urdf-parts", &Limits::urdf_parts, 100'000'000,
        "links, joints, extensions, visuals and collisions of a robot", "SML0002",
        "a robot of 100,000 links has four fifths of it; each takes 300 to 700 bytes of memory"},
    LimitInfo{"repeated-bytes", &Limits::repeated_bytes, 1'000'000'000,
              "bytes that the models of a scene read again of a file that another one has read",
              "SML0002",
              "a hundred models with a URDF of 160 kB; each byte takes 14 bytes of memory"},
    LimitInfo{"rechecked-bytes", &Limits::rechecked_bytes, 100'000'000'000,
              "bytes of files that `smurf-lint` checks again, for each further model or scene that "
              "reads them, or checks in all while it applies fixes; a finding in one counts as 600",
              "SML0002", "a hundred scenes with a robot of 500 kB have as many; two seconds"},
    LimitInfo{"include-depth", &Limits::include_depth, 1'000, "scenes in each other", "SML5021",
              "scenes that people write have three"},
    LimitInfo{"instances", &Limits::instances, 100'000'000,
              "entities of a scene, those of nested scenes included", "SML5022",
              "scenes that name the next one twice reach it in 18 levels"},
    LimitInfo{"scene-bytes", &Limits::scene_bytes, 100'000'000'000,
              "bytes of a scene when it is written out: names and keys of each entity and, in a "
              "format that repeats models, its URDF; also of the meshes in a preview, and of what "
              "`--copy-assets` copies more than once",
              "SML5022", "1,000 humanoids of 60 links have 70 MB"},
    LimitInfo{"srdf-bytes", &Limits::srdf_bytes, 10'000'000'000,
              "bytes of an SRDF, which has a line for each pair of links that do not collide", "",
              "a robot of 800 links of which none collide has half of it"},
    LimitInfo{"findings", &Limits::findings, 100'000'000,
              "findings of one rule in a model or scene", "SML0002",
              "nobody reads as many; each takes 500 bytes of memory and of the report"},
    LimitInfo{"all-findings", &Limits::all_findings, 100'000'000, "findings of a run", "SML0002",
              "as for those of one rule, of which a megabyte of faults may find two dozen"},
    LimitInfo{"folder-entries", &Limits::folder_entries, 1'000'000'000,
              "files and folders in a folder that is searched, and in those below it", "",
              "a search of a whole machine is a mistake; a million takes some seconds"},
    LimitInfo{"ignore-checks", &Limits::ignore_checks, 1'000'000'000'000,
              "comparisons of a file or folder with a pattern of an ignore file", "",
              "a second; 20,000 models with a thousand patterns each have as many"},
    LimitInfo{
        "path-checks", &Limits::path_checks, 1'000'000'000'000,
        "comparisons of a file that has findings with a pattern of `paths` in a configuration",
        "SML0002", "a second; 20,000 files with two hundred patterns have as many"},
    LimitInfo{"suggestions", &Limits::suggestions, 100'000'000'000,
              "characters compared to find the names that misspelt ones are near to", "SML0002",
              "every misspelt name is compared with all known ones, which takes a second for a "
              "thousand million"},
};

}  // namespace smurf
