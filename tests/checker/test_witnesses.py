"""Every problem of tests/data/rooms has a witness in which all holds that can hold."""

import unittest
from pathlib import Path

from roomgen_checker import files, report, schemas

DATA = Path(__file__).resolve().parent.parent / "data"
ROOMS = DATA / "rooms"
PROGRAMS = Path(__file__).resolve().parents[2] / "examples" / "programs"


class Witnesses(unittest.TestCase):
    def test_witnesses_are_valid_and_hold_what_the_index_says(self):
        categories = files.Categories.default()
        for entry in files.read_json(ROOMS / "witness" / "index.json"):
            with self.subTest(entry["name"]):
                problem = files.read_problem(files.read_json(ROOMS / f"{entry['name']}.json"))
                found = report.check_file(
                    ROOMS / "witness" / f"{entry['name']}.scene.json",
                    report.Options(categories, problem=problem),
                )
                self.assertEqual(found["violations"], [])
                self.assertEqual(found["objects"], entry["placeable"])
                self.assertEqual(found["constraints"]["held"], entry["constraints_holdable"])
                self.assertEqual(found["constraints"]["total"], entry["constraints"])

    def test_targets_come_before_their_dependants(self):
        for path in sorted(ROOMS.glob("*.json")):
            seen = set()
            for o in files.read_problem(files.read_json(path)).objects:
                for text in o["relations"]:
                    target = report.parse(text).target or "wall-0"
                    room_part = target.rpartition("-")[0] in ("wall", "door", "window")
                    self.assertTrue(room_part or target in seen, f"{path.name}: {o['id']}: {text}")
                seen.add(o["id"])


class Schemas(unittest.TestCase):
    def test_schemas_are_schemas(self):
        for path in schemas.DOCS.glob("*.schema.json"):
            schemas.validator(path.name.removesuffix(".schema.json")).check_schema(files.read_json(path))

    def test_files_fit_them(self):
        for path in sorted(ROOMS.glob("*.json")) + sorted((DATA / "solver-scenes").glob("*.json")):
            self.assertEqual(schemas.errors(files.read_json(path), "problem"), [], path.name)
        for path in sorted((ROOMS / "witness").glob("*.scene.json")):
            self.assertEqual(schemas.errors(files.read_json(path)), [], path.name)
        programs = sorted((DATA / "programs").glob("*.json")) + sorted(PROGRAMS.glob("*.json"))
        self.assertGreaterEqual(len(programs), 12)
        for path in programs:
            self.assertEqual(schemas.errors(files.read_json(path)), [], path.name)

    def test_wrong_programs_do_not(self):
        program = files.read_json(DATA / "programs" / "dining.json")
        for change in (
            {"version": 2},
            {"colour": 1},
            {"room": {}},
            {"sets": {"a": {"tag": ["bed"]}}},
            {"sets": {"a": {"rel": [["on"]]}}},
            {"params": {"p": {"uniform": [1]}}},
            {"constraints": {"a": ["cuont", "table"]}},
            {"constraints": {"a": ["in", ["count", "table"], 1]}},
            {"constraints": {"a": ["count", "table"]}},
            {"scores": {"a": ["all", "t", "table", ["==", 1, 1]]}},
            {"scores": {"a": ["dist", "table", "room", "walls"]}},
            {"scores": {"a": ["access", "table", "room", {"deep": 1}]}},
            {"relations": {"r": {"type": "touching", "child": ["top"], "parent": ["top"]}}},
        ):
            self.assertNotEqual(schemas.errors({**program, **change}), [], change)

    def test_wrong_files_do_not(self):
        room = {"polygon": [[0, 0], [1, 0], [1, 1]]}
        scene = {"format": "roomgen-scene", "version": 1, "room": room, "objects": []}
        thing = {"id": "bed-0", "category": "bed", "size": [1, 1, 1], "position": [0, 0, 0]}
        for change in (
            {"version": 2},
            {"colour": 1},
            {"objects": [{**thing, "size": [1, 1]}]},
            {"objects": [{**thing, "mount": "surface"}]},
            {"room": {"polygon": [[0, 0]]}},
            {"objects": [{**thing, "traits": ["soft"]}]},
            {"unplaced": [{"id": "a"}]},
        ):
            self.assertNotEqual(schemas.errors({**scene, **change}), [], change)
        self.assertEqual(schemas.errors({**scene, "objects": [thing]}), [])


if __name__ == "__main__":
    unittest.main()
