#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""document_stubs.py STUBS: writes the docstrings of the module into its stubs, where editors read them.

PYTHONPATH must lead to the module.
"""
import ast
import pathlib
import sys
import textwrap

WIDTH = 112


def doc_of(item):
    """The docstring without the signature that pybind11 puts before it."""
    doc = (getattr(item, "__doc__", None) or "").strip()
    if isinstance(item, type) or isinstance(item, property):
        return doc
    signature, _, rest = doc.partition("\n\n")
    return rest.strip() if "(" in signature.split("\n")[0] and "->" in signature else doc


def as_lines(doc, indent):
    paragraphs = [textwrap.fill(" ".join(part.split()), WIDTH - len(indent)) for part in doc.split("\n\n")]
    text = "\n\n".join(paragraphs).replace("\\", "\\\\").replace('"""', '\\"\\"\\"')
    if "\n" not in text and len(text) + len(indent) + 6 <= WIDTH and not text.endswith('"'):
        return [f'{indent}"""{text}"""']
    lines = f'"""{text}\n"""'.split("\n")
    return [(indent + line).rstrip() for line in lines]


def documented(stub, module):
    """The stub with a docstring under each class, attribute and function that has one in the module."""
    lines = without_docs(stub).split("\n")
    added = []
    for node in ast.parse("\n".join(lines)).body:
        if not isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            continue
        item = getattr(module, node.name, None)
        if item is None:
            continue
        added.append((node, doc_of(item)))
        for member in node.body if isinstance(node, ast.ClassDef) else []:
            if isinstance(member, ast.FunctionDef) and not member.name.startswith("__"):
                added.append((member, doc_of(getattr(item, member.name, None))))
    for node, doc in sorted(added, key=lambda one: -one[0].lineno):
        if not doc:
            continue
        indent = " " * (node.col_offset + 4)
        if isinstance(node, ast.ClassDef):
            lines[node.lineno : node.lineno] = as_lines(doc, indent)
        else:
            last = node.end_lineno - 1
            lines[last] = lines[last].removesuffix(" ...")
            lines[last + 1 : last + 1] = as_lines(doc, indent)
    return "\n".join(lines)


def without_docs(stub):
    lines = stub.split("\n")
    nodes = [node for node in ast.walk(ast.parse(stub)) if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node)]
    for node in sorted(nodes, key=lambda one: -one.lineno):
        doc = node.body[0]
        del lines[doc.lineno - 1 : doc.end_lineno]
        if isinstance(node, ast.FunctionDef):
            lines[doc.lineno - 2] += " ..."
    return "\n".join(lines)


if __name__ == "__main__":
    import smurf
    path = pathlib.Path(sys.argv[1])
    path.write_text(documented(path.read_text(), smurf))
