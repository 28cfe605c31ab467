"""The report is one page that stands alone, says everything it was given, and nothing that it was not."""

import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Literal

import numpy as np
import pytest

from optimus.env import ManipulationEnv
from optimus.errors import StorageError
from optimus.filming import worth_filming
from optimus.report import (
    DatasetStats,
    EvaluationStats,
    ExpertStats,
    Film,
    ReportData,
    Starts,
    render,
    render_comparison,
    write_comparison,
    write_report,
)
from optimus.show import Film as Recorder
from optimus.show import png
from optimus.summary import films_in
from optimus.tasks import task

PNG = b"\x89PNG\r\n\x1a\n not really"
VOID = {"meta", "img", "br"}


class Outline(HTMLParser):
    """Checks that tags nest, collects section names, attributes and text."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.sections: list[str] = []
        self.sources: list[str] = []
        self.text = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        values = dict(attrs)
        if tag == "section":
            self.sections.append(values.get("id") or "")
        self.sources += [value for key, value in attrs if key in ("src", "href") and value]
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


@pytest.fixture
def full(tmp_path: Path) -> ReportData:
    video = tmp_path / "film.mp4"
    video.write_bytes(b"not really a film")
    metrics = [{"step": float(s), "loss": 1.0 / s, "labels_per_second": 100.0} for s in range(1, 40)]
    metrics[-1]["held_out_action_error_mm"] = 2.0
    return ReportData(
        title="stack: <b>bold</b> & true",
        task="stack",
        command="optimus run stack --out 'runs/<x>'",
        config={"seed": 0, "policy": {"note": "<script>alert(1)</script>"}},
        versions={"mujoco": "4.0.0"},
        expert=ExpertStats(100, 98, 99, (0.93, 0.994), {"median": 0.08, "max": 1.5}, {"no plan": 2}),
        dataset=DatasetStats(90, 9000, [90, 100, 110], {"pick, stack": 90}, {"too long": 3}, 81, 9),
        metrics=metrics,
        evaluations=[
            EvaluationStats(
                46, 50, (0.81, 0.97), failures={"dropped": 4}, rows=[{"seed": 7, "success": True}]
            )
        ],
        seconds={"collect": 130.0, "train": 700.0},
        films=[Film("seed 7", PNG, video, success=True), Film("seed 8: dropped", PNG, success=False, cause="dropped")],
        starts=[Starts("cubeA", [(0.5, 0.1), (0.62, -0.1)], [(0.4, 0.0)], [(0.4, 0.0)])],
        commands=["optimus view runs/x"],
    )


def parsed(page: str) -> Outline:
    outline = Outline()
    outline.feed(page)
    outline.close()
    assert not outline.open
    return outline


def test_page_has_all_sections_and_figures(full: ReportData) -> None:
    outline = parsed(render(full))
    assert outline.sections == [
        "result",
        "films",
        "failures",
        "training",
        "dataset",
        "starts",
        "expert",
        "time",
        "episodes",
        "settings",
    ]
    for said in (
        "46 of 50",
        "98 of 100",
        "81 to 97 %",
        "dropped",
        "too long",
        "80 ms",
        "1.50 s",
        "13 min 50 s",
    ):
        assert said in " ".join(outline.text.split()), said


def test_page_stands_alone(full: ReportData) -> None:
    page = render(full)
    assert not re.search(r"https?:|<script|<link|@import|url\(\s*[^#\s]", page)
    sources = parsed(page).sources
    assert sum(source.startswith("data:video/mp4;base64,") for source in sources) == 1
    assert sum(source.startswith("data:image/png;base64,") for source in sources) == 2
    assert all(source.startswith(("data:", "#")) for source in sources)


def test_curves_follow_the_page_colours_and_repeat_exactly(full: ReportData) -> None:
    page = render(full)
    assert page.count('aria-label="Training speed') == 1
    assert "var(--first)" in page
    assert "#01020" not in page
    assert page == render(full)


def test_text_is_escaped(full: ReportData) -> None:
    page = render(full)
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in page
    assert "stack: &lt;b&gt;bold&lt;/b&gt; &amp; true" in page
    assert "<b>bold" not in page


def test_parts_that_were_not_measured_are_left_out() -> None:
    outline = parsed(render(ReportData("stack", "stack", "optimus run stack")))
    assert outline.sections == []


def test_written_whole_or_not_at_all(full: ReportData, tmp_path: Path) -> None:
    path = tmp_path / "report.html"
    write_report(full, path)
    before = path.read_bytes()
    assert before.decode() == render(full)
    broken = ReportData("x", "x", "x", films=[Film("gone", tmp_path / "gone.png")])
    with pytest.raises(StorageError, match=r"cannot read .*gone\.png"):
        write_report(broken, path)
    assert path.read_bytes() == before
    with pytest.raises(StorageError, match="cannot write"):
        write_report(full, tmp_path / "nowhere" / "report.html")


def test_failures_stand_by_their_cause_with_their_films(full: ReportData) -> None:
    page = render(full)
    failures = page[page.index('id="failures"') : page.index('id="training"')]
    assert "dropped: 4 of 50 episodes" in failures and failures.count("<img") == 1
    films = page[page.index('id="films"') : page.index('id="failures"')]
    assert "seed 7" in films and "seed 8" not in films


def test_evaluations_under_other_conditions_stand_by_themselves(full: ReportData) -> None:
    pushed = replace(full.evaluations[0], successes=40, failures={"dropped": 10}, states="random", conditions="push+seed-1")
    film = Film("seed 9: dropped", PNG, success=False, cause="dropped", evaluation=pushed.label)
    page = render(replace(full, evaluations=[*full.evaluations, pushed], films=[film]))
    assert "Policy, validation states" in page and "Policy, random states, push, seed-1" in page
    first, second = page.index("dropped: 4 of 50 episodes"), page.index("dropped: 10 of 50 episodes")
    assert page.index("seed 9: dropped", first) > second
    beside = render_comparison({"a": replace(full, evaluations=[*full.evaluations, pushed])}, "")
    assert "a, random states, push, seed-1: 10 of 50 failed" in beside and "4 of 50 failed" in beside


def test_films_are_those_of_their_evaluation(tmp_path: Path) -> None:
    outcome = {"seed": 7, "success": False, "cause": "dropped", "variant": ""}
    for name in ("failure-000-7.mp4", "failure-000-7+push.mp4", ".tmp-failure-000-7.mp4", "success-000-7.mp4"):
        (tmp_path / name).touch()
    for how, name in (("", "failure-000-7.mp4"), ("push", "failure-000-7+push.mp4")):
        assert [film.video.name for film in films_in(tmp_path, {"outcomes": [outcome]}, how)] == [name]


def test_every_cause_gets_a_film() -> None:
    causes = ["a", "a", "", "a", "b", "", "c", "d"]
    outcomes = [{"success": not cause, "cause": cause} for cause in causes]
    assert worth_filming(outcomes, True, 1) == [2]
    assert worth_filming(outcomes, False, 3) == [0, 4, 6, 7]
    assert worth_filming(outcomes, False, 5) == [0, 4, 6, 7, 1]


def test_starts_are_drawn_to_scale(full: ReportData) -> None:
    """Dots are as far apart as the starts, in one scale for both axes, x up and y to the left."""
    dots = re.findall(r'class="learned" cx="([\d.]+)" cy="([\d.]+)"', render(full))
    (x0, y0), (x1, y1) = [(float(x), float(y)) for x, y in dots]
    scale = (x1 - x0) / 0.2
    assert scale > 0 and (y0 - y1) / 0.12 == pytest.approx(scale, rel=1e-2)


def test_several_runs_beside_one_another(full: ReportData) -> None:
    other = replace(full, config={"seed": 1, "policy": {"note": "<script>alert(1)</script>"}}, evaluations=[])
    text = render_comparison({"runs/a": full, "runs/<b>": other}, "optimus report runs/a runs/b")
    outline = parsed(text)
    assert outline.sections == ["result", "failures", "training", "differences", "effort"]
    differences = text[text.index('id="differences"') : text.index('id="effort"')]
    assert "seed" in differences and "policy.note" not in differences
    assert "runs/<b>" not in text and text.count("46</b> of 50") == 1


@pytest.fixture
def filmed(full: ReportData, tmp_path: Path) -> ReportData:
    """The same with a film and a strip that are real."""
    film = Recorder()
    for k in range(40):
        frame = np.full((240, 720, 3), 235, np.uint8)
        frame[100:140, 10 * k : 10 * k + 40] = (217, 130, 43)
        film.frames.append(frame)
    film.write(tmp_path / "real.mp4")
    strip = png(film.strip())
    shown = [Film("seed 7: success", strip, tmp_path / "real.mp4", True), Film("seed 8: dropped", strip, None, False, "dropped")]
    return replace(full, films=shown)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_browser_shows_it_without_complaint(filmed: ReportData, tmp_path: Path, scheme: Literal["light", "dark"]) -> None:
    browser = pytest.importorskip("browser")
    path = tmp_path / "report.html"
    write_report(filmed, path)
    with browser.page(1100, 800, scheme) as (opened, wrong):
        opened.goto(path.as_uri())
        brightness = opened.evaluate("getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)[0]")
        assert (brightness > 200) == (scheme == "light")
        opened.evaluate("document.querySelector('video').play()")
        opened.wait_for_function("document.querySelector('video').currentTime > 0.3")
        assert opened.evaluate("[...document.images].every(i => i.naturalWidth > 0)")
        opened.set_viewport_size({"width": 360, "height": 740})
        browser.requires_no_sideways_scrolling(opened)
        assert opened.pdf(format="A4").startswith(b"%PDF")
        assert wrong == []


def test_a_comparison_on_a_phone(full: ReportData, tmp_path: Path) -> None:
    browser = pytest.importorskip("browser")
    path = tmp_path / "comparison.html"
    write_comparison({"runs/a": full, "runs/b": replace(full, command="optimus run stack --seed 1")}, "optimus report", path)
    with browser.page(360, 740) as (opened, wrong):
        opened.goto(path.as_uri())
        browser.requires_no_sideways_scrolling(opened)
        assert wrong == []


def test_a_film_of_who_sees_nothing_shows_the_scene_alone() -> None:
    told, seeing = (ManipulationEnv(task("stack"), images=images, positions=not images) for images in (False, True))
    films = [Recorder(), Recorder()]
    for film, env in zip(films, (told, seeing), strict=True):
        env.reset(seed=3)
        film(env)
    (alone,), (both,) = (film.frames for film in films)
    assert alone.shape == (240, 240, 3) and both.shape[1] > 2 * 240
    assert np.array_equal(both[:, :240], alone)
    assert films[0].strip(1).shape == (240, 240, 3)
