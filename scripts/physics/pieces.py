"""Convex pieces of meshes, by CoACD where their hulls will not do."""

import hashlib
import math
import os

import coacd
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import ConvexHull, QhullError

MOST_SHELLS = 250  # of a mesh, the largest; leaves of plants beyond them carry nothing
MOST_INTRICATE = 4  # of them cut into convex pieces, others count as their hulls
CACHE = os.path.join(os.environ.get("XDG_CACHE_HOME", os.path.expanduser("~/.cache")), "roomgen", "convex")


def hull_of(points):
    """The hull's corners, and how deep the deepest point lies under it; sheets get a thickness of 1 mm."""
    points = np.unique(np.round(points, 6), axis=0)
    if len(points) < 3:
        return None
    centre = points.mean(0)
    _, spread, axes = np.linalg.svd(points - centre, full_matrices=False)
    if len(points) < 4 or spread[-1] / math.sqrt(len(points)) < 2e-4:
        points = np.vstack([points + 5e-4 * axes[-1], points - 5e-4 * axes[-1]])
    try:
        hull = ConvexHull(points)
    except (QhullError, ValueError):
        return None
    if hull.volume < 1e-9:
        return None
    equations = np.unique(np.round(hull.equations, 6), axis=0)
    depth = 0.0
    for start in range(0, len(points), 2000):
        under = -(points[start : start + 2000] @ equations[:, :3].T + equations[:, 3])
        depth = max(depth, float(under.min(1).max()))
    return points[hull.vertices], depth


def shells(points, faces):
    """The parts of a mesh that hang together, vertices at one place taken as one; the largest first."""
    _, same = np.unique(np.round(points, 5), axis=0, return_inverse=True)
    same = same.reshape(-1)
    joined = same[faces]
    rows = np.concatenate([joined[:, 0], joined[:, 1]])
    columns = np.concatenate([joined[:, 1], joined[:, 2]])
    count = int(same.max()) + 1
    graph = coo_matrix((np.ones(len(rows)), (rows, columns)), shape=(count, count))
    _, label = connected_components(graph, directed=False)
    of_face = label[joined[:, 0]]
    order = np.argsort(of_face, kind="stable")
    groups = np.split(faces[order], np.flatnonzero(np.diff(of_face[order])) + 1)
    return sorted(groups, key=lambda g: -np.prod(np.ptp(points[g.ravel()], axis=0) + 1e-3))


def decomposed(points, faces):
    used, index = np.unique(faces, return_inverse=True)
    parts = coacd.run_coacd(
        coacd.Mesh(points[used], index.reshape(-1, 3)), threshold=0.05, max_convex_hull=32,
        preprocess_mode="auto", preprocess_resolution=30, resolution=300, mcts_nodes=8,
        mcts_iterations=20, mcts_max_depth=2, seed=0)
    # Pieces are of a remeshed surface; they end where the mesh ends.
    low, high = points[used].min(0), points[used].max(0)
    return [np.clip(np.asarray(p, float), low, high) for p, _ in parts]


def convex_pieces(points, faces):
    """Arrays of points, one for each piece; kept between runs."""
    key = hashlib.sha256(np.round(points, 4).tobytes() + faces.tobytes()).hexdigest()[:24]
    path = os.path.join(CACHE, key + ".npz")
    if os.path.exists(path):
        with np.load(path) as file:
            return [file[name] for name in file.files]
    coacd.set_log_level("error")
    pieces, intricate = [], []
    for shell in shells(points, faces)[:MOST_SHELLS]:
        found = hull_of(points[np.unique(shell)])
        if found is None:
            continue
        size = np.linalg.norm(np.ptp(found[0], axis=0))
        if found[1] < max(0.002, 0.02 * size) or size < 0.04 or len(intricate) >= MOST_INTRICATE:
            pieces.append(found[0])
        else:
            intricate.append(shell)
    for shell in intricate:
        for piece in decomposed(points, shell):
            found = hull_of(piece)
            if found is not None:
                pieces.append(found[0])
    os.makedirs(CACHE, exist_ok=True)
    np.savez(path, *pieces)
    return pieces
