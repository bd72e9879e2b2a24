"""A model behind a real HTTP server writes a constraint program and revises it from the error report.

    composing.py ROOMGEN FOLDER
"""

import json
import shutil
import subprocess
import sys
import threading
from pathlib import Path

from chat_server import chat_server, pictures_of, text_of

ANSWERS = []    # of the model, in order
QUESTIONS = []  # as they came

KINDS = {name: kind for path in Path(__file__).parents[2].glob("data/kinds/*.json")
         for name, kind in json.loads(path.read_text())["kinds"].items()}


def play(question):
    QUESTIONS.append(question)
    return ANSWERS.pop(0)


def program(desks):
    return {"format": "roomgen-program", "version": 1, "room": {"type": "study", "width": 3.2, "depth": 2.8},
            "sets": {"desk": {"factory": "desk", "rel": [["on_floor", "room"], ["against_wall", "room"]]},
                     "chair": {"factory": "office_chair", "rel": [["on_floor", "room"], ["front_against", "desk"]]}},
            "constraints": {"desks": ["==", ["count", "desk"], desks], "chairs": ["==", ["count", "chair"], 2]},
            "scores": {}}


def is_a(kind, asked):
    return kind is not None and (kind == asked or is_a(KINDS.get(kind, {}).get("is"), asked))


def main():
    roomgen, folder = sys.argv[1], Path(sys.argv[2])
    server, url = chat_server(play, "composer-1")
    threading.Thread(target=server.serve_forever, daemon=True).start()
    shutil.rmtree(folder, ignore_errors=True)

    def compose(*answers, more=()):
        ANSWERS[:] = [a if isinstance(a, str) else json.dumps(a) for a in answers]
        QUESTIONS.clear()
        done = subprocess.run([roomgen, "compose", "a study for two", "-o", folder / "room", "--designer", "model", "--reader", "rules", "--model",
                               "composer-1", "--base-url", url, "--no-pictures", "--steps", "4000", "--force", *more],
                              capture_output=True, text=True)
        assert not ANSWERS, f"the model was asked {len(QUESTIONS)} times: {done.stderr}"
        return done

    # Python first, then a program that asks for too much, then a patch.
    record = folder / "record.jsonl"
    folder.mkdir(parents=True, exist_ok=True)
    answers = ["def build_constraints():\n    return cl.Problem()", {"reasoning": "two desks each", "program": program(9)},
               {"reasoning": "nine desks have no room", "patch": [{"op": "replace", "path": "/constraints/desks/2", "value": 2}]}]
    done = compose(*answers, more=("--record", record))
    assert done.returncode == 0, done.stderr
    assert len(QUESTIONS) == 3
    revision = QUESTIONS[2]["messages"][-1]
    assert "\"desks\" is missed by" in text_of(revision), text_of(revision)[-2000:]
    pictures = pictures_of(revision)
    assert len(pictures) == 1 and pictures[0][:2] == b"\xff\xd8", "the room was not shown"
    scene = json.loads((folder / "room/scene.json").read_text())
    kinds = [o["category"] for o in scene["objects"]]
    counts = [sum(is_a(kind, asked) for kind in kinds) for asked in ("office chair", "desk")]
    assert len(kinds) == 4 and counts == [2, 2], kinds
    rounds = json.loads((folder / "room/rounds.json").read_text())
    assert rounds["author"] == "model" and len(rounds["rounds"]) == 2 and rounds["chosen"] == 1
    assert rounds["rounds"][1]["patch"] == [{"op": "replace", "path": "/constraints/desks/2", "value": 2.0}], rounds["rounds"][1]["patch"]
    subprocess.run([roomgen, "check", folder / "room/scene.json"], check=True, stdout=subprocess.DEVNULL)

    # The same room from the recording, without the network.
    before = (folder / "room/scene.json").read_bytes()
    again = compose(more=("--replay", record))
    assert again.returncode == 0, again.stderr
    assert (folder / "room/scene.json").read_bytes() == before

    # A model that never answers a program: an error, and the older room stays.
    done = compose("no", "no", "no")
    assert done.returncode == 1, (done.returncode, done.stdout)
    assert (folder / "room/scene.json").read_bytes() == before
    server.shutdown()
    shutil.rmtree(folder)


if __name__ == "__main__":
    main()
