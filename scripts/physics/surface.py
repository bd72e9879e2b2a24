"""The surface of a mesh itself: how far points are from it, and flat pieces that cover it."""

import math

import numpy as np
from scipy.spatial import ConvexHull, QhullError

BULGE = 0.0005  # metres from the mesh: what is farther is no part of it
SHEET = 0.001  # metres of thickness, under the surface
FLAT = 0.0005  # metres off the plane of a sheet


def distance_to(point, a, b, c):
    """Of a point to the nearest of the triangles."""
    ab, ac, ap = b - a, c - a, point - a
    normal = np.cross(ab, ac)
    area = np.einsum("ij,ij->i", normal, normal) + 1e-30
    v = np.einsum("ij,ij->i", np.cross(ap, ac), normal) / area
    w = np.einsum("ij,ij->i", np.cross(ab, ap), normal) / area
    above = np.abs(np.einsum("ij,ij->i", ap, normal)) / np.sqrt(area)
    best = np.where((v >= 0) & (w >= 0) & (v + w <= 1), above, np.inf).min()
    for p, q in ((a, b), (b, c), (c, a)):
        edge = q - p
        t = np.einsum("ij,ij->i", point - p, edge) / (np.einsum("ij,ij->i", edge, edge) + 1e-30)
        foot = p + np.clip(t, 0, 1)[:, None] * edge
        best = min(best, np.sqrt(((point - foot) ** 2).sum(1).min()))
    return float(best)


def sheets(points, faces):
    """Convex flat pieces that cover the triangles and lie SHEET under them, as arrays of points."""
    low, high = points.min(0), points.max(0)
    corners = points[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(normals, axis=1) / 2
    real = areas > 1e-9
    corners, normals, areas = corners[real], normals[real], areas[real]
    centres = corners.mean(1)
    found, stack = [], [np.arange(len(corners))] if len(corners) else []
    while stack:
        part = stack.pop()
        up = normals[part].sum(0)
        up /= np.linalg.norm(up) + 1e-30
        own = corners[part].reshape(-1, 3)
        if len(part) > 1:
            off = own @ up
            slope = normals[part] @ up / (2 * areas[part])
            fits = np.ptp(off) <= FLAT and slope.min() > 0.8
            if fits:
                side = np.cross(up, [1, 0, 0] if abs(up[0]) < 0.7 else [0, 1, 0])
                side /= np.linalg.norm(side)
                flat = np.stack([own @ side, own @ np.cross(up, side)], axis=1)
                try:
                    fits = ConvexHull(flat).volume <= 1.01 * (areas[part] * slope).sum() + 4e-6
                except QhullError:
                    fits = False
            if not fits:
                axis = np.ptp(centres[part], axis=0).argmax()
                order = part[np.argsort(centres[part, axis], kind="stable")]
                stack += [order[: len(order) // 2], order[len(order) // 2 :]]
                continue
        own = np.unique(np.round(own, 6), axis=0)
        spread = np.linalg.svd(own - own.mean(0), compute_uv=False)[1] / math.sqrt(len(own))
        if spread > 1e-4:
            under = own - SHEET * up
            # Nothing of a thing is outside its box, whichever way its triangles turn.
            if (under < low - BULGE).any() or (under > high + BULGE).any():
                under = own + SHEET * up
            found.append(np.vstack([own, under]))
    return found
