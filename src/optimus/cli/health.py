"""`doctor`: what works on this machine."""

from __future__ import annotations

import sys
from dataclasses import asdict

from optimus.cli.options import Json
from optimus.cli.output import say

MARKS = {"works": ("ok", "32"), "optional": ("--", "33"), "broken": ("!!", "31")}
"""Verdict -> its mark, and its colour on a terminal."""


def doctor(json: Json = False) -> None:
    """Try what this program needs of the machine, and say how to mend what does not; exit status 1 if something needed does not.

    Try:
        optimus doctor
        optimus doctor --json
    """
    from optimus.doctor import Finding, examine

    def line(finding: Finding) -> str:
        mark, colour = MARKS[finding.verdict]
        shown = f"\033[{colour}m{mark}\033[0m" if sys.stdout.isatty() else mark
        mend = f"\n{'':14}mend: {finding.mend}" if finding.verdict != "works" and finding.mend else ""
        return f"{shown} {finding.name:<10} {finding.says}{mend}"

    def at(part: str) -> None:
        if sys.stderr.isatty():
            sys.stderr.write(f"\r{part:<12}\r")

    findings = examine(at)
    broken = [f.name for f in findings if f.verdict == "broken"]
    verdict = f"broken: {', '.join(broken)}" if broken else "everything that is needed works"
    answer = {"works": not broken, "broken": broken, "findings": [asdict(f) for f in findings]}
    say(answer, json, "\n".join([*map(line, findings), verdict]))
    if broken:
        raise SystemExit(1)
