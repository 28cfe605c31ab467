"""torchvision for a torch that it was not built with."""

# pyright: reportMissingImports=false
import sys

import torch


def import_torchvision() -> None:
    """Import it. A build for CUDA cannot load its operators beside a torch without; its Python then wants one of their names at
    least, which nothing here calls."""
    try:
        import torchvision
    except RuntimeError:
        for name in [n for n in sys.modules if n.partition(".")[0] == "torchvision"]:
            del sys.modules[name]
        library = torch.library.Library("torchvision", "FRAGMENT")
        library.define("nms(Tensor dets, Tensor scores, float iou_threshold) -> Tensor")
        _kept.append(library)
        import torchvision  # noqa: F401


_kept: list[object] = []
"""A library's operators go when it does."""
