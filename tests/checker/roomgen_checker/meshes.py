"""The real bodies of a scene, read from its scene.glb, and whether two of them overlap.

The file is read here by hand: a library would rename nodes and merge primitives, and the names are
what ties a mesh to its object.
"""

import json
import struct
from functools import cached_property

import numpy as np

MOVE = 0.005
MAX_CONTACTS = 20000
INSIDE_SAMPLES = 16
COMPONENTS = {
    5120: np.int8,
    5121: np.uint8,
    5122: np.int16,
    5123: np.uint16,
    5125: np.uint32,
    5126: np.float32,
}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
TRIANGLES = 4


def to_z_up(points):
    """glTF is Y-up with the front at +Z; here Z is up and the front at -Y."""
    return np.column_stack([points[:, 0], -points[:, 2], points[:, 1]])


def quaternion_matrix(q):
    x, y, z, w = q
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def node_matrix(node):
    if "matrix" in node:
        return np.array(node["matrix"], dtype=float).reshape(4, 4).T
    m = np.eye(4)
    m[:3, :3] = quaternion_matrix(node.get("rotation", (0, 0, 0, 1))) * node.get("scale", (1, 1, 1))
    m[:3, 3] = node.get("translation", (0, 0, 0))
    return m


class Glb:
    """The triangles under the named nodes of a binary glTF file."""

    def __init__(self, data):
        magic, version, _ = struct.unpack_from("<4sII", data, 0)
        if magic != b"glTF" or version != 2:
            raise ValueError("not a binary glTF 2 file")
        chunks, offset = {}, 12
        while offset + 8 <= len(data):
            length, kind = struct.unpack_from("<I4s", data, offset)
            chunks.setdefault(kind, data[offset + 8 : offset + 8 + length])
            offset += 8 + length
        self.json = json.loads(chunks[b"JSON"])
        self.binary = chunks.get(b"BIN\0", b"")

    def accessor(self, index):
        a = self.json["accessors"][index]
        if "sparse" in a or "bufferView" not in a:
            raise ValueError("sparse accessors are not read")
        view, width = self.json["bufferViews"][a["bufferView"]], WIDTHS[a["type"]]
        kind = np.dtype(COMPONENTS[a["componentType"]]).newbyteorder("<")
        start = view.get("byteOffset", 0) + a.get("byteOffset", 0)
        stride = view.get("byteStride", width * kind.itemsize)
        values = np.ndarray((a["count"], width), kind, self.binary, start, (stride, kind.itemsize))
        if a.get("normalized"):
            return np.maximum(values.astype(float) / np.iinfo(kind).max, -1.0)
        return values

    def primitives(self, mesh):
        """(vertices, triangles) of every triangle list of a mesh."""
        for p in self.json["meshes"][mesh]["primitives"]:
            if p.get("mode", TRIANGLES) != TRIANGLES:
                continue
            points = self.accessor(p["attributes"]["POSITION"]).astype(float)
            indices = (
                self.accessor(p["indices"]).ravel().astype(np.int64)
                if "indices" in p
                else np.arange(len(points))
            )
            yield points, indices.reshape(-1, 3)

    def collect(self, index, transform, parts):
        """Adds everything at and below a node."""
        node = self.json["nodes"][index]
        transform = transform @ node_matrix(node)
        if "mesh" in node:
            for points, triangles in self.primitives(node["mesh"]):
                parts.append((points @ transform[:3, :3].T + transform[:3, 3], triangles))
        for child in node.get("children", []):
            self.collect(child, transform, parts)

    def named(self, wanted):
        """{name: (vertices, triangles)} in the scene's frame for the nodes with the wanted ids, or names."""
        found = {}

        def visit(index, transform):
            node = self.json["nodes"][index]
            extras = node.get("extras", {})
            name = ("" if "shell" in extras else extras.get("id") or node.get("name", "")).lower()
            if name in wanted and name not in found:
                parts = []
                self.collect(index, transform, parts)
                if parts:
                    found[name] = join(parts)
                return
            for child in node.get("children", []):
                visit(child, transform @ node_matrix(node))

        for root in self.json["scenes"][self.json.get("scene", 0)]["nodes"]:
            visit(root, np.eye(4))
        return found


def join(parts):
    """One mesh of several, turned to Z up."""
    offsets = np.cumsum([0] + [len(p) for p, _ in parts[:-1]])
    return (
        to_z_up(np.concatenate([p for p, _ in parts])),
        np.concatenate([t + o for (_, t), o in zip(parts, offsets)]),
    )


