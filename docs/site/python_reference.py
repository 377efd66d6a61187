"""Prints the reference of the package for Python as Markdown, from its sources and, if it is built, the classes of the
catalogue and the stub of its module.

python3 docs/site/python_reference.py: needs neither the package nor a compiler. With --index it prints what the
site's search finds in it, a line for each class, function and method.
"""

from __future__ import annotations

import ast
import json
import pathlib
import re
import sys

PACKAGE = pathlib.Path(__file__).parents[2] / "examples/python/package/passive_haptics"
BUILT = pathlib.Path(__file__).parents[2] / "build/python/build"
WIDTH = 100  # of a line of code on the site [letters]
SPECIAL = re.compile(r"([\\`*_<>#@|&~\[\]])")
# A module as users import it, and the files whose names it has
MODULES = {
    "passive_haptics": (
        "_native.pyi", "catalogue.py", "devices.py", "catalogue_values.py", "scenes.py", "controllers.py", "simulations.py",
        "python_mechanism.py", "device_file.py", "chains.py", "logs.py", "results.py", "__init__.py",
    ),  # fmt: skip
    "passive_haptics.producible_forces": ("producible_forces.py",),
    "passive_haptics.plots": ("plots.py",),
    "passive_haptics.sweep": ("sweep.py",),
}


def escaped(text: str) -> str:
    """A line as Markdown that means nothing but its words."""
    return SPECIAL.sub(r"\\\1", " ".join(text.split()))


def items(text: str) -> str:
    """A section as NumPy writes it, names with indented texts, as a list."""
    entries = re.findall(r"(?m)^(\S.*)((?:\n +.*)*)", text)
    return "\n".join(f"- `{name}`" + (f"<br>{escaped(about)}" if about else "") for name, about in entries)


def paragraphs(text: str) -> str:
    """A text of the sources as Markdown: sections of NumPy as lists, what else is indented as code."""
    text, *sections = re.split(r"(?m)^(Parameters|Returns|Raises)\n-+\n", text)
    lists = [f"{title}:\n\n{items(body)}" for title, body in zip(sections[::2], sections[1::2])]
    return "\n\n".join(filter(None, [words_and_code(text), *lists]))


def words_and_code(text: str) -> str:
    """A text as Markdown; what is indented in it is code."""
    parts = re.split(r"\n((?:(?:    .*)?\n)*    .*)(?=\n|$)", "\n" + text)
    shown = []
    for words, code in zip(parts[::2], [*parts[1::2], None]):
        shown += [escaped(paragraph) for paragraph in words.split("\n\n") if paragraph.strip()]
        if code is not None:
            shown.append("```text\n" + re.sub("(?m)^    ", "", code).strip("\n") + "\n```")
    return "\n\n".join(shown)


def text_of(node: ast.AsyncFunctionDef | ast.FunctionDef | ast.ClassDef, file: str) -> str:
    """The text under a definition, which each public one has."""
    text = ast.get_docstring(node)
    if not text:
        sys.exit(f"{PACKAGE / file}, line {node.lineno}: {node.name} has no text: expected one; write it under the name")
    return text


def call(function: ast.FunctionDef, name: str) -> str:
    """name(arguments) -> type, of a method without self."""
    arguments = re.sub(r"^self(, /)?(, |$)", "", ast.unparse(function.args))
    arguments = re.sub(r"(?<=[\w\]])=", " = ", arguments)
    result = f" -> {ast.unparse(function.returns)}" if function.returns and function.name != "__init__" else ""
    return f"{name}({arguments}){result}"


def block(text: str) -> str:
    """A call as code, an argument a line where it is long."""
    if len(text) > WIDTH:
        inside, depth, lines = text[text.index("(") + 1 : text.rindex(")")], 0, [""]
        for letter in inside:
            depth += (letter in "([") - (letter in ")]")
            lines[-1] += letter
            if letter == "," and depth == 0:
                lines.append("")
        text = text[: text.index("(") + 1] + "".join(f"\n    {line.strip()}" for line in lines) + "\n" + text[text.rindex(")") :]
    return f"```python\n{text}\n```"


def tree_of(file: str) -> ast.Module:
    """A file of the package; what only a build makes is empty without one."""
    paths = [PACKAGE / file, *sorted(BUILT.glob(f"lib*/passive_haptics/{file}"))]
    found = [path for path in paths if path.exists()]
    return ast.parse(found[-1].read_text(encoding="utf-8") if found else "")


