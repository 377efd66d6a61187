"""A line on stderr that says how far a long call is."""

from __future__ import annotations

import sys
import time

AFTER = 2.0
"""A call that takes longer shows its progress [s]."""
BETWEEN = 0.2
"""Between two updates of reach() [s]."""


class progress_line:
    """How many of so many things are completed, and how long the others will take, where it is wanted."""

    def __init__(self, total: int, of: str, wanted: bool | None = None) -> None:
        """wanted: None: where stderr is a terminal. of: what they are, such as "experiments"."""
        self._total, self._of, self._done = total, of, 0
        self._wanted = sys.stderr.isatty() if wanted is None else wanted
        self._start = time.monotonic()
        self._width, self._shown = 0, self._start

    def add(self, count: int) -> None:
        """So many more are completed."""
        self._done += count
        self.show()

    def reach(self, done: int) -> None:
        """So many are completed now; shows it a few times a second at most."""
        self._done = done
        if time.monotonic() - self._shown > BETWEEN:
            self.show()

    def __enter__(self) -> progress_line:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def show(self) -> None:
        """Prints the line where the call takes long enough."""
        self._shown = time.monotonic()
        passed = self._shown - self._start
        if not self._wanted or passed < AFTER:
            return
        text = f"{self._done} of {self._total} {self._of}"
        if self._done:
            text += f", {passed * (self._total - self._done) / self._done:.0f} s left"
        print("\r" + text.ljust(self._width), end="", file=sys.stderr, flush=True)
        self._width = len(text)

    def close(self) -> None:
        """Ends the line."""
        if self._width:
            print(file=sys.stderr)
