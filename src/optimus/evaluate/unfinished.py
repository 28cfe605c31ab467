"""What an evaluation has found so far, kept in a run's folder until its report is written: the same evaluation goes on from it."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from optimus.data.atomic import write_whole
from optimus.data.episode_file import start_digest
from optimus.evaluate.outcome import UNFINISHED, EvalReport, Outcome
from optimus.evaluate.start import Start


class Unfinished:
    """The outcomes of one evaluation, by index; those found by an earlier session of the same one are there from the beginning.

    The first line says what was asked, of which weights; then each outcome is a line, added as it comes.
    """

    def __init__(self, run: Path, asked: EvalReport, starts: Sequence[Start]) -> None:
        self.file = (run / asked.file_name).with_suffix(UNFINISHED)
        self.outcomes: dict[int, Outcome] = {}
        digests = ["" if s.state is None else start_digest(s.state) for s in starts]
        question = {**asked.question, "starts": [[s.seed, s.task, s.objects, d] for s, d in zip(starts, digests, strict=True)]}
        self._first_line = json.dumps(question)
        if not self._resume(len(starts)):
            write_whole(self.file, (self._first_line + "\n").encode())

    def _resume(self, count: int) -> bool:
        """Whether a file of the same evaluation is there; what it holds is taken."""
        lines = self.file.read_text(errors="replace").split("\n") if self.file.exists() else [""]
        if lines[0] != self._first_line:
            return False
        for line in lines[1:-1]:  # behind the last end of a line there may be a piece of one
            try:
                found: dict[str, Any] = json.loads(line)
                if (index := found.pop("index")) < count:
                    self.outcomes[index] = Outcome(**found)
            except (ValueError, KeyError, TypeError, AttributeError):  # damaged: that episode is played again
                continue
        kept = [self._first_line, *(self._line(i) for i in self.outcomes)]
        write_whole(self.file, "".join(line + "\n" for line in kept).encode())
        return True

    def _line(self, index: int) -> str:
        return json.dumps({"index": index, **asdict(self.outcomes[index])})

    def add(self, index: int, outcome: Outcome) -> None:
        """Keep what an episode came to."""
        self.outcomes[index] = outcome
        with self.file.open("a") as file:
            file.write(self._line(index) + "\n")
