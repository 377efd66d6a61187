"""Writes the stub of the module: python3 stubs.py FILE. The first line of each text is a signature, the rest describes."""

import inspect
import re
import sys

HEAD = '''"""Made by examples/python/stubs.py. Do not edit."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Literal, NoReturn

from passive_haptics.arrays import Array, Booleans, Integers, Numbers, Path, Records, Rows
from passive_haptics.results import (
    contact_metrics,
    contact_report,
    display_class,
    power_class,
    run_end,
    status,
    wall_limits,
)

class _class(type): ...
'''


INDENT = "    "


def first_line(thing):
    return (inspect.getdoc(thing) or "").split("\n")[0]


def rest(thing):
    """The text without its signature."""
    text = inspect.getdoc(thing) or ""
    return text.partition("\n")[2].strip("\n")


def body(text, indent):
    """What stands behind a colon: the text, or dots where there is none."""
    if not text:
        return " ..."
    lines = f'"""{text}'.split("\n")
    if len(lines) > 1:
        lines.append("")
    lines[-1] += '"""'
    return "\n" + "\n".join(indent + line if line else "" for line in lines)


def of_function(thing, indent=""):
    """A function by its first line, "name(arguments) -> type"."""
    return f"{indent}def {first_line(thing)}:{body(rest(thing), indent + INDENT)}"


def of_property(name, thing):
    """A property by its first line, "type: what it is"."""
    kind, what = re.match(r"^([^:]+): (.*)", first_line(thing)).groups()
    text = "\n".join(filter(None, [what, rest(thing)]))
    return f"{INDENT}@property\n{INDENT}def {name}(self) -> {kind}:{body(text, 2 * INDENT)}"


def of_class(name, thing):
    """A class: its constructor by the first line, "(arguments)", then what it defines itself."""
    bases = [base.__name__ for base in thing.__bases__ if base.__name__ != "pybind11_object"]
    head = f"class {name}({', '.join(bases) or 'metaclass=_class'}):"
    line = first_line(thing)
    if line.startswith("("):
        arguments = line[1:-1]
        lines = [head + body(rest(thing), INDENT) if rest(thing) else head]
        lines.append(f"{INDENT}def __init__(self{', ' if arguments else ''}{arguments}) -> None: ...")
    else:  # it is returned, or a base
        lines = [head + body(inspect.getdoc(thing) or "", INDENT) if inspect.getdoc(thing) else head]
        lines.append(f"{INDENT}def __init__(self, /, *args: NoReturn, **kwargs: NoReturn) -> None: ...")
    for member, value in sorted(vars(thing).items()):
        if isinstance(value, property):
            lines.append(of_property(member, value))
        elif member == "__eq__":
            lines.append(f"{INDENT}def __eq__(self, other: object) -> bool: ...")
        elif member == "__hash__" and value is None:
            is_hashed = any(base.__hash__ is not None for base in thing.__bases__)
            lines.append(f"{INDENT}__hash__: None" + ("  # type: ignore[assignment]" if is_hashed else ""))
        elif not member.startswith("__") or member in ("__call__", "__len__"):
            lines.append(of_function(value, INDENT))
    return "\n".join(lines)


def stub(module):
    """The text of the stub of a module."""
    parts = []
    for name, thing in vars(module).items():
        if name.startswith("__") and name != "__version__":
            continue
        if inspect.isclass(thing):
            parts.append(of_class(name, thing))
        elif callable(thing):
            parts.append(of_function(thing))
        else:
            parts.append(f"{name}: {type(thing).__name__}")
    return HEAD + "\n".join(parts) + "\n"


if __name__ == "__main__":
    from passive_haptics import _native

    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(stub(_native))
