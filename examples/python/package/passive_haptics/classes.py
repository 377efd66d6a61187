"""Classes of the entries of the catalogue, as text: python3 classes.py writes catalogue.py and _native.pyi next to itself and
the module _native, at the build."""

from __future__ import annotations

import importlib
import pathlib
from typing import Any

ABOUT = {
    "tendon_two_link": "The paper's device: two links, both brakes at the base, coupled by tendons.",
    "two_link": "Two links in a plane, a brake on each joint.",
    "xy_table": "Two orthogonal slides, a brake on each.",
    "five_bar": "Two legs that meet at the handle (pantograph).",
    "five_bar_with_four_brakes": "A five-bar with brakes on both base joints, their difference and their sum.",
    "delta": "Three arms that move a platform in space without turning it.",
    "direct_control": "The paper's direct control (7)-(12).",
    "saturated_direct_control": "Direct control with an alpha that scales torques already within the limits. Of several "
    "walls it gets the one with the largest force.",
    "velocity_direct_control": "The recommended law of a mechanism with inertia and a force sensor.",
    "on_off_control": "The whole approximated force or none, by a relay: the recommended law of other devices.",
    "no_direct_control": "The approximated force as it is, alpha = 1.",
    "half_space": "The wall behind a plane.",
    "ball": "A round wall, touched from outside or, hollow, from inside.",
    "box": "A rectangular wall.",
    "capsule": "A rounded bar.",
    "convex_polytope": "The common part of half-spaces: 2 to 4 faces in the plane, 4 to 8 in space.",
    "convex_polygon": "A convex polygon in the plane, of 3 to 8 corners [m], either way round.",
    "offset": "A shape with its surface moved this far [m] to the free side; a negative growth shrinks it.",
    "complement": "A shape with wall and free space swapped.",
    "viscous_field": "A resistance to all motion, F = -B v. No motion may be driven by the matrix.",
    "guide": "A resistance to what leaves a line or a plane; motion along it and back is free.",
    "detents": "Periodic positions along a direction that resist being left.",
    "rough_walls": "Friction on all walls that are touched, under the load with which the hand presses.",
    "end_stops": "Limits of the joints, which resist motion further out.",
    "coulomb": "Friction that follows its command with a lag.",
    "stribeck": "A coulomb_brake with more friction at rest.",
    "eddy_current": "Drag by eddy currents: no torque at rest.",
    "magnetorheological": "A magnetorheological brake, with saturation and hysteresis.",
    "presliding": "A coulomb_brake that turns elastically before it slips.",
    "following_hand": "A hand that presses on a wall and moves in direction (length > 0) from start [m], d numbers each.",
    "wall_following_parameters": "Timing and sensing of a wall-following experiment.",
}
HEAD = '''"""The entries of the library's catalogue as classes. Made by classes.py at the build."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal, Optional

from passive_haptics.arrays import Numbers, Rows
from passive_haptics.catalogue_values import brake_model, effect, hand, law, parameter_table, shape, shape_of_shape
from passive_haptics.devices import mechanism
'''
BASES = {"following_hand": "hand", "wall_following_parameters": "parameter_table"}
"""Base classes that are not named as the list."""
FIRST = {"hand": {"direction": "Numbers", "start": "Numbers"}, "shape_of_shape": {"shape": "shape"}}
"""Arguments in front of the parameters, by the base class."""


def type_of(field: dict[str, Any]) -> str:
    """The type of a parameter in a signature."""
    if field["type"] == "choice":
        words = ", ".join(f'"{word}"' for word in field["choices"].split(", "))
        return f"Literal[{words}]"
    return "Sequence[Mapping[str, Any]]" if field["type"] == "tables" else str(field["type"])


def literal(default: Any) -> str:
    """A default in a signature."""
    if isinstance(default, list):
        inner = ", ".join(map(literal, default))
        return f"({inner},)" if len(default) == 1 else f"({inner})"
    text = repr(default)
    return f'float("{text}")' if text in ("inf", "-inf", "nan") else text


def arguments(fields: list[dict[str, Any]], is_of_any_dimension: bool) -> list[str]:
    """The parameters of a signature; those without a default first are required."""
    parts: list[str] = []
    is_required = True
    for field in fields:
        is_vector = field["type"] in ("Numbers", "Rows")
        is_required = is_required and field["default"] is None
        if is_required:
            parts.append(f"{field['name']}: {type_of(field)}")
        elif field["default"] is None or field["type"] == "tables" or (is_vector and is_of_any_dimension):
            parts.append(f"{field['name']}: Optional[{type_of(field)}] = None")
        else:
            parts.append(f"{field['name']}: {type_of(field)} = {literal(field['default'])}")
    return parts


