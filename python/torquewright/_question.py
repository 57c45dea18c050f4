# SPDX-License-Identifier: Apache-2.0
"""A command of the program, asked in this process: its answer is what `--json` prints."""

from __future__ import annotations

import functools
import itertools
import json
import math
import operator
import os
import re
import tempfile
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, Optional

from . import _core
from ._arrays import write_table
from ._refusal import Fault, Refusal, refuse
from ._results import Result, result_of


#: A function that hears how far long work is, in the words that a terminal shows.
Progress = Optional[Callable[[str], object]]

_LONGEST_STEM = 60


class Question:
    """Gathers the words of a command; what is not in a file yet is written into a folder that is
    removed in the end, and does not show in answer or refusal."""

    def __init__(self, *command: str) -> None:
        self._command = list(command)
        self._arguments: list[str] = []
        self._options: list[str] = []
        self._keywords: dict[str, str] = {}
        self._progress: Progress = None
        self._folder = tempfile.TemporaryDirectory(prefix="torquewright_")

    def __enter__(self) -> Question:
        return self

    def __exit__(self, *_: object) -> None:
        self._folder.cleanup()

    def document(self, name: str, source: Any) -> str:
        """The file of a document that is given as a path or as a dictionary."""
        if isinstance(source, Mapping):
            file = self._file(name)
            file.write_text(_json_text(name, source), encoding="utf-8")
            return str(file)
        return path_word(name, source)

    def table(self, name: str, source: Any) -> str:
        """The file of a table that is given as a path or as columns: a mapping, a data frame."""
        if not hasattr(source, "keys"):
            return path_word(name, source)
        file = self._file(name)
        write_table(file, name, source)
        return str(file)

    def written_table(self, keyword: str, option: str) -> Path:
        """A file that the command is to write there, of the question's own."""
        file = self._file(keyword + ".csv")
        self.option(keyword, option, str(file))
        return file

    def argument(self, word: str) -> None:
        """One by its place. They stand before all options: some of those take every word behind."""
        self._arguments.append(word)

    def option(self, keyword: str, option: str, word: str) -> None:
        """As it is; the others below say what cannot be one."""
        self._keywords[option] = keyword
        self._options.append(f"{option}={word}")

    def text(self, keyword: str, option: str, value: Any) -> None:
        self._keywords[option] = keyword
        if value is None:
            return
        if not isinstance(value, (str, os.PathLike)):
            raise refuse(keyword, f"is {value!r}; must be a text")
        self._options.append(f"{option}={os.fspath(value)}")

    def number(self, keyword: str, option: str, value: Any) -> None:
        self._keywords[option] = keyword
        if value is not None:
            self._options.append(f"{option}={finite_number(keyword, value)!r}")

    def count(self, keyword: str, option: str, value: Any) -> None:
        self._keywords[option] = keyword
        if value is None:
            return
        try:
            self._options.append(f"{option}={operator.index(value)}")
        except TypeError:
            raise refuse(keyword, f"is {value!r}; must be a whole number") from None

    def texts(self, keyword: str, option: str, values: Iterable[str]) -> None:
        if isinstance(values, str):
            raise refuse(keyword, f"is the text {values!r}; must be a list of texts")
        for value in values:
            self.text(keyword, option, value)

    def flag(self, keyword: str, option: str, value: Any) -> None:
        self._keywords[option] = keyword
        if value not in (False, True):
            raise refuse(keyword, f"is {value!r}; must be True or False")
        if value:
            self._options.append(option)

    def progress(self, heard: Progress) -> None:
        """Who hears how far long work is."""
        if heard is not None and not callable(heard):
            raise refuse("progress", f"is {heard!r}; must be a function of a text")
        self._progress = heard

    def answer(self) -> Result:
        """What the program prints for this command with --json."""
        return result_of(json.loads(self.printed("--json")))

    def printed(self, *flags: str) -> str:
        words = [*self._command, *self._arguments, *self._options, *flags]
        run = functools.partial(_core.run, progress=self._progress)
        _, text = self._in_our_words(run, [os.fsencode(word) for word in words])
        return text.replace(json.dumps(self._folder.name + os.sep)[1:-1], "")

    def read(self, name: str, source: Any) -> dict[str, Any]:
        """A document as it is read."""
        file = os.fsencode(self.document(name, source))
        return json.loads(self._in_our_words(_core.read, file))

    def _file(self, name: str) -> Path:
        """A file of its own for each: other names may be alike in the characters of file names."""
        stem = re.sub(r"[^\w.-]", "_", name, flags=re.ASCII)[:_LONGEST_STEM]
        names = itertools.chain([stem], (f"{stem}_{i}" for i in itertools.count(2)))
        files = (Path(self._folder.name) / each for each in names)
        return next(file for file in files if not file.exists())

    def _in_our_words(self, work: Callable[[Any], Any], given: Any) -> Any:
        try:
            return work(given)
        except Refusal as refusal:
            raise Refusal([self._fault(*fault) for fault in refusal.faults]) from None

    def _fault(self, file: str, path: str, message: str) -> Fault:
        file, message = self._said(file), self._said(message)
        keyword, colon, rest = message.partition(": ")
        if file == "command line" and colon and keyword in self._keywords.values():
            return Fault(keyword, path, rest)
        return Fault(file.replace("command line", "arguments"), path, message)

    def _said(self, text: str) -> str:
        text = text.replace(self._folder.name + os.sep, "")
        for option in sorted(self._keywords, key=len, reverse=True):
            text = re.sub(re.escape(option) + r"(?![\w-])", self._keywords[option], text)
        return text.removesuffix("; --help shows what is allowed")


def finite_number(keyword: str, value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise refuse(keyword, f"is {value!r}; must be a number") from None
    if not math.isfinite(number):
        raise refuse(keyword, f"is {number}; must be finite")
    return number


def path_word(name: str, source: Any) -> str:
    """A path as a word of a command line, which no option begins like."""
    if not isinstance(source, (str, os.PathLike)):
        raise refuse(name, f"is a {type(source).__name__}; must be a path or a dictionary")
    path = os.fsdecode(source)
    return os.path.join(os.curdir, path) if path.startswith("-") else path


def _json_text(name: str, document: Mapping[str, Any]) -> str:
    try:
        return json.dumps(_as_read(name, document))
    except Refusal:
        raise
    except (TypeError, ValueError, RecursionError) as error:
        raise refuse(name, f"is no document: {error}") from None


def _as_read(name: str, value: Any, pointer: str = "", key: str = "") -> Any:
    """A document as a file of this folder would hold it: NumPy's numbers and arrays as Python's,
    and absolute the files that it names relative to where it stands, which is here."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {
            str(inner): _as_read(name, value[inner], f"{pointer}/{_escaped(inner)}", str(inner))
            for inner in value
        }
    if isinstance(value, (list, tuple)):
        return [_as_read(name, one, f"{pointer}/{i}", key) for i, one in enumerate(value)]
    if isinstance(value, float) and not math.isfinite(value):
        raise Refusal([(name, pointer, f"is {value}; must be finite")])
    if isinstance(value, str) and key in ("file", "strength", "actuators"):
        return os.path.abspath(value)
    return value


def _escaped(key: Any) -> str:
    return str(key).replace("~", "~0").replace("/", "~1")
