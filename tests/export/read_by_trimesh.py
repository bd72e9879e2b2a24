"""trimesh reads what the exporter writes, and finds every thing by its id: read_by_trimesh.py WRITER FOLDER

WRITER writes GLB files into the folder that is its argument. Exit 77 (skipped) without trimesh.
"""

import json
import struct
import subprocess
import sys
from pathlib import Path

try:
    import trimesh
except ImportError:
    sys.exit(77)


def ids_of(marks):
    return sorted(extras["id"] for extras in marks if "id" in extras and "shell" not in extras)


def written(file):
    data = file.read_bytes()
    gltf = json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])
    return [node.get("extras", {}) for node in gltf["nodes"]]


def read(file):
    scene = trimesh.load(file, force="scene")
    edges = scene.graph.transforms.edge_data.items()
    # A mesh of several materials hangs below its node once more for each of them.
    return [edge["metadata"] for (parent, _), edge in edges if parent == "world" and edge.get("metadata")]


writer, folder = sys.argv[1], Path(sys.argv[2])
folder.mkdir(parents=True, exist_ok=True)
subprocess.run([writer, folder], check=True)
most = 0
for path in sorted(folder.glob("*.glb")):
    wanted = ids_of(written(path))
    found = ids_of(read(path))
    assert found == wanted, f"{path}: {found} instead of {wanted}"
    most = max(most, len(found))
assert most >= 5, "none of the files has anything in it"