def documentation(fields: list[dict[str, Any]], indent: str = "    ") -> str:
    """The parameters as NumPy documents them."""
    if not fields:
        return ""
    lines = ["", "", f"{indent}Parameters", f"{indent}----------"]
    for field in fields:
        unit = f" [{field['unit']}]" if field["unit"] else ""
        kind = f"{{{field['choices']}}}" if field["type"] == "choice" else field["type"]
        default = f", default {field['default']}" if field["default"] is not None and field["type"] != "tables" else ""
        lines += [f"{indent}{field['name']} : {kind}{unit}{default}"]
        if field["type"] == "tables":
            names = ", ".join(f"{of['name']}" + (f" [{of['unit']}]" if of["unit"] else "") for of in field["fields"])
            lines += [f"{indent}    A list of dicts of {names}."]
        elif field["type"] not in ("choice", "bool"):
            lines += [f"{indent}    {field['expected'].capitalize()}."]
    return "\n".join(lines)


def class_text(native: Any, of_list: str, entry: str, about: str, dimensions: list[int]) -> tuple[str, str]:
    """The name of a class, and its text; "" of what only a device file has: chains by their numbers, meshes of files."""
    fields = native.fields(of_list, entry, (*dimensions, 0)[0])
    if "_chain_" in entry or any(field["type"] == "str" for field in fields):
        return entry, ""
    base = BASES.get(entry) or ("shape_of_shape" if entry in native.lists()["made_of_shapes"] else of_list)
    if all(field["type"] not in ("Numbers", "Rows", "tables") for field in fields):
        dimensions = []
    name, first = f"{entry}_brake" if of_list == "brake_model" else entry, FIRST.get(base, {})
    given = ["self", *(f"{key}: {kind}" for key, kind in first.items()), *arguments(fields, len(dimensions) > 1)]
    passed = [*first, "{" + ", ".join(f'"{field["name"]}": {field["name"]}' for field in fields) + "}"]
    return name, f'''

class {name}({base}):
    """{about}{documentation(fields)}
    """

    _name = "{entry}"
    _dimensions = {tuple(dimensions)}

    def __init__({", ".join(given)}) -> None:
        super().__init__({", ".join(passed)})
'''


def module_text(native: Any) -> str:
    """The module catalogue.py."""
    parts, names = [HEAD], []
    for of_list in ("mechanism", "law", "shape", "effect", "brake_model", "table"):
        for entry, dimensions in native.lists()[of_list].items():
            name, text = class_text(native, of_list, entry, ABOUT.get(entry, entry), dimensions)
            parts.append(text)
            names += [f'"{name}"'] if text else []
    return "".join(parts) + f"\n\n__all__ = [{', '.join(names)}]\n"


def added_mechanism(name: str, about: str, module: str) -> Any:
    """The class of a mechanism that a C++ module has added to the catalogue."""
    from passive_haptics import _native, catalogue

    scope = {**vars(catalogue), "__name__": module}
    exec(class_text(_native, "mechanism", name, about, [])[1], scope)
    return scope[name]


STUB = '''"""States and results, and what the package is made of. Made by classes.py at the build."""

from typing import Any, Optional

from passive_haptics.arrays import Array, Numbers
from passive_haptics.results import contact_report, display_class, power_class, status

__version__: str

def __getattr__(name: str) -> Any: ...
def lists() -> dict[str, Any]: ...
def text_of(name: str, value: int) -> str: ...
'''


def stub_text(native: Any) -> str:
    """The stub of the module _native."""
    parts = [STUB]
    for kind in (native.device_state, native.step_result):
        text = "\n".join("    " + line if line else "" for line in kind.__doc__.split("\n")).strip()
        parts.append(f'\nclass {kind.__name__}:\n    """{text}"""\n\n')
        if kind is native.device_state:
            given = "time: float, q: Numbers, qd: Numbers, hand_force: Optional[Numbers] = None"
            parts.append(f"    def __init__(self, {given}) -> None: ...\n")
        for name, of in vars(kind).items():
            if isinstance(of, property):
                of_type, _, about = (of.__doc__ or "Any: ").partition(": ")
                parts.append(f'    @property\n    def {name}(self) -> {of_type}:\n        """{about}"""\n')
    return "".join(parts)


if __name__ == "__main__":
    folder, module = pathlib.Path(__file__).parent, importlib.import_module("_native")
    (folder / "catalogue.py").write_text(module_text(module), encoding="utf-8")
    (folder / "_native.pyi").write_text(stub_text(module), encoding="utf-8")
