"""All objects at a glance: a contact sheet (PNG) and a page (HTML) with what is known of each."""

from __future__ import annotations

import base64
import html
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from PIL import Image, ImageDraw

from optimus.assets.picture import SIZE
from optimus.assets.store import PICTURE
from optimus.data.atomic import write_whole

COLUMNS, CAPTION = 9, 18
"""Of the contact sheet: pictures in a row, and pixels for the name below each."""
STYLE = """
:root { color-scheme: light dark; font: 15px/1.4 system-ui, sans-serif; }
body { margin: 1.5rem auto; max-width: 75rem; padding: 0 1rem; }
main { display: grid; gap: 0.8rem; grid-template-columns: repeat(auto-fill, minmax(9.5rem, 1fr)); }
figure { margin: 0; border: 1px solid #8884; border-radius: 8px; overflow: hidden; }
img { width: 100%; display: block; background: #f5f5f7; }
figcaption { padding: 0.4rem 0.6rem 0.6rem; } b { display: block; } small { opacity: 0.75; display: block; }
"""


def contact_sheet(rows: Sequence[dict[str, Any]], folders: Sequence[Path], path: Path) -> None:
    """Write every object's picture with its name below."""
    columns = min(COLUMNS, max(1, len(rows)))
    height = SIZE + CAPTION
    sheet = Image.new("RGB", (columns * SIZE, -(-len(rows) // columns) * height), "white")
    draw = ImageDraw.Draw(sheet)
    for i, (row, folder) in enumerate(zip(rows, folders, strict=True)):
        x, y = (i % columns) * SIZE, (i // columns) * height
        with Image.open(folder / PICTURE) as picture:
            sheet.paste(picture, (x, y))
        draw.text((x + SIZE / 2, y + SIZE + 2), row["name"], fill="black", anchor="ma")
    aside = path.with_name(f".{path.name}")
    sheet.save(aside, format="PNG", optimize=True)
    aside.replace(path)


def page(rows: Sequence[dict[str, Any]], folders: Sequence[Path], path: Path) -> None:
    """Write one self-contained page."""
    figures = "\n".join(_figure(row, folder) for row, folder in zip(rows, folders, strict=True))
    categories = len({row["category"] for row in rows})
    text = f"""<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Objects</title><style>{STYLE}</style><h1>{len(rows)} objects in {categories} categories</h1><main>
{figures}
</main></html>
"""
    write_whole(path, text.encode())


def _figure(row: dict[str, Any], folder: Path) -> str:
    data = base64.b64encode((folder / PICTURE).read_bytes()).decode()
    words, name = html.escape(row["words"]), html.escape(row["name"])
    size = " x ".join(f"{100 * s:.0f}" for s in row["size"])
    lines = [words, f"{size} cm, {1000 * row['mass']:.0f} g", f"{row['grasps']} grasps: {row['grasps_from_above']} from above, "]
    lines[-1] += f"{row['grasps_from_the_side']} from the side"
    if row.get("success"):
        lines.append(f"expert: {row['success'][0]} of {row['success'][1]}")
    small = "".join(f"<small>{line}</small>" for line in lines)
    return f'<figure><img alt="{words}" src="data:image/png;base64,{data}"><figcaption><b>{name}</b>{small}</figcaption></figure>'
