"""What pages are put together from: the document, sections, figures, numbers and tables."""

import base64
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from importlib import resources
from pathlib import Path
from typing import Any

from optimus.errors import StorageError
from optimus.report.data import Film


def document(title: str, parts: Sequence[str]) -> str:
    """A whole page with its style, of those parts that are not empty."""
    style = (resources.files("optimus.report") / "style.css").read_text(encoding="utf-8")
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>\n{style}</style>\n</head>\n<body>\n<main>\n"
        + "\n".join(part for part in parts if part)
        + "\n</main>\n</body>\n</html>\n"
    )


def section(name: str, title: str, body: str, lead: str = "") -> str:
    """A part of a page with its heading."""
    lead = f"<p>{escape(lead)}</p>" if lead else ""
    return f'<section id="{name}"><h2>{escape(title)}</h2>{lead}{body}</section>'


def figure(film: Film, inside: str) -> str:
    """A film or picture with its caption."""
    kind = "" if film.success is None else ' class="success"' if film.success else ' class="failure"'
    return f"<figure>{inside}<figcaption{kind}>{escape(film.caption)}</figcaption></figure>"


def video(path: Path) -> str:
    """A film within the page, which plays by itself: at rest, browsers lay their controls over most of a film as flat as these."""
    source = _uri(path, "video/mp4")
    return f'<video controls autoplay muted loop playsinline src="{source}"></video>'


def picture(source: Path | bytes, caption: str) -> str:
    """A PNG within the page."""
    return f'<img alt="{escape(caption, quote=True)}" src="{_uri(source, "image/png")}">'


def _uri(source: Path | bytes, kind: str) -> str:
    try:
        content = source if isinstance(source, bytes) else source.read_bytes()
    except OSError as error:
        raise StorageError(f"cannot read {source}: {error.strerror or error}") from error
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def numbers(values: Mapping[str, str]) -> str:
    """Large figures, each under what it is."""
    cells = "".join(f"<div><dt>{escape(k)}</dt><dd>{escape(v)}</dd></div>" for k, v in values.items())
    return f'<dl class="numbers">{cells}</dl>'


def counts(title: str, found: Mapping[str, int], what: str) -> str:
    """A card with a table: how many episodes of each, most first."""
    ordered = sorted(found.items(), key=lambda item: -item[1])
    rows = table([what, "episodes"], [[name, count] for name, count in ordered], number=1)
    return f'<div class="card"><h3>{escape(title)}</h3>{rows}</div>'


def table(columns: Sequence[str], rows: Sequence[Sequence[Any]], number: int | None = None) -> str:
    """A table; the column of that index holds numbers."""

    def line(cells: Sequence[Any], tag: str) -> str:
        kinds = [' class="number"' if i == number else "" for i in range(len(cells))]
        pairs = zip(kinds, cells, strict=True)
        return f"<tr>{''.join(f'<{tag}{kind}>{escape(str(cell))}</{tag}>' for kind, cell in pairs)}</tr>"

    head = f"<thead>{line(columns, 'th')}</thead>" if columns else ""
    body = "".join(line(row, "td") for row in rows)
    return f'<div class="wide"><table>{head}<tbody>{body}</tbody></table></div>'


def flat(values: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Nested settings one a line, with dotted names."""
    for key, value in values.items():
        if isinstance(value, Mapping) and value:
            yield from flat(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", value
