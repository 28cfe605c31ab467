"""`optimus doctor` on machines that really lack something: each lack is named, with its mend, and the exit status is 1."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from optimus.doctor import drawing

DOCTOR = (sys.executable, "-m", "optimus.cli", "doctor", "--json")


def examined(*before: str, **environment: str) -> tuple[int, dict[str, dict]]:
    """Exit status, and the findings by name; `before` is a command that runs the doctor."""
    done = subprocess.run([*before, *DOCTOR], capture_output=True, text=True, check=False, env={**os.environ, **environment})
    assert "Traceback" not in done.stderr, done.stderr
    answer = json.loads(done.stdout.splitlines()[-1])
    findings = {f["name"]: f for f in answer["findings"]}
    assert answer["broken"] == [name for name, f in findings.items() if f["verdict"] == "broken"]
    return done.returncode, findings


def test_a_machine_on_which_everything_works() -> None:
    status, findings = examined()
    assert status == 0
    assert findings["renderer"]["figures"]["frame_ms"]["median"] > 0
    assert findings["renderer"]["figures"]["colours"] > 100  # a picture, not a blank
    assert Path(findings["robot"]["says"].split(" in ")[1], "panda.xml").exists()
    assert findings["processor"]["figures"]["cores"] == len(os.sched_getaffinity(0))


def test_a_gl_library_that_there_is_not_and_a_missing_package(tmp_path: Path) -> None:
    """`MUJOCO_GL` names nonsense; and what is installed says it needs a package that nobody has."""
    folder = tmp_path / "optimus_tamp-9.dist-info"
    folder.mkdir()
    wanted = "Requires-Dist: no-such-package>=3\nRequires-Dist: numpy<1\nRequires-Dist: optional-thing; extra == 'dev'\n"
    (folder / "METADATA").write_text(f"Metadata-Version: 2.1\nName: optimus-tamp\nVersion: 9\n{wanted}")
    path = f"{tmp_path}{os.pathsep}{os.environ.get('PYTHONPATH', '')}"
    status, findings = examined(MUJOCO_GL="absent", PYTHONPATH=path)
    assert status == 1 and findings["renderer"]["verdict"] == "broken"
    assert "MUJOCO_GL=absent" in findings["renderer"]["says"]
    assert "unset MUJOCO_GL" in findings["renderer"]["mend"]
    assert findings["robot"]["verdict"] == "works"
    assert findings["packages"]["verdict"] == "broken"
    assert "no-such-package>=3" in findings["packages"]["mend"] and "numpy<1" in findings["packages"]["says"]
    assert "optional-thing" not in findings["packages"]["says"]


def test_a_renderer_that_hangs_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drawing, "SECONDS", 0.01)
    found = drawing.renderer(with_robot=False)
    assert found.verdict == "broken" and "no picture within" in found.says


def test_a_machine_without_the_robots_files_and_without_gl(tmp_path: Path) -> None:
    """An empty cache, and no network: the downloader finds no host, pip may ask no index. EGL without a single driver."""
    offline = {"PIP_NO_INDEX": "1", "PIP_FIND_LINKS": "", "https_proxy": "http://127.0.0.1:9", "HOME": str(tmp_path)}
    nowhere = {"OPTIMUS_CACHE": str(tmp_path / "cache"), "MENAGERIE_ROOT": str(tmp_path / "nothing")}
    status, findings = examined(**offline, **nowhere, MUJOCO_GL="egl", __EGL_VENDOR_LIBRARY_DIRS="/nonexistent")
    assert status == 1 and findings["robot"]["verdict"] == "broken"
    assert "franka_emika_panda" in findings["robot"]["says"] and "pip download" in findings["robot"]["says"]
    assert "MENAGERIE_ROOT" in findings["robot"]["mend"] and "panda.xml" in findings["robot"]["mend"]
    assert findings["renderer"]["verdict"] == "broken" and "apt-get install libegl1" in findings["renderer"]["mend"]


def test_other_verbs_send_to_the_doctor() -> None:
    command = [sys.executable, "-m", "optimus.cli", "show", "stack"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, "MUJOCO_GL": "absent"})
    assert done.returncode == 2 and "Traceback" not in done.stderr
    assert "MUJOCO_GL: absent" in done.stderr and "optimus doctor" in done.stderr


def test_without_a_robot_the_renderer_is_tried_with_a_plain_scene() -> None:
    found = drawing.renderer(with_robot=False)
    assert found.verdict == "works" and found.figures["colours"] > 2


def test_a_read_only_home(tmp_path: Path) -> None:
    """A file system that nobody can write to, not even root, as the home of a process."""
    script = f"mount -t tmpfs -o ro none {tmp_path} && exec "
    probe = subprocess.run(["unshare", "-rm", "sh", "-c", f"{script} true"], capture_output=True, check=False)
    inside: tuple[str, ...] = ("unshare", "-rm", "sh", "-c", f'{script} "$@"', "sh")
    if probe.returncode:
        if os.geteuid() == 0:
            pytest.skip("mount namespaces are not allowed here, and root may write everywhere")
        tmp_path.chmod(0o500)
        inside = ()
    cached = {"OPTIMUS_CACHE": "", "XDG_CACHE_HOME": "", "PIP_NO_INDEX": "1"}
    status, findings = examined(*inside, HOME=str(tmp_path), **cached)
    tmp_path.chmod(0o700)
    assert status == 1
    for name in ("cache", "home", "robot"):
        assert findings[name]["verdict"] == ("optional" if name == "home" else "broken"), findings[name]
        assert str(tmp_path) in findings[name]["says"] and "OPTIMUS_CACHE" in findings[name]["mend"]
    assert "Read-only file system" in findings["home"]["says"] or not inside
