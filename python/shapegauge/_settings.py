# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings as the registries have them: defaults, and the part of docstrings that lists them."""

from __future__ import annotations

import json as _json
import textwrap as _textwrap
from typing import Any, Callable, Iterable, Mapping, Optional, TypeVar

from . import _native
from ._arguments import finite_number, whole_number
from ._native import InputError

Function = TypeVar("Function", bound=Callable[..., Any])

REGISTERED: Mapping[str, Any] = _json.loads(_native.settings())


def number_of(value: Any, name: str, setting: Mapping[str, Any]) -> Any:
    """Returns a number within the bounds of a setting: a whole one if its default is."""
    low, high = setting["bounds"]
    if isinstance(setting["default"], int):
        return whole_number(value, name, int(low), int(high))
    number = finite_number(value, name)
    if not low <= number <= high:
        raise InputError(f"{name} is {number}; it must be from {low} to {high}")
    return number


def settings_of(kind: str, name: str) -> dict[str, dict[str, Any]]:
    """The settings of an entry ("fields", "cone_sdf"), by name: meaning, values and default (None: required)."""
    return REGISTERED[kind][name]["settings"]


def listing(settings: Mapping[str, Mapping[str, Any]], defaults: Optional[Mapping[str, Any]] = None) -> str:
    """The settings as text, one after the other: name, meaning, legal values, default. defaults: instead of theirs."""
    lines: list[str] = []
    for name, setting in settings.items():
        default = (defaults or {}).get(name, setting["default"])
        shown = "required" if default is None else f"default: {_json.dumps(default)}"
        lines += _textwrap.wrap(f"{name}: {setting['meaning'].rstrip('.')} ({setting['values']}; {shown})", 112,
                                subsequent_indent="    ", break_on_hyphens=False)
    return "\n".join(lines)


def listing_of_all(kind: str) -> str:
    """All entries of a registry with their settings."""
    return "\n\n".join(
        "\n".join(filter(None, [f'"{name}": {entry["meaning"]}', _textwrap.indent(listing(entry["settings"]), "    ")]))
        for name, entry in REGISTERED[kind].items())


def with_settings(parts: Iterable[tuple[str, str]]) -> Callable[[Function], Function]:
    """Decorates a function: its docstring ends with the headings and texts."""

    def decorate(function: Function) -> Function:
        if function.__doc__:  # none under python -OO
            listed = "\n\n".join(f"{heading}:\n\n{_textwrap.indent(text, '    ')}" for heading, text in parts)
            function.__doc__ = f"{function.__doc__.rstrip()}\n\n{_textwrap.indent(listed, '    ')}\n    "
        return function

    return decorate
