"""One thing that was tried, and what came of it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

Verdict = Literal["works", "optional", "broken"]
"""`optional`: does not work, and nothing needs it unless the user does; `broken`: something needed is missing."""


@dataclass(frozen=True)
class Finding:
    """What was tried, how it went, and what to do where it did not go well."""

    name: str
    verdict: Verdict
    says: str
    mend: str = ""
    figures: dict[str, Any] = field(default_factory=dict)
    """The same in numbers, with their units in the keys; JSON-able."""
