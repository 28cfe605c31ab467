"""The report is one page that stands alone, says everything it was given, and nothing that it was not."""

import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from optimus.errors import StorageError
from optimus.report import (
    DatasetStats,
    EvaluationStats,
    ExpertStats,
    Film,
    ReportData,
    render,
    write_report,
)

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
        dataset=DatasetStats(90, 9000, [90, 100, 110], {"pick, stack": 90}, {"too long": 3}),
        metrics=metrics,
        evaluations=[
            EvaluationStats(
                46, 50, (0.81, 0.97), failures={"dropped": 4}, rows=[{"seed": 7, "success": True}]
            )
        ],
        seconds={"collect": 130.0, "train": 700.0},
        films=[Film("seed 7", PNG, video, success=True), Film("seed 8", PNG, success=False)],
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
        "training",
        "dataset",
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
