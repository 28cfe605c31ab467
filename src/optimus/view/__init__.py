"""The live viewer: scenes, plans, grasps, episodes and policies in a browser, over viser."""

from optimus.view.server import Address, View, open_view

__all__ = ["Address", "View", "open_view"]