def is_public(node: ast.stmt) -> bool:
    """True if a definition is for users."""
    return isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_")


def definitions(file: str) -> list[ast.stmt]:
    """What a file has for users: of the stub, only the classes."""
    found = [node for node in tree_of(file).body if is_public(node)]
    return [node for node in found if isinstance(node, ast.ClassDef) or file != "_native.pyi"]


def member(node: ast.FunctionDef, file: str) -> str:
    """A line for a method or a property."""
    is_property = any(ast.unparse(d) in ("property", "functools.cached_property") for d in node.decorator_list)
    if is_property:
        head = f"{node.name}: {ast.unparse(node.returns) if node.returns else ''}"
    else:
        head = call(node, node.name)
    return f"- `{head}`<br>" + escaped(text_of(node, file))


def values(node: ast.ClassDef) -> list[str]:
    """The constants of an enumeration, the fields of a tuple and their texts."""
    lines = []
    for entry, after in zip(node.body, [*node.body[1:], None]):
        if isinstance(entry, ast.Assign):
            lines.append(f"- `{ast.unparse(entry)}`")
        elif isinstance(entry, ast.AnnAssign) and not ast.unparse(entry.target).startswith("_"):
            text = after.value.value if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant) else ""
            lines.append(f"- `{ast.unparse(entry)}` " + escaped(text))
    return [line.rstrip() for line in lines]


def of_class(node: ast.ClassDef, file: str) -> str:
    """How it is made, what it is, what it has."""
    functions = [entry for entry in node.body if isinstance(entry, ast.FunctionDef)]
    made = [f for f in functions if f.name == "__init__" and "NoReturn" not in ast.unparse(f.args)]
    parts = [block(call(f, node.name)) for f in made]
    if node.bases:
        parts.append("Derived from " + ", ".join(f"`{ast.unparse(base)}`" for base in node.bases) + ".")
    parts.append(paragraphs(text_of(node, file)))
    shown = values(node) + [member(f, file) for f in functions if is_public(f) or f.name == "__call__"]
    if shown:
        parts.append("\n".join(shown))
    return "\n\n".join(parts)


def of_function(node: ast.FunctionDef, file: str) -> str:
    """How it is called and what it does."""
    return block(call(node, node.name)) + "\n\n" + paragraphs(text_of(node, file))


def anchor(module: str, name: str) -> str:
    """Where a definition stands on its page."""
    return f"guide_python_reference_{module.replace('.', '_')}_{name}"


def entry(module: str, owner: str, name: str, text: str) -> str:
    """A line of search_index.js: address, page, title and text."""
    address = f"guide_python_reference.html#{anchor(module, owner)}"
    return json.dumps([address, "Python reference", f"{module}.{name}", " ".join(text.split())], ensure_ascii=False) + ","


def index() -> str:
    """What the site's search finds of all modules."""
    lines = []
    for module, files in MODULES.items():
        for file in files:
            for node in definitions(file):
                text = text_of(node, file)
                methods = node.body if isinstance(node, ast.ClassDef) else []
                for method in filter(is_public, methods):
                    if method.decorator_list:  # a property: one word of its class
                        text += f" {method.name} {text_of(method, file)}"
                    else:
                        lines.append(entry(module, node.name, f"{node.name}.{method.name}", text_of(method, file)))
                lines.append(entry(module, node.name, node.name, text))
    return "\n".join(lines) + "\n"


def reference() -> str:
    """All modules."""
    parts = []
    for module, files in MODULES.items():
        parts.append(f"## {module} {{#guide_python_reference_{module.replace('.', '_')}}}")
        for file in files:
            tree = tree_of(file)
            text = ast.get_docstring(tree)
            if text and (module != "passive_haptics" or file == "__init__.py"):
                parts.append(paragraphs(text))
            for node in definitions(file):
                of = of_class if isinstance(node, ast.ClassDef) else of_function
                parts.append(f"### {node.name} {{#{anchor(module, node.name)}}}")
                parts.append(of(node, file))
    return "\n\n".join(parts) + "\n"


if __name__ == "__main__":
    sys.stdout.write(index() if sys.argv[1:] == ["--index"] else reference())
