"""From a mesh to a thing that the expert can handle: convex pieces, rest, grasps that were tried in physics, a place on disk."""
