"""What a GLB is made of: its closed pieces, which of them make up a body, whether they hang together, how they are shaped."""

import itertools

import fcl
import numpy as np
import trimesh
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import ConvexHull

TOUCH = 0.003  # metres between two pieces that count as touching


def load(path):
    """The triangles of each material of a GLB, in the order of the file, in metres with Z up."""
    scene = trimesh.load(path, file_type="glb", process=False, force="scene")
    parts = []
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        geometry = scene.geometry[name]
        if not isinstance(geometry, trimesh.Trimesh) or not len(geometry.faces):
            continue
        triangles = trimesh.transform_points(geometry.vertices, matrix)[geometry.faces]
        parts.append(np.stack([triangles[..., 0], -triangles[..., 2], triangles[..., 1]], axis=-1))
    return parts


def weld(triangles):
    """Vertices and faces with one vertex for each place (a seam of normals or of texture is no hole), slivers left out."""
    points = triangles.reshape(-1, 3)
    _, first, index = np.unique(np.round(points * 1e6).astype(np.int64), axis=0, return_index=True, return_inverse=True)
    faces = index.reshape(-1, 3)
    whole = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    return points[first], faces, whole


def split(triangles):
    """The piece (0, 1, ...) of each triangle: triangles that share an edge are of one piece."""
    _, faces, whole = weld(triangles)
    edges = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, edge = np.unique(edges, axis=0, return_inverse=True)
    edge = edge.ravel()
    count = len(faces)
    owner = np.repeat(np.arange(count), 3)
    graph = coo_matrix((np.ones(3 * count), (owner, count + edge)), shape=(count + edge.max() + 1,) * 2)
    _, names = connected_components(graph, directed=False)
    _, names = np.unique(names[:count], return_inverse=True)
    return names.ravel()


class Piece:
    """Triangles that hang together."""

    def __init__(self, triangles):
        self.vertices, faces, whole = weld(triangles)
        self.triangles = len(faces)
        self.faces = faces[whole]
        self.low, self.high = self.vertices.min(axis=0), self.vertices.max(axis=0)
        self._fcl = None

    @property
    def watertight(self):
        """Every edge is run through as often one way as the other, and the inside is inside."""
        edges = self.faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
        sign = np.where(edges[:, 0] < edges[:, 1], 1, -1)
        _, edge = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True)
        return bool(len(edges)) and not np.any(np.bincount(edge.ravel(), weights=sign)) and self.mesh.volume > 0

    @property
    def mesh(self):
        return trimesh.Trimesh(self.vertices, self.faces, process=False)

    @property
    def fcl(self):
        if self._fcl is None:
            model = fcl.BVHModel()
            model.beginModel(len(self.vertices), len(self.faces))
            model.addSubModel(self.vertices, self.faces)
            model.endModel()
            self._fcl = fcl.CollisionObject(model)
        return self._fcl

    def touches(self, other):
        if np.any(self.low > other.high + TOUCH) or np.any(other.low > self.high + TOUCH):
            return False
        if fcl.collide(self.fcl, other.fcl, fcl.CollisionRequest(), fcl.CollisionResult()):
            return True
        if fcl.distance(self.fcl, other.fcl, fcl.DistanceRequest(), fcl.DistanceResult()) <= TOUCH:
            return True
        for outer, inner in ((self, other), (other, self)):  # one wholly inside the other
            if np.all(outer.low <= inner.low) and np.all(inner.high <= outer.high) and outer.watertight:
                return bool(outer.mesh.contains(inner.vertices[:1])[0])
        return False


def groups(pieces):
    """Groups of pieces that touch, the largest first."""
    parent = list(range(len(pieces)))

    def root(index):
        while parent[index] != index:
            parent[index] = parent[parent[index]]
            index = parent[index]
        return index

    low = np.array([piece.low for piece in pieces]) - TOUCH
    high = np.array([piece.high for piece in pieces])
    for first in range(len(pieces)):
        near = np.all((low[first] <= high[first + 1 :]) & (low[first + 1 :] <= high[first]), axis=1)
        for second in first + 1 + np.flatnonzero(near):
            if root(first) != root(second) and pieces[first].touches(pieces[second]):
                parent[root(second)] = root(first)
    found = {}
    for index in range(len(pieces)):
        found.setdefault(root(index), []).append(index)
    return sorted(found.values(), key=len, reverse=True)


