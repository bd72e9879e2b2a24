#!/usr/bin/env python3
"""A model behind a real HTTP server designs a room as a whole, places it in one answer, looks at it and changes it.

    reviewing.py ROOMGEN OUT
"""

import json
import subprocess
import sys
from pathlib import Path

from chat_server import serving, text_of

WISH = "a study with a desk and two bookshelves"
ASKED = []
PLAN = {
    "concept": "Quiet.",
    "room": {"type": "study", "size_m": [4.0, 3.6], "height_m": 2.6,
             "materials": {"floor": "oak floor", "walls": [{"wall": None, "finish": "warm white", "lower": None}], "ceiling": "white"}},
    "openings": [{"kind": "door", "wall": "south", "at": 0.15, "width": 0.9}],
    "groups": [{"id": "work", "composition": "desk with chair", "with": [], "things": [{"part": "desk", "name": "desk", "description": "oak desk"}]}],
    "objects": [{"name": "bookshelf", "description": "oak bookshelf", "size_cm": [80, 30, 180], "quantity": 2, "place": "floor"}],
    "excluded": [],
}  # fmt: skip


def place(location, facing, constraints="edge"):
    return {"reasoning": "", "constraints": constraints, "location": location, "facing": facing}


SPOTS = {"desk-0": place([2.0, 3.2], 0), "bookshelf-0": place([0.2, 1.8], 90), "bookshelf-1": place([0.2, 2.7], 90)}
REVIEWS = [
    {"judgement": "too pale", "operations": [
        {"do": "cover", "part": "walls", "looks": "sage green"}, {"do": "remove", "objects": ["sofa-7"]},
        {"do": "light", "hour": 20, "level": "dim"},
        {"do": "remove", "objects": ["bookshelf-1"]}, {"do": "remove", "objects": ["bookshelf-0"]},
        {"do": "add", "category": "bookshelf", "description": "oak bookshelf", "count": 2},
        {"do": "add", "category": "side table", "as": "new table", "size": [0.5, 0.5, 0.55]},
        {"do": "put", "object": "new table", "position": [9, 9]},
        {"do": "add", "category": "vase", "relations": ["on, new table"]}]},
    {"judgement": "good", "operations": []},
]  # fmt: skip


def play(question):
    name = question["response_format"]["json_schema"]["name"]
    ASKED.append((name, text_of(question["messages"][-1])))
    if name == "plan":
        return json.dumps(PLAN)
    if name == "review":
        return json.dumps(REVIEWS[sum(asked == "review" for asked, _ in ASKED) - 1])
    asked = next(identifier for identifier in SPOTS if f"Now place {identifier}:" in ASKED[-1][1])
    others = [{"id": identifier, **spot} for identifier, spot in SPOTS.items() if identifier != asked]
    return json.dumps({**SPOTS[asked], "others": others})


def main():
    roomgen, folder = sys.argv[1], Path(sys.argv[2])
    with serving(play, "designer-1") as url:
        done = subprocess.run([roomgen, "generate", WISH, "-o", folder, "--force", "--designer", "model", "--model", "designer-1",
                               "--base-url", url, "--reader", "rules", "--choose", "off", "--pixels", "256"], capture_output=True, text=True)  # fmt: skip
    assert done.returncode == 0, done.stderr
    names = [name for name, _ in ASKED]
    assert names == ["plan", "placement", "review", "review"], names
    scene = json.loads((folder / "scene.json").read_text())
    at = {o["id"]: o["position"] for o in scene["objects"]}
    for identifier, spot in list(SPOTS.items())[:1]:
        off = max(abs(a - b) for a, b in zip(at[identifier], spot["location"]))
        assert off < 0.1, f"{identifier} stands {off} m from where it was put"
    assert "sage green" in json.dumps(scene["room"]["materials"]["walls"])
    assert "sofa-7" in ASKED[-1][1], "what could not be done is not told"
    table = next(o for o in scene["objects"] if o["category"] == "side table")
    assert max(abs(a - b) for a, b in zip(table["size"], [0.5, 0.5, 0.55])) < 0.03, table["size"]
    assert any(o["category"] == "vase" and o["on"] == table["id"] for o in scene["objects"]), "a new thing has no name"
    assert table["id"] in ASKED[-1][1] and "has changed" in ASKED[-1][1], "what was done is not told"
    assert scene["room"]["light"] == {"hour": 20, "level": 50}, scene["room"]["light"]
    verdicts = {r["clause"]: r["verdict"] for r in scene["requirements"] if "bookshel" in r["clause"]}
    assert set(verdicts.values()) == {"met"}, verdicts
    lines = [json.loads(line) for line in (folder / "trace.jsonl").read_text().splitlines()]
    rounds = [line for line in lines if "review" in line]
    assert [r["judgement"] for r in rounds] == ["too pale", "good"]
    assert any("sage green" in change for change in rounds[0]["changes"]) and len(rounds[0]["refused"]) == 2, rounds[0]
    assert "is where it was added, at" in rounds[0]["refused"][1], rounds[0]
    sources = [r["source"] for r in scene["requirements"] if "bookshel" in r["clause"]]
    assert set(sources) == {"prompt"}, "an exchange is asked for once more"


if __name__ == "__main__":
    main()
