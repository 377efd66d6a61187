"""Writes the stub of the module: python3 stubs.py FILE. The first line of each text is a signature."""

import inspect
import re
import sys

HEAD = '''"""Made by examples/python/stubs.py. Do not edit."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Literal, NoReturn

from passive_haptics.arrays import Array, Booleans, Integers, Numbers, Records, Rows
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


def first_line(thing):
    return (inspect.getdoc(thing) or "").split("\n")[0]


def of_function(thing):
    """A function by its first line, "name(arguments) -> type"."""
    return f"def {first_line(thing)}: ..."


def of_property(name, thing):
    """A property by its first line, "type: what it is"."""
    kind = re.match(r"^([^:]+): ", first_line(thing)).group(1)
    return f"@property\n    def {name}(self) -> {kind}: ..."


def of_class(name, thing):
    """A class: its constructor by the first line, "(arguments)", then what it defines itself."""
    bases = [base.__name__ for base in thing.__bases__ if base.__name__ != "pybind11_object"]
    lines = [f"class {name}({', '.join(bases) or 'metaclass=_class'}):"]
    line = first_line(thing)
    if line.startswith("("):
        arguments = line[1:-1]
        lines.append(f"    def __init__(self{', ' if arguments else ''}{arguments}) -> None: ...")
    else:  # it is returned, or a base
        lines.append("    def __init__(self, /, *args: NoReturn, **kwargs: NoReturn) -> None: ...")
    for member, value in sorted(vars(thing).items()):
        if isinstance(value, property):
            lines.append("    " + of_property(member, value))
        elif member == "__eq__":
            lines.append("    def __eq__(self, other: object) -> bool: ...")
        elif member == "__hash__" and value is None:
            lines.append("    __hash__: None  # type: ignore[assignment]")
        elif not member.startswith("__") or member in ("__call__", "__len__"):
            lines.append("    " + of_function(value))
    return "\n".join(lines)


def stub(module):
    """The text of the stub of a module."""
    parts = []
    for name, thing in vars(module).items():
        if name.startswith("_") and name != "__version__":
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
