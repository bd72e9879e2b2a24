#!/usr/bin/env python3
"""A model behind a real HTTP server that answers old forms, choices that are on no sheet, half a place and reviews without end:
the room comes out as far as its answers go, each fault is told once with its place, and the calls are bounded.

    misbehaving.py ROOMGEN OUT
"""

import json
import subprocess
import sys
from pathlib import Path

from chat_server import serving, text_of

WISH = "a study with a desk, a bookshelf and two armchairs"
# The form before groups: no room, no openings, sizes in metres as words, colours that are none, a member nobody knows.
PLAN = {
    "objects": [
        {"name": "desk", "description": "oak desk", "size": "1.4 x 0.7 x 0.75 m", "quantity": 1},
        {"name": "bookshelf", "description": "bookshelf in the colour of yesterday", "quantity": "one"},
        {"name": "armchair", "description": "armchair", "quantity": 2, "karma": 7}, "what", {"quantity": -1}],
    "openings": [{"kind": "door", "wall": "south", "at": 0.5, "width": 0.9}, {"kind": "window", "wall": "south", "at": 0.5, "width": 1.2}],
    "groups": [{"id": "desk", "composition": "desk with chair and dragon", "with": ["wings"]}, {"composition": 7}],
}  # fmt: skip
CHOICES = {"choices": [
    {"item": "1", "take": "9z", "words": "", "size_cm": None, "paint": "", "why": ""},
    {"item": "99", "take": "1a", "words": "", "size_cm": None, "paint": "", "why": ""},
    {"item": "2", "take": "2a", "words": "", "size_cm": [-4, "wide", None], "paint": "the colour of yesterday", "why": ""}]}
ENDLESS = {"judgement": "not yet", "operations": [{"do": "cover", "part": "walls", "looks": "sage green"}, {"do": "levitate"}, 7]}
ASKED = []


def play(question):
    name = question["response_format"]["json_schema"]["name"]
    ASKED.append((name, text_of(question["messages"][-1])))
    if name == "placement":
        return json.dumps({"location": [2.0, 1.5], "others": [{"id": "armchair-0"}, {"id": "ghost-4", "location": [1, 1]}, None]})
    return json.dumps({"plan": PLAN, "choices": CHOICES}.get(name, ENDLESS))


def asked_again(name):
    return [text for asked, text in ASKED if asked == name and "cannot be used" in text]


def main():
    roomgen, out = sys.argv[1], Path(sys.argv[2])
    with serving(play, "careless-1") as url:
        done = subprocess.run([roomgen, "generate", WISH, "-o", out, "--force", "--designer", "model", "--model", "careless-1",
                               "--base-url", url, "--reader", "rules", "--make", "rules", "--pixels", "256"], capture_output=True, text=True)  # fmt: skip
    assert done.returncode == 0, done.stderr
    told = done.stdout + done.stderr
    names = [name for name, _ in ASKED]
    assert names.count("plan") <= 2 and names.count("choices") == 2 and names.count("review") == 2, names
    assert len(names) <= 20, names
    again = asked_again("choices")
    assert len(again) == 1, ASKED
    for place in ("/choices/0/take", "/choices/1/item", "nothing usable is said of item"):
        assert place in again[0], again[0]
    scene = json.loads((out / "scene.json").read_text())
    there = sorted(thing["category"] for thing in scene["objects"])
    assert there.count("armchair") == 2 and "desk" in there and "bookshelf" in there, (there, told)
    assert "levitate" in told, told
    checked = subprocess.run([roomgen, "check", str(out / "scene.json")], capture_output=True, text=True)
    assert checked.returncode == 0, checked.stdout + checked.stderr


if __name__ == "__main__":
    main()
