# SPDX-License-Identifier: Apache-2.0
"""Reports as the program prints them with --json, with attributes and a form for notebooks."""

from __future__ import annotations

import html
from typing import Any


class Result(dict[str, Any]):
    """A report: the dictionary that the program prints with --json, whose keys, with their units,
    are attributes too. ``frame(key)`` is a list of rows, or columns, as a data frame of pandas.

    >>> knee = torquewright.actuator("specs/actuator/d151_knee.json")
    >>> knee.need(200.0, 9.1).reached
    True
    """

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(
                f"the report has no {name!r}; it has {', '.join(map(str, self))}"
            ) from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *map(str, self)]

    def frame(self, key: str | None = None) -> Any:
        """Rows under a key (or, without one, the report's own columns) as a pandas.DataFrame."""
        import pandas

        if key is not None:
            return pandas.DataFrame(self[key])
        columns = {name: of for name, of in self.items() if hasattr(of, "__len__")}
        columns = {name: of for name, of in columns.items() if not isinstance(of, (str, dict))}
        longest = max(map(len, columns.values()), default=0)
        return pandas.DataFrame({name: of for name, of in columns.items() if len(of) == longest})

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th>{html.escape(str(name))}</th><td>{html.escape(_short(value))}</td></tr>"
            for name, value in self.items()
            if name not in ("kind", "version", "provenance")
        )
        return f"<table>{rows}</table>"


def result_of(value: Any) -> Any:
    """Dictionaries as results, wherever they stand in a report."""
    if isinstance(value, dict):
        return Result({name: result_of(of) for name, of in value.items()})
    if isinstance(value, list):
        return [result_of(of) for of in value]
    return value


def _short(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if hasattr(value, "__len__") and not isinstance(value, (str, dict)) and len(value) > 8:
        return f"{len(value)} of them"
    return str(value)
