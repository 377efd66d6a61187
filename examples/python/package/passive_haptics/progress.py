"""A progress line on stderr for long calls."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

AFTER = 2.0
"""A call that takes longer shows its progress [s]."""
BETWEEN = 0.2
"""Between two updates [s]."""


@contextmanager
def progress_line(total: int, of: str, wanted: bool | None = None) -> Iterator[Callable[[int], None]]:
    """A function that takes the number of completed things of this total, such as "experiments", and shows it
    with the time that the others will take. wanted: None: if stderr is a terminal."""
    is_wanted = sys.stderr.isatty() if wanted is None else wanted
    start, latest, width = time.monotonic(), 0.0, 0

    def reach(done: int) -> None:
        nonlocal latest, width
        now = time.monotonic()
        if not is_wanted or now - start < AFTER or (now - latest < BETWEEN and done < total):
            return
        text = f"{done} of {total} {of}"
        if done:
            text += f", {(now - start) * (total - done) / done:.0f} s left"
        print("\r" + text.ljust(width), end="", file=sys.stderr, flush=True)
        latest, width = now, len(text)

    try:
        yield reach
    finally:
        if width:
            print(file=sys.stderr)
