"""`objects`: what things there are to handle, and how a mesh becomes one."""

from __future__ import annotations

from functools import partial
from inspect import signature
from pathlib import Path
from typing import Annotated, Any, Literal

from tyro.conf import Positional, arg

from optimus.cli.options import Json, Workers
from optimus.cli.output import bar, say
from optimus.errors import AssetError, OptimusError

Verb = Annotated[Literal["list", "add", "acronym", "remove"], Positional, arg(help="what to do")]
Paths = Annotated[tuple[str, ...], Positional, arg(metavar="MESH|NAME", help="mesh files or folders of them; or names of objects")]


def objects(
    do: Verb = "list",
    what: Paths = (),
    out: Path | None = None,
    name: str | None = None,
    category: str = "own",
    mass: float | None = None,
    density: float | None = None,
    scale: float = 1.0,
    up: Literal["auto", "x", "y", "z"] = "auto",
    meshes: Path = Path(),
    workers: Workers = 0,
    json: Json = False,
) -> None:
    """List the objects; or add meshes of your own, each repaired, stood up, and its grasps tried in physics.

    Try:
        optimus objects --out sheet/
        optimus objects list mug bottle-1
        optimus objects add my-mug.glb --name my-mug --mass 0.2
        optimus objects add meshes/ --scale 0.001 --density 400
        optimus objects acronym grasps.h5 --meshes ShapeNetSem/
        optimus bench expert pick-place --objects my-mug

    Args:
        out: with list: a folder for a contact sheet (objects.png) and a page (objects.html)
        name: with add: of the object; by default the file's
        category: with add: of the objects
        mass: with add [kg]; by default from the density
        density: with add [kg/m^3]; by default 300, for things about the house are mostly hollow
        scale: with add: metres per unit of the file
        up: with add: which axis of the file points up; by default whichever it can stand on
        meshes: with acronym: the folder that the grasp files' meshes lie in
    """
    told = {"name": name, "category": category, "mass": mass, "density": density, "scale": scale, "up": up}
    usual = signature(objects).parameters
    if do in ("list", "remove") and (senseless := [f"--{name}" for name, said in told.items() if said != usual[name].default]):
        raise OptimusError(f"objects {do} takes no {', '.join(senseless)}: say it with add")
    if do == "list":
        _list(what, out, workers, json)
    elif do == "remove":
        _remove(what, json)
    else:
        from optimus.assets.importing import Wish

        _add(do, what, Wish(name, category, mass, density, scale, up), meshes, workers, json)


def _list(what: tuple[str, ...], out: Path | None, workers: int, json: bool) -> None:
    from optimus.assets import catalogue, sheet
    from optimus.data.atomic import make_folder
    from optimus.workers import available_cores

    keys = catalogue.keys_of(",".join(what)) if what else {n: n for n in (*catalogue.LIBRARY, *catalogue.added())}
    unmade = set(catalogue.missing())
    missing = [name for name in keys if name in unmade]
    if missing:
        with bar(len(missing), "make the library (once)", "object") as shown:
            catalogue.make_all(missing, workers or available_cores(), lambda: shown.update())
    rows = [catalogue.described(key) for key in keys.values()]
    answer: dict[str, Any] = {"objects": rows, "categories": len({row["category"] for row in rows})}
    if out is not None:
        make_folder(out)
        folders = [catalogue.folder_of(key) for key in keys.values()]
        sheet.contact_sheet(rows, folders, out / "objects.png")
        sheet.page(rows, folders, out / "objects.html")
        answer["pictures"] = [str(out / "objects.png"), str(out / "objects.html")]
    text = "\n".join([*map(_line, rows), f"{len(rows)} objects, {answer['categories']} categories", *answer.get("pictures", [])])
    say(answer, json, text)


def _line(row: dict[str, Any]) -> str:
    size = " x ".join(f"{100 * s:4.1f}" for s in row["size"])
    success = "" if row["success"] is None else f"  expert {row['success'][0]} of {row['success'][1]}"
    grasps = f"{row['grasps']:3} grasps ({row['grasps_from_above']} above, {row['grasps_from_the_side']} side)"
    return f"{row['name']:<15} {row['words']:<45} {size} cm {1000 * row['mass']:4.0f} g  {grasps}{success}"


def _add(do: str, what: tuple[str, ...], wish: Any, meshes: Path, workers: int, json: bool) -> None:
    from optimus.assets import catalogue, importing
    from optimus.workers import each_apart

    if not what:
        raise OptimusError(f"objects {do}: name at least one file or folder")
    paths = importing.meshes_in(map(Path, what)) if do == "add" else [Path(p) for p in what]
    if wish.name is not None and len(paths) > 1:
        raise OptimusError(f"--name is for one object, not for {len(paths)}")
    make = partial(importing.imported, wish=wish) if do == "add" else partial(importing.from_acronym, meshes=meshes, wish=wish)
    jobs = [partial(make, path) for path in paths]
    accepted, refused = [], {}
    with bar(len(paths), "add", "object") as shown:
        for path, made in zip(paths, each_apart(jobs, workers, importing.PATIENCE), strict=True):
            try:
                accepted.append(catalogue.add(importing.whole(made)))
            except AssetError as error:
                refused[str(path)] = str(error)
            shown.update()
    lines = [f"added   {name}" for name in accepted] + [f"refused {path}: {why}" for path, why in refused.items()]
    say({"added": accepted, "refused": refused}, json, "\n".join(lines))
    if not accepted:
        raise AssetError("nothing was added")


def _remove(what: tuple[str, ...], json: bool) -> None:
    from optimus.assets import catalogue

    if not what:
        raise OptimusError("objects remove: name at least one object of your own")
    for name in what:
        catalogue.remove(name)
    say({"removed": list(what)}, json, f"removed {', '.join(what)}")
