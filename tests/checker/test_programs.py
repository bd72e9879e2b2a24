"""The programs as they are called: files beside each other, exit codes, JSON."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from cases import thing
from test_rules import chair_mesh, placed, table_mesh, write_glb

HERE = Path(__file__).resolve().parent
TABLE = thing("table-0", 2.5, 2, (1.6, 0.9, 0.75))
CHAIR = thing("chair-0", 2.5, 2 - 0.45 - 0.25 + 0.3, (0.46, 0.5, 0.9), yaw=180)


def scene_json(*things):
    """A scene.json with a table and a chair tucked under it."""
    objects = [
        {
            "id": t.id,
            "category": t.category,
            "size": list(t.size),
            "position": list(t.position),
            "yaw_deg": 180 if t is CHAIR else 0,
            "relations": ["middle"],
        }
        for t in things
    ]
    return {
        "format": "roomgen-scene",
        "version": 1,
        "objects": objects,
        "room": {"type": "test", "polygon": [[0, 0], [5, 0], [5, 4], [0, 4]], "height": 2.7, "openings": []},
        "unplaced": [{"id": "sofa-0", "category": "sofa", "reason": "no room"}],
    }


class Programs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name) / "tucked"
        self.folder.mkdir()
        (self.folder / "scene.json").write_text(json.dumps(scene_json(TABLE, CHAIR)))

    def add_meshes(self):
        bodies = {"table-0": placed(table_mesh(), TABLE), "chair-0": placed(chair_mesh(), CHAIR)}
        (self.folder / "scene.glb").write_bytes(write_glb(bodies))

    def call(self, program, *args):
        done = subprocess.run(
            [sys.executable, HERE / program, *map(str, args)], capture_output=True, text=True, check=False
        )
        return done.returncode, done.stdout

    def test_boxes_decide_without_meshes_and_meshes_with_them(self):
        self.assertEqual(self.call("check_scene.py", self.folder)[0], 1)
        self.assertEqual(self.call("check_scene.py", self.folder, "--glb")[0], 2)
        self.add_meshes()
        self.assertEqual(self.call("check_scene.py", self.folder, "--glb", "--schema")[0], 0)
        self.assertEqual(self.call("check_scene.py", self.folder, "--no-glb")[0], 1)

    def test_json_counts_what_was_left_out(self):
        problem = self.folder / "problem.json"
        problem.write_text(
            json.dumps(
                {
                    "name": "tucked",
                    "room": [[0, 0], [5, 0], [5, 4], [0, 4]],
                    "objects": [
                        {"name": "Table-0", "size": [1.6, 0.9, 0.75], "constraints": "middle"},
                        {"name": "chair-0", "size": [0.46, 0.5, 0.9], "constraints": "middle"},
                        {"name": "sofa-0", "size": [2, 0.9], "constraints": "edge | near, table-0"},
                    ],
                }
            )
        )
        self.add_meshes()
        code, out = self.call("check_scene.py", self.folder, "--problem", problem, "--json")
        (found,) = json.loads(out)
        self.assertEqual((code, found["constraints"]["held"], found["constraints"]["total"]), (0, 2, 4))
        self.assertEqual(found["unplaced"], ["sofa-0"])

    def test_unreadable_file(self):
        self.assertEqual(self.call("check_scene.py", self.folder / "none.json")[0], 2)

    def test_metrics(self):
        code, out = self.call("room_metrics.py", self.folder, "--json", self.folder / "figures.json")
        self.assertEqual(code, 1)
        self.assertIn("1 scenes, 2 objects", out)
        figures = json.loads((self.folder / "figures.json").read_text())["summary"]
        self.assertEqual(figures["violations"], {"solid": 1})
        self.assertEqual(figures["unplaced_share"], 0.3333)


if __name__ == "__main__":
    unittest.main()