def assign(parts, bodies):
    """The triangles of each body that the summary names, or None for one that is not in the model.

    A material's bodies follow each other in the file in the summary's order; `triangles` and `size` say where each ends.
    """
    starts = [0] * len(parts)
    found = []
    for body in bodies:
        count, size, match = body.get("triangles", 0), body.get("size"), None
        for index, part in enumerate(parts):
            run = part[starts[index] : starts[index] + count]
            if (
                count
                and len(run) == count
                and (size is None or np.allclose(np.ptp(run.reshape(-1, 3), axis=0), size, atol=0.003))
            ):
                starts[index] += count
                match = run
                break
        found.append(match)
    if all(match is not None for match in found):
        return found
    # Another order: whole pieces of the right number of triangles and size, each used once.
    free = [part[names == name] for part in parts for names in [split(part)] for name in range(names.max() + 1)]
    for index, body in enumerate(bodies):
        found[index] = None
        for at, piece in enumerate(free):
            extent = np.ptp(piece.reshape(-1, 3), axis=0)
            if len(piece) == body.get("triangles") and np.allclose(extent, body.get("size", extent), atol=0.003):
                found[index] = free.pop(at)
                break
    return found


# Shapes. Each test takes the triangles of a body (or of several that make up one part).


def outline(triangles):
    """The convex outline seen along the body's thin direction, or from above for a body that has none."""
    points = triangles.reshape(-1, 3)
    extent = np.ptp(points, axis=0)
    thin = int(np.argmin(extent))
    axis = thin if extent[thin] < 0.4 * np.median(extent) else 2
    flat = np.delete(points, axis, axis=1)
    return flat[ConvexHull(flat).vertices], axis


def area(polygon):
    x, y = polygon.T
    return 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def rectangle(polygon):
    """Sides of the smallest rectangle around a convex polygon, the longer first."""
    best = None
    for direction in np.roll(polygon, -1, axis=0) - polygon:
        length = np.hypot(*direction)
        if length < 1e-9:
            continue
        x, y = direction / length
        sides = sorted(np.ptp(polygon @ np.array([[x, -y], [y, x]]), axis=0), reverse=True)
        if best is None or sides[0] * sides[1] < best[0] * best[1]:
            best = sides
    return best


def corners(polygon, tolerance=0.04):
    """How many corners a convex outline has when roundings smaller than the tolerance (of its length) are left out."""
    points = list(polygon)
    limit = tolerance * rectangle(polygon)[0]
    while len(points) > 3:
        ring = np.array(points)
        before, after = np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0)
        along = after - before
        height = np.abs(along[:, 0] * (ring - before)[:, 1] - along[:, 1] * (ring - before)[:, 0]) / np.maximum(
            np.hypot(*along.T), 1e-9
        )
        least = int(np.argmin(height))
        if height[least] > limit:
            break
        del points[least]
    return len(points)


def measures(triangles):
    polygon, axis = outline(triangles)
    long, short = rectangle(polygon)
    edges = np.roll(polygon, -1, axis=0) - polygon
    return {
        "aspect": long / max(short, 1e-9),
        "fill": area(polygon) / max(long * short, 1e-12),
        "compact": 4 * np.pi * area(polygon) / max(np.hypot(*edges.T).sum() ** 2, 1e-12),
        "corners": corners(polygon),
        "polygon": polygon,
        "axis": axis,
    }


def hollow(triangles):
    """How much of the convex outline the body does not cover, seen the same way (0 for a convex outline)."""
    polygon, axis = outline(triangles)
    flat = np.delete(triangles, axis, axis=2)
    low, high = polygon.min(axis=0), polygon.max(axis=0)
    cells = 160
    step = (high - low).max() / cells
    x, y = (low + step * (np.indices((cells, cells)).reshape(2, -1).T + 0.5)).T
    covered = np.zeros(len(x), bool)
    for a, b, c in flat:
        turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if abs(turn) < 1e-12:
            continue
        inside = np.ones(len(x), bool)
        for p, q in ((a, b), (b, c), (c, a)):
            inside &= np.sign(turn) * ((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])) >= 0
        covered |= inside
    return max(0.0, 1 - covered.sum() * step * step / area(polygon))


def spine(triangles):
    """The long axis of a body: its direction, and in ten slices across it the centres, the mean radius near
    both ends, the length and the breadth.

    Points spread over the surface stand for it, so that it does not matter where the vertices are."""
    mesh = trimesh.Trimesh(**dict(zip(("vertices", "faces"), weld(triangles)[:2])), process=False)
    points, _ = trimesh.sample.sample_surface(mesh, 20000, seed=1)
    points = np.asarray(points)
    middle = points.mean(axis=0)
    _, _, axes = np.linalg.svd(points - middle, full_matrices=False)
    local = (points - middle) @ axes.T
    along = local[:, 0]
    bins = np.clip(((along - along.min()) / max(np.ptp(along), 1e-9) * 10).astype(int), 0, 9)
    centres = np.array([local[bins == b].mean(axis=0) for b in range(10) if np.any(bins == b)])
    breadth = np.ptp(local[:, 1])
    radii = [
        np.hypot(*(local[bins == b][:, 1:] - local[bins == b][:, 1:].mean(axis=0)).T).mean()
        for b in (1, 8)
        if np.any(bins == b)
    ]
    return axes[0], centres, radii, np.ptp(along), breadth


