"""The meshes of a GLB file."""

import json
import struct

import numpy as np


def read_glb(path):
    """Vertices and triangles of every node that has a mesh, in metres, Z up, by the node's id or name."""
    with open(path, "rb") as file:
        data = file.read()
    length = struct.unpack("<I", data[12:16])[0]
    gltf = json.loads(data[20 : 20 + length])
    binary = data[20 + length + 8 :]

    def accessor(index):
        a = gltf["accessors"][index]
        view = gltf["bufferViews"][a["bufferView"]]
        kind = {5126: np.float32, 5125: np.uint32, 5123: np.uint16, 5121: np.uint8}[a["componentType"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[a["type"]]
        start = view.get("byteOffset", 0) + a.get("byteOffset", 0)
        return np.frombuffer(binary, kind, a["count"] * width, start).reshape(a["count"], width)

    def matrix(node):
        if "matrix" in node:
            return np.array(node["matrix"], float).reshape(4, 4).T
        result = np.eye(4)
        x, y, z, w = node.get("rotation", [0, 0, 0, 1])
        result[:3, :3] = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
            ]
        ) @ np.diag(node.get("scale", [1, 1, 1]))
        result[:3, 3] = node.get("translation", [0, 0, 0])
        return result

    found = {}

    def visit(index, parent, name):
        node = gltf["nodes"][index]
        to_world = parent @ matrix(node)
        extras = node.get("extras", {})
        name = ("shell" not in extras and extras.get("id")) or node.get("name", name)
        if "mesh" in node:
            for part in gltf["meshes"][node["mesh"]]["primitives"]:
                points = accessor(part["attributes"]["POSITION"]).astype(float)
                points = points @ to_world[:3, :3].T + to_world[:3, 3]
                faces = accessor(part["indices"]).reshape(-1, 3).astype(np.int64)
                if np.linalg.det(to_world[:3, :3]) < 0:
                    faces = faces[:, ::-1]
                found.setdefault(name, []).append((points, faces))
        for child in node.get("children", []):
            visit(child, to_world, name)

    up = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], float)
    for root in gltf["scenes"][gltf.get("scene", 0)]["nodes"]:
        visit(root, up, "")
    meshes = {}
    for name, parts in found.items():
        start, points, faces = 0, [], []
        for p, f in parts:
            points.append(p)
            faces.append(f + start)
            start += len(p)
        meshes[name] = (np.vstack(points), np.vstack(faces))
    return meshes
