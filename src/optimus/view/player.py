"""`Player`: a time slider with a button to play, over moments that somebody else shows."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import viser

log = logging.getLogger(__name__)

PLAY, PAUSE = "play", "pause"


class Player:
    """Calls `show(index)` whenever the slider stands elsewhere: moved by hand, or by itself while it plays."""

    def __init__(self, server: viser.ViserServer, show: Callable[[int], None]) -> None:
        self._show, self._count, self._rate = show, 0, 20.0
        self.slider = server.gui.add_slider("time [s]", min=0.0, max=1.0, step=0.05, initial_value=0.0)
        self._button = server.gui.add_button(PLAY)
        self._playing, self._closed = threading.Event(), threading.Event()
        self.slider.on_update(lambda _: self._moved())
        self._button.on_click(lambda _: self.pause() if self._playing.is_set() else self.play())
        threading.Thread(target=self._run, daemon=True).start()

    def load(self, count: int, rate: float) -> None:
        """`count` moments, `rate` a second; the slider goes back to the first."""
        self.pause()
        self._count, self._rate = count, rate
        self.slider.max, self.slider.step = max(count - 1, 1) / rate, 1 / rate
        self.slider.value = 0.0
        self.slider.disabled = self._button.disabled = count < 2

    @property
    def index(self) -> int:
        """The moment at which the slider stands."""
        return min(max(self._count - 1, 0), round(self.slider.value * self._rate))

    def _moved(self) -> None:
        if self._count:
            self._show(self.index)

    def play(self) -> None:
        """Go on from where the slider stands; from the start if it is at the end."""
        if self.index >= self._count - 1:
            self.slider.value = 0.0
        self._button.label = PAUSE
        self._playing.set()

    def pause(self) -> None:
        """Stay where it is."""
        self._playing.clear()
        self._button.label = PLAY

    def close(self) -> None:
        """End the thread that plays."""
        self._closed.set()
        self._playing.set()

    def _run(self) -> None:
        while self._playing.wait() and not self._closed.is_set():
            began = time.perf_counter()
            if self.index >= self._count - 1:
                self.pause()
                continue
            try:
                self.slider.value = (self.index + 1) / self._rate  # calls `_moved`
            except Exception:
                log.exception("cannot show the moment at %.2f s", self.slider.value)
                self.pause()
            time.sleep(max(0.0, 1 / self._rate - (time.perf_counter() - began)))
