"""Convex pieces that are in another thing where their own mesh is not.

A convex piece fills the hollows of what it stands for: the shelves of a bookcase, the seat of a sofa."""

import mujoco
import numpy as np
from scipy.spatial import ConvexHull

from physics.surface import BULGE, distance_to

MOST_OVERLAP = 0.001  # metres of two pieces at the start, else it is asked whose fault it is


def planes_of(model, data, geom):
    """Normals and offsets of a convex geom's sides, pointing out of it; and its corners."""
    turn, centre = data.geom_xmat[geom].reshape(3, 3), data.geom_xpos[geom]
    if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_PLANE:
        return np.array([[*turn[:, 2], -turn[:, 2] @ centre]]), None
    if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_BOX:
        corners = model.geom_size[geom] * np.array(np.meshgrid(*[[-1, 1]] * 3)).reshape(3, 8).T
    else:
        mesh = model.geom_dataid[geom]
        start = model.mesh_vertadr[mesh]
        corners = model.mesh_vert[start : start + model.mesh_vertnum[mesh]]
    corners = corners @ turn.T + centre
    return ConvexHull(corners).equations, corners


def enters(corners, planes):
    """Whether a triangle is anywhere deeper than MOST_OVERLAP under all of the planes."""
    off = corners @ planes[:, :3].T + planes[:, 3] + MOST_OVERLAP
    maybe = (off.min(1) < 0).all(1)
    for triangle in corners[maybe]:
        polygon = triangle
        for plane in planes:
            side = polygon @ plane[:3] + plane[3] + MOST_OVERLAP
            kept = []
            for k in range(len(polygon)):
                p, q, s, t = polygon[k - 1], polygon[k], side[k - 1], side[k]
                if s * t < 0:
                    kept.append(p + (q - p) * s / (s - t))
                if t <= 0:
                    kept.append(q)
            polygon = np.array(kept)
            if not kept:
                break
        if len(polygon):
            return True
    return False


def sticks_out(hull, triangles, planes):
    """Whether the surface of the hull is off its mesh somewhere under the planes."""
    sides = hull[ConvexHull(hull).simplices]
    random = np.random.default_rng(0)
    sizes = np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1)
    chosen = sides[random.choice(len(sides), 400, p=sizes / sizes.sum())]
    samples = np.einsum("sk,skx->sx", random.dirichlet([1, 1, 1], len(chosen)), chosen)
    inside = samples[(samples @ planes[:, :3].T + planes[:, 3] < -BULGE).all(1)]
    if not len(inside):
        return False
    low, high = inside.min(0) - BULGE, inside.max(0) + BULGE
    near = triangles[((triangles.min(1) < high) & (triangles.max(1) > low)).all(1)]
    return not len(near) or any(distance_to(p, *near.swapaxes(0, 1)) > BULGE for p in inside)


def bulges(model, data, meshes):
    """Pieces that are in another thing where their own mesh is not, by thing."""
    pairs = {(c.geom1, c.geom2) for c in data.contact if c.dist < -MOST_OVERLAP}
    sure, likely = {}, {}
    for pair in sorted(pairs):
        for geom, other in (pair, pair[::-1]):
            name, _, piece = model.geom(geom).name.rpartition("/")
            if name not in meshes or not piece.isdigit() or int(piece) in sure.get(name, ()):
                continue
            planes, corners = planes_of(model, data, other)
            points, faces = meshes[name]
            triangles = points[faces]
            near = triangles
            if corners is not None:
                near = near[((near.min(1) < corners.max(0)) & (near.max(1) > corners.min(0))).all(1)]
            if not enters(near, planes):
                sure.setdefault(name, set()).add(int(piece))
            elif not sure and sticks_out(planes_of(model, data, geom)[1], triangles, planes):
                likely.setdefault(name, set()).add(int(piece))
    return sure or likely