def area_centroid(points, triangles):
    corners = points[triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    if areas.sum() <= 0:
        return points.mean(axis=0)
    return (corners.mean(axis=1) * areas[:, None]).sum(axis=0) / areas.sum()


def winding_number(point, points, triangles):
    """How often a surface goes around a point: 0 outside, 1 within a closed one."""
    a, b, c = np.moveaxis(points[triangles] - point, 1, 0)
    la, lb, lc = (np.linalg.norm(v, axis=1) for v in (a, b, c))
    volume = np.einsum("ij,ij->i", a, np.cross(b, c))
    dots = [np.einsum("ij,ij->i", u, v) for u, v in ((a, b), (b, c), (c, a))]
    base = la * lb * lc + dots[0] * lc + dots[1] * la + dots[2] * lb
    return np.arctan2(volume, base).sum() / (2 * np.pi)


def contains(outer, inner):
    """Whether all of a mesh (sampled at its corners) lies within another."""
    points = inner[0]
    step = max(1, len(points) // INSIDE_SAMPLES)
    return all(abs(winding_number(p, *outer)) > 0.5 for p in points[::step])


class Bodies:
    """The meshes of one scene, with the overlap test of docs/constraints.md."""

    def __init__(self, meshes):
        self.meshes = {k.lower(): v for k, v in meshes.items()}
        self.models = {}

    @classmethod
    def load(cls, path, ids):
        with open(path, "rb") as file:
            return cls(Glb(file.read()).named({i.lower() for i in ids}))

    def __contains__(self, name):
        return name.lower() in self.meshes

    def __bool__(self):
        return bool(self.meshes)

    @cached_property
    def fcl(self):
        import fcl  # only scenes whose boxes overlap need it

        return fcl

    def model(self, name):
        if name not in self.models:
            points, triangles = self.meshes[name]
            model = self.fcl.BVHModel()
            model.beginModel(len(points), len(triangles))
            model.addSubModel(points, triangles)
            model.endModel()
            self.models[name] = model
        return self.models[name]

    def contacts(self, a, b, shift=(0.0, 0.0, 0.0), every=False):
        """The points where two meshes cross, the first one moved by `shift`."""
        fcl = self.fcl
        objects = (
            fcl.CollisionObject(self.model(a), fcl.Transform(np.asarray(shift, float))),
            fcl.CollisionObject(self.model(b), fcl.Transform()),
        )
        result = fcl.CollisionResult()
        count = MAX_CONTACTS if every else 1
        fcl.collide(*objects, fcl.CollisionRequest(num_max_contacts=count, enable_contact=True), result)
        return np.array([c.pos for c in result.contacts])

    def separable(self, a, b, middle):
        """Whether moving the first body 5 mm away from the contact parts the two."""
        away = area_centroid(*self.meshes[a]) - middle
        length = np.linalg.norm(away)
        return length > 0 and len(self.contacts(a, b, away / length * MOVE)) == 0

    def overlap(self, a, b):
        """Why the meshes overlap, or None. Either body may be the one that is moved."""
        a, b = a.lower(), b.lower()
        crossings = self.contacts(a, b, every=True)
        if len(crossings) == 0:
            for outer, inner in ((a, b), (b, a)):
                if contains(self.meshes[outer], self.meshes[inner]):
                    return f"the mesh of {inner} lies within that of {outer}"
            return None
        middle = crossings.mean(axis=0)
        if self.separable(a, b, middle) or self.separable(b, a, middle):
            return None
        x, y, z = middle
        return f"meshes cross near ({x:.2f}, {y:.2f}, {z:.2f})"

    def bounds_off(self, thing):
        """How far the mesh's bounds in the thing's own frame are from its box, in metres."""
        points = self.meshes[thing.id.lower()][0] - np.asarray(thing.position)
        c, s = np.cos(thing.yaw), np.sin(thing.yaw)
        local = np.column_stack(
            [c * points[:, 0] + s * points[:, 1], c * points[:, 1] - s * points[:, 0], points[:, 2]]
        )
        w, d, h = thing.size
        low, high = np.array([-w / 2, -d / 2, 0]), np.array([w / 2, d / 2, h])
        return float(max(np.abs(local.min(0) - low).max(), np.abs(local.max(0) - high).max()))
