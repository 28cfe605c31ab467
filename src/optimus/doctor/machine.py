"""Packages, cores, memory, GPU: what the machine brings along."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
from importlib import metadata

from optimus.doctor.finding import Finding
from optimus.workers import available_cores

DISTRIBUTION = "optimus-tamp"
TOLD = ("optimus-tamp", "mujoco", "torch", "numpy", "ompl", "gymnasium")
"""Versions that a report of a problem should name."""
EXTRAS = {"view": ("viser", "the live viewer, `optimus view`"), "arms": ("airo-models", "the model of `--robot ur5e`")}
"""Extra -> its package, and what it is for."""


def packages() -> Finding:
    """Whether every package that this one requires is installed, in a version that it can work with."""
    wrong = _unmet()
    versions = {name: version for name in TOLD if (version := _version(name))}
    figures = {"python": platform.python_version(), **versions}
    text = ", ".join(f"{name} {version}" for name, version in figures.items())
    if wrong:
        return Finding("packages", "broken", f"missing or of another version: {', '.join(wrong)}", _pip(*wrong), figures)
    return Finding("packages", "works", text, figures=figures)


def _unmet() -> list[str]:
    from packaging.requirements import Requirement  # comes with matplotlib

    try:
        wanted = [Requirement(text) for text in metadata.requires(DISTRIBUTION) or ()]
    except metadata.PackageNotFoundError:
        return [DISTRIBUTION]
    here = [r for r in wanted if r.marker is None or r.marker.evaluate({"extra": ""})]
    found = [(r, _version(r.name)) for r in here]
    return [f"{r.name}{r.specifier}" for r, version in found if version is None or not r.specifier.contains(version, True)]


def _version(name: str) -> str | None:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return None


def _pip(*requirements: str) -> str:
    return "pip install " + " ".join(f"'{r}'" for r in requirements)


def processor() -> Finding:
    """Cores that this process may use, and memory."""
    cores = available_cores()
    system = f"{platform.system()} {platform.machine()}"
    figures: dict[str, float | str] = {"cores": cores, "system": system}
    memory = ""
    if hasattr(os, "sysconf") and "SC_PHYS_PAGES" in os.sysconf_names:
        figures["memory_gb"] = round(os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 1e9, 1)
        memory = f", {figures['memory_gb']:g} GB of memory"
    return Finding("processor", "works", f"{cores} core{'s' * (cores > 1)}{memory}, {system}", figures=figures)


def gpu() -> Finding:
    """Whether PyTorch can compute on a GPU. Nothing needs one."""
    try:
        import torch  # seconds; only here, so that everything else is told without it
    except (ImportError, OSError) as error:
        return Finding("gpu", "broken", f"PyTorch cannot be loaded: {error}", _pip("torch>=2.6"))
    if torch.cuda.is_available():
        names = [torch.cuda.get_device_name(i) for i in range(torch.cuda.device_count())]
        return Finding("gpu", "works", f"{', '.join(names)}, CUDA {torch.version.cuda}", figures={"gpus": names})
    if _nvidia_gpu():
        mend = "install PyTorch's CUDA build, as its installation page says, and a driver that is new enough for it"
        return Finding("gpu", "optional", f"there is an NVIDIA GPU, but PyTorch {torch.__version__} cannot use it", mend)
    return Finding("gpu", "optional", "none: policies are trained on the processor")


def _nvidia_gpu() -> bool:
    if shutil.which("nvidia-smi") is None:
        return False
    done = subprocess.run(["nvidia-smi", "-L"], capture_output=True, text=True, check=False)
    return done.returncode == 0 and "GPU " in done.stdout


def films() -> Finding:
    """Whether films can be written: the encoder that imageio brings, or the system's."""
    import imageio_ffmpeg

    try:
        program = imageio_ffmpeg.get_ffmpeg_exe()
        first = subprocess.run([program, "-version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]
    except (RuntimeError, OSError, subprocess.CalledProcessError) as error:
        mend = "pip install --force-reinstall imageio-ffmpeg, or set IMAGEIO_FFMPEG_EXE to a program of yours"
        return Finding("films", "broken", f"no ffmpeg: {error}", mend)
    return Finding("films", "works", first.split(" Copyright")[0])


def extra(name: str) -> Finding:
    """Whether an optional part is installed."""
    package, what = EXTRAS[name]
    version = _version(package)
    if version is None:
        return Finding(name, "optional", f"{package} is not installed: no {what}", _pip(f"{DISTRIBUTION}[{name}]"))
    return Finding(name, "works", f"{package} {version}: {what}", figures={package: version})