def is_round(triangles):
    m = measures(triangles)
    return m["compact"] > 0.955 and m["aspect"] < 1.1


def is_oval(triangles):
    m = measures(triangles)
    return m["aspect"] >= 1.1 and m["fill"] < 0.93 and len(m["polygon"]) >= 12 and m["corners"] > 4


def is_slanted(triangles):
    lean = np.degrees(np.arccos(min(1.0, abs(spine(triangles)[0][2]))))
    return 2.5 <= lean <= 87.5


def is_curved(triangles):
    _, centres, _, length, breadth = spine(triangles)
    ends = centres[-1] - centres[0]
    off = centres - centres[0]
    off -= np.outer(off @ ends / max(ends @ ends, 1e-12), ends)
    if length > 1.4 * breadth and np.linalg.norm(off, axis=1).max() > 0.03 * length:
        return True
    m, extent = measures(triangles), np.ptp(triangles.reshape(-1, 3), axis=0)
    if extent.min() < 0.4 * np.median(extent) and m["corners"] > 4 and len(m["polygon"]) >= 12 and m["fill"] < 0.86:
        return True  # a board with a curved edge
    mesh = Piece(triangles).mesh
    return mesh.convex_hull.volume > 1.2 * abs(mesh.volume)


def is_tapered(triangles):
    radii = spine(triangles)[2]
    return len(radii) == 2 and max(radii) > 1.12 * min(radii)


def widths(triangles):
    """Mean distance from the middle near the bottom and near the top, and whether it is round from above."""
    mesh = trimesh.Trimesh(**dict(zip(("vertices", "faces"), weld(triangles)[:2])), process=False)
    points = np.asarray(trimesh.sample.sample_surface(mesh, 8000, seed=1)[0])
    low, high = points[:, 2].min(), points[:, 2].max()
    height = (points[:, 2] - low) / max(high - low, 1e-9)
    middle = (points[:, :2].min(axis=0) + points[:, :2].max(axis=0)) / 2
    radius = np.hypot(*(points[:, :2] - middle).T)
    ends = [
        np.quantile(radius[(height > a) & (height < b)], 0.8) if np.any((height > a) & (height < b)) else 0
        for a, b in ((0.03, 0.2), (0.8, 0.97))
    ]
    plan = points[:, :2][ConvexHull(points[:, :2]).vertices]
    long, short = rectangle(plan)
    return ends, long / max(short, 1e-9) < 1.1 and 0.7 < area(plan) / (long * short) < 0.86


def is_conical(triangles):
    (bottom, top), plan = widths(triangles)
    return plan and max(bottom, top) > 1.2 * min(bottom, top)


def is_spherical(triangles):
    extent = np.ptp(triangles.reshape(-1, 3), axis=0)
    hull = Piece(triangles).mesh.convex_hull
    return extent.max() < 1.2 * extent.min() and 0.42 < hull.volume / extent.prod() < 0.62


def is_cylindrical(triangles):
    """A straight round body along whatever axis, measured by its convex hull: no ball, no cone, no bar with corners."""
    hull = Piece(triangles).mesh.convex_hull
    extent = sorted(np.asarray(hull.bounding_box_oriented.primitive.extents))
    pairs = [(extent[a] * extent[b], extent[a] / extent[b]) for a, b in itertools.combinations(range(3), 2)]
    return any(ratio > 0.9 for _, ratio in pairs) and 0.7 < hull.volume / np.prod(extent) < 0.84


def polygonal(count, least, most):
    """So many corners, and so much of its rectangle as such a polygon fills (a rounded square fills more)."""

    def test(triangles):
        m = measures(triangles)
        return m["corners"] == count and least < m["fill"] < most and m["compact"] < 0.955

    return test


SHAPES = {
    "round": is_round,
    "oval": is_oval,
    "square": lambda t: measures(t)["fill"] > 0.86 and measures(t)["aspect"] < 1.1,
    "rectangular": lambda t: measures(t)["fill"] > 0.86,
    "triangular": lambda t: measures(t)["corners"] == 3,
    "hexagonal": polygonal(6, 0.68, 0.82),
    "octagonal": polygonal(8, 0.76, 0.89),
    "l-shaped": lambda t: hollow(t) > 0.08,
    "kidney": lambda t: hollow(t) > 0.02 and len(measures(t)["polygon"]) >= 10,
    "slanted": is_slanted,
    "curved": is_curved,
    "tapered": is_tapered,
    "conical": is_conical,
    "spherical": is_spherical,
    "cylindrical": is_cylindrical,
}


def has_shape(shape, bodies):
    """Whether each body, or all of them taken together, has the shape."""
    test = SHAPES[shape]
    return all(test(body) for body in bodies) or (len(bodies) > 1 and bool(test(np.concatenate(bodies))))
