"""A real headless Chromium, where the machine has one: `page` opens pages in it and notes every complaint of theirs."""

from __future__ import annotations

import atexit
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Browser, ConsoleMessage, Page

sync_api = pytest.importorskip("playwright.sync_api", reason="pages are opened by playwright: pip install playwright")

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
WITHOUT_GPU = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
HARMLESS = ("THREE.Clock: This module has been deprecated",)

SCREENSHOTS = Path(os.environ["OPTIMUS_SCREENSHOTS"]) if "OPTIMUS_SCREENSHOTS" in os.environ else None
"""Where the pictures of the documentation go when the tests are asked to take them."""


Scheme = Literal["light", "dark"]


@lru_cache(maxsize=1)
def _browser() -> Browser:
    """One for all tests of a process."""
    playwright = sync_api.sync_playwright().start()
    atexit.register(playwright.stop)
    return playwright.chromium.launch(executable_path=CHROMIUM, args=WITHOUT_GPU)


@contextmanager
def page(width: int = 800, height: int = 480, scheme: Scheme = "light") -> Iterator[tuple[Page, list[str]]]:
    """A page of that size, and the list of what went wrong on it: script errors, warnings, requests that failed."""
    if CHROMIUM is None:
        pytest.skip("no Chromium here: apt-get install chromium")
    opened = _browser().new_page(viewport={"width": width, "height": height}, color_scheme=scheme)
    opened.set_default_timeout(90_000)
    wrong: list[str] = []

    def said(message: ConsoleMessage) -> None:
        if message.type in ("error", "warning") and not message.text.startswith(HARMLESS):
            wrong.append(message.text)

    opened.on("console", said)
    opened.on("pageerror", lambda error: wrong.append(str(error)))
    opened.on("requestfailed", lambda request: wrong.append(f"{request.url}: {request.failure}"))
    try:
        yield opened, wrong
    finally:
        opened.close()


def requires_no_sideways_scrolling(page: Page) -> None:
    """Nothing of the page is wider than the window."""
    inside, window = page.evaluate("[document.documentElement.scrollWidth, window.innerWidth]")
    assert inside <= window, f"{inside} px of page in a window of {window} px"


def keep(page: Page, name: str, full: bool = False) -> None:
    """A picture for the documentation, if they are wanted: large, without the viewer's word about software rendering."""
    if SCREENSHOTS is not None:
        page.add_style_tag(content=".mantine-Notifications-root { display: none }")
        if page.evaluate("window.innerWidth") > 500:
            page.set_viewport_size({"width": 960, "height": 600})
            page.wait_for_timeout(2500)
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
        page.screenshot(path=SCREENSHOTS / f"{name}.jpg", type="jpeg", quality=80, full_page=full)
