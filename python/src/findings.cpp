// SPDX-License-Identifier: BSD-3-Clause
// Findings, reports, rules.
#include <utility>

#include "common.hpp"
#include "render/advice.hpp"
#include "smurf/fix.hpp"
#include "smurf/render.hpp"

namespace smurf::python {
namespace {

/// Findings and the texts they point into; a copy of a SourceMap shares these.
struct Found {
  std::vector<Diagnostic> diagnostics;
  SourceMap sources;
};
struct Finding {
  std::shared_ptr<const Found> found;
  std::size_t index = 0;

  const Diagnostic& operator*() const { return found->diagnostics[index]; }
  const Diagnostic* operator->() const { return &**this; }
  const SourceMap& sources() const { return found->sources; }
};
struct CheckReport {
  std::shared_ptr<const Found> found;
  Report rest;  ///< its diagnostics are in `found`

  std::span<const Diagnostic> diagnostics() const { return found->diagnostics; }
};

py::list list_of(const std::shared_ptr<const Found>& found) {
  py::list findings;
  for (std::size_t i = 0; i < found->diagnostics.size(); ++i) {
    findings.append(py::cast(Finding{found, i}));
  }
  return findings;
}

std::string concise(const Finding& finding) {
  std::string line = render_concise(*finding, finding.sources());
  if (line.ends_with('\n')) line.pop_back();
  return line;
}

/// Edits as (place, begin, end, text), with offsets in bytes.
py::object fix_of(const Finding& finding) {
  if (finding->fixes.empty()) return py::none();
  const Fix& fix = finding->fixes.front();
  py::list edits;
  for (const Edit& edit : fix.edits) {
    py::dict one;
    one["file"] = to_path(finding.sources().path(edit.span.source));
    one["begin"] = edit.span.begin;
    one["end"] = edit.span.end;
    one["text"] = to_text(edit.text);
    edits.append(one);
  }
  py::dict whole;
  whole["is_safe"] = fix.applicability == Applicability::safe;
  whole["edits"] = edits;
  return whole;
}

/// A pickle becomes a plain value of Python, without the texts of the files.
template <class Class>
void bind_plain(Class& bound, const char* function) {
  bound.def("__reduce__", [function](const py::object& self) {
    return py::make_tuple(py::module_::import("smurf._plain").attr("same"),
                          py::make_tuple(py::module_::import("smurf._plain").attr(function)(self)));
  });
}

void bind_finding(py::module_& module) {
  py::class_<Finding> bound(module, "Finding", "One fault at one place, as smurf-lint reports it.");
  bind_plain(bound, "plain_finding");
  bound
      .def_property_readonly(
          "id", [](const Finding& self) { return to_text(self->rule->id); },
          "Id of the rule: \"SML3101\".")
      .def_property_readonly(
          "name", [](const Finding& self) { return to_text(self->rule->name); },
          "Name of the rule: \"unknown-joint\".")
      .def_property_readonly(
          "severity", [](const Finding& self) { return to_text(to_string(self->severity)); },
          "\"error\", \"warning\" or \"info\".")
      .def_property_readonly(
          "message", [](const Finding& self) { return to_text(self->message); },
          "What is wrong, in one sentence.")
      .def_property_readonly(
          "help", [](const Finding& self) { return to_text(render::advice_on(*self)); },
          "What to do about it; may be empty.")
      .def_property_readonly(
          "notes",
          [](const Finding& self) {
            py::list notes;
            for (const std::string& note : self->notes) notes.append(to_text(note));
            return notes;
          },
          "Facts without a place.")
      .def_property_readonly(
          "pointer", [](const Finding& self) { return to_text(self->pointer); },
          "YAML pointer or XPath of the place.")
      .def_property_readonly(
          "place", [](const Finding& self) { return place_of(self->span, self.sources()); },
          "The characters at fault.")
      .def_property_readonly(
          "labels",
          [](const Finding& self) {
            py::list labels;
            for (const Label& label : self->labels) {
              labels.append(
                  py::make_tuple(place_of(label.span, self.sources()), to_text(label.message)));
            }
            return labels;
          },
          "Other places that explain it: tuples of a smurf.Place and a text.")
      .def_property_readonly("fix", &fix_of,
                             "None, or a dict: `is_safe`, and `edits` with `file`, `begin` and "
                             "`end` (bytes) and `text`, as in the JSON report.")
      .def(
          "text", [](const Finding& self) { return to_text(render_full(*self, self.sources())); },
          "With the lines of the file, as smurf-lint shows it.")
      .def("__str__", [](const Finding& self) { return to_text(concise(self)); })
      .def("__repr__",
           [](const Finding& self) { return to_text("<smurf.Finding " + concise(self) + ">"); });
}

void bind_verdict(py::module_& module) {
  py::class_<TargetVerdict> bound(module, "TargetVerdict", "What one reader does with the files.");
  bind_plain(bound, "plain_verdict");
  bound
      .def_property_readonly(
          "target", [](const TargetVerdict& self) { return to_text(self.reader->name); },
          "Name of the reader: \"mujoco\".")
      .def_property_readonly(
          "answer", [](const TargetVerdict& self) { return to_text(to_string(self.answer())); },
          "\"takes\", \"loses\", \"unknown\" or \"refuses\".")
      .def_readonly("refusals", &TargetVerdict::refusals,
                    "Findings for which it refuses the files.")
      .def_readonly("losses", &TargetVerdict::losses,
                    "Findings that it silently reads differently.")
      .def_readonly("unknown", &TargetVerdict::unknown, "Errors whose effect on it is not known.")
      .def("__repr__", [](const TargetVerdict& self) {
        return to_text("<smurf.TargetVerdict " + std::string(self.reader->name) + ": " +
                       std::string(to_string(self.answer())) + ">");
      });
}

void bind_report(py::module_& module) {
  py::class_<CheckReport> bound(module, "Report",
                                "What a check has found; a sequence of findings.");
  bind_plain(bound, "plain_report");
  bound
      .def_property_readonly(
          "findings", [](const CheckReport& self) { return list_of(self.found); },
          "A new list of smurf.Finding, sorted by file, line, column and id.")
      .def_property_readonly(
          "errors", [](const CheckReport& self) { return self.rest.summary.errors; },
          "Number of findings that are errors.")
      .def_property_readonly(
          "warnings", [](const CheckReport& self) { return self.rest.summary.warnings; },
          "Number of findings that are warnings.")
      .def_property_readonly(
          "infos", [](const CheckReport& self) { return self.rest.summary.infos; },
          "Number of findings that are infos.")
      .def_property_readonly(
          "suppressed", [](const CheckReport& self) { return self.rest.summary.suppressed; },
          "Number of findings that comments or the baseline suppress.")
      .def_property_readonly(
          "targets",
          [](const CheckReport& self) {
            py::list targets;
            for (const TargetVerdict& verdict : self.rest.targets) targets.append(verdict);
            return targets;
          },
          "A list of smurf.TargetVerdict, one for each target.")
      .def("__len__", [](const CheckReport& self) { return self.diagnostics().size(); })
      .def("__iter__", [](const CheckReport& self) { return py::iter(list_of(self.found)); })
      .def("__getitem__",
           [](const CheckReport& self, std::int64_t index) {
             const auto size = static_cast<std::int64_t>(self.diagnostics().size());
             if (index < 0) index += size;
             if (index < 0 || index >= size) throw py::index_error("there is no such finding");
             return Finding{self.found, static_cast<std::size_t>(index)};
           })
      .def(
          "to_json",
          [](const CheckReport& self) {
            return to_text(render_json(self.diagnostics(), self.found->sources, self.rest.summary,
                                       {"smurf (Python)", SMURF_VERSION}, self.rest.targets));
          },
          "The report as JSON text (schemas/lint-report.schema.json).")
      .def(
          "text",
          [](const CheckReport& self) {
            std::string text;
            for (const Diagnostic& one : self.diagnostics()) {
              text += render_full(one, self.found->sources);
            }
            text += render_targets(self.rest.targets, self.found->sources, {});
            return to_text(text + render_summary(self.rest.summary, {}));
          },
          "As smurf-lint shows it.")
      .def(
          "fixed",
          [](const CheckReport& self, bool unsafe, bool infos) {
            std::vector<Diagnostic> chosen(self.diagnostics().begin(), self.diagnostics().end());
            if (!infos) {
              std::erase_if(chosen,
                            [](const Diagnostic& one) { return one.severity == Severity::info; });
            }
            const Applicability most = unsafe ? Applicability::unsafe : Applicability::safe;
            py::dict texts;
            for (FixedText& file : apply_fixes(chosen, self.found->sources, most).texts) {
              texts[to_path(file.path)] = py::bytes(file.text);
            }
            return texts;
          },
          py::arg("unsafe") = false, py::arg("infos") = false,
          "The files with the safe fixes, or with all fixes, of errors and warnings, and of infos if "
          "they are asked for: a dict from paths to bytes. Fixes that overlap others are left for "
          "another round; smurf.fix() makes all rounds.")
      .def(
          "_repr_html_",
          [](const CheckReport& self) {
            std::string text;
            for (const Diagnostic& one : self.diagnostics()) {
              if (one.severity == Severity::info) continue;
              text += render_full(one, self.found->sources);
            }
            text += render_targets(self.rest.targets, self.found->sources, {}) +
                    render_summary(self.rest.summary, {});
            const py::object escape = py::module_::import("html").attr("escape");
            return py::str("<pre>{}</pre>").format(escape(to_text(text)));
          },
          "The errors and warnings, for notebooks.")
      .def("__repr__", [](const CheckReport& self) {
        std::string line = render_summary(self.rest.summary, {});
        while (line.ends_with('\n')) line.pop_back();
        return to_text("<smurf.Report: " + line + ">");
      });
}

}  // namespace

py::list to_findings(std::vector<Diagnostic> diagnostics, const SourceMap& sources) {
  return list_of(std::make_shared<const Found>(Found{std::move(diagnostics), sources}));
}

py::object to_report(Report report, const SourceMap& sources) {
  auto found = std::make_shared<const Found>(Found{std::move(report.diagnostics), sources});
  if (!report.problems.empty()) raise_error(report.problems.front(), list_of(found));
  return py::cast(CheckReport{std::move(found), std::move(report)});
}

void bind_places(py::module_& module) {
  py::class_<Place> bound(
      module, "Place",
      "A range of a file: lines and columns (characters) from 1; the end is exclusive.");
  bind_plain(bound, "plain_place");
  bound
      .def_property_readonly(
          "file", [](const Place& self) { return to_path(self.file); },
          "The path, as it was given or found.")
      .def_property_readonly(
          "line", [](const Place& self) { return self.begin.line; }, "First line.")
      .def_property_readonly(
          "column", [](const Place& self) { return self.begin.column; },
          "First column, in characters.")
      .def_property_readonly(
          "end_line", [](const Place& self) { return self.end.line; }, "Line of the end.")
      .def_property_readonly(
          "end_column", [](const Place& self) { return self.end.column; }, "Column of the end.")
      .def("__eq__",
           [](const Place& a, const py::object& b) {
             if (!py::isinstance<Place>(b)) return false;
             const auto& other = b.cast<const Place&>();
             return a.file == other.file && a.begin == other.begin && a.end == other.end;
           })
      .def("__hash__",
           [](const Place& self) {
             return py::hash(py::make_tuple(to_path(self.file), self.begin.line, self.begin.column,
                                            self.end.line, self.end.column));
           })
      .def("__str__",
           [](const Place& self) {
             return py::str("{}:{}:{}")
                 .format(to_path(self.file), self.begin.line, self.begin.column);
           })
      .def("__repr__", [](const Place& self) {
        return py::str("<smurf.Place {}:{}:{}>")
            .format(to_path(self.file), self.begin.line, self.begin.column);
      });
}

void bind_findings(py::module_& module) {
  bind_finding(module);
  bind_verdict(module);
  bind_report(module);
  module.def(
      "explain",
      [](const py::object& rule) {
        const std::string name = from_text(rule, "rule");
        const Rule* found = find_rule(name);
        if (found == nullptr) throw py::value_error("there is no rule '" + name + "'");
        return to_text(render_rule(*found, {}));
      },
      py::arg("rule"), "The page of a rule, by its id or name: what, why, what to do.");
}

}  // namespace smurf::python
