"""The form of designs (docs/design.schema.json), on the built-in ones and on ones with a mistake."""

import copy
import json
import unittest
from pathlib import Path

from roomgen_checker import schemas

ROOT = Path(__file__).resolve().parents[2]
SOUND = {
    "format": "roomgen-design", "version": 1, "name": "a study", "for": ["study"], "size_m": {"usual": ["3 + 0.2*people", 3]},
    "parameters": {"people": {"default": 2, "least": 1, "most": 4}},
    "room": {"type": "study", "palettes": [{"main": "white"}], "materials": {"walls": [{"wall": None, "finish": "{main}"}]}},
    "openings": [{"kind": "door", "wall": "south", "at": "1/W"}],
    "groups": [{"id": "desk", "stands": {"at": ["W/2", 1]}, "things": [
        {"part": "desk", "name": "desk", "size_cm": [140, 70, 75]},
        {"part": "chair", "name": "chair", "quantity": "people", "where": "in front of desk", "gap_m": -0.1}]}],
    "objects": [{"name": "bookshelf", "stands": {"corner": "north-west"}, "on_top": [{"name": "vase"}], "spare": 2}],
}


def with_value(value, *path):
    design = copy.deepcopy(SOUND)
    inner = design
    for step in path[:-1]:
        inner = inner[step]
    inner[path[-1]] = value
    return design


class Designs(unittest.TestCase):
    def test_built_in_ones_have_the_form(self):
        for path in sorted((ROOT / "data/designs").glob("*.json")):
            with self.subTest(path.name):
                self.assertEqual(schemas.errors(json.loads(path.read_text()), "design"), [])

    def test_mistakes_are_found(self):
        self.assertEqual(schemas.errors(SOUND), [])
        mistakes = [
            (3, "name"), ([], "for"), ("red", "colour"), ({"usual": [3]}, "size_m"), (-1, "parameters", "people", "least"),
            ("up", "openings", 0, "wall"), ({}, "groups", 0, "stands"), ("near", "groups", 0, "stands", "at"),
            ("north", "objects", 0, "stands", "corner"), ({"wall": "north", "at": [1, 1]}, "objects", 0, "stands"),
            ([1, 2], "groups", 0, "things", 0, "size_cm"), (None, "groups", 0, "things", 0, "wheels"), ("first", "objects", 0, "spare"),
        ]
        for value, *path in mistakes:
            with self.subTest(path=path):
                self.assertNotEqual(schemas.errors(with_value(value, *path)), [])


if __name__ == "__main__":
    unittest.main()
