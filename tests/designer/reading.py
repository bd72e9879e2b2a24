#!/usr/bin/env python3
"""A model behind a real HTTP server reads wishes; what it and what rules read has the form of docs/brief.schema.json.

    reading.py ROOMGEN
"""

import json
import subprocess
import sys
import threading
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "checker"))

from chat_server import chat_server, text_of  # noqa: E402
from roomgen_checker import schemas  # noqa: E402

WISH = "Ein Arbeitszimmer mit zwei roten Stühlen am Tisch, bitte."
QUESTIONS = []


def thing(name, count, words, **more):
    usual = {"most": 0, "bound": "exact", "count_words": [], "looks": [], "parts": [], "sizes": [], "owner": "", "some_of": "",
             "mount": {"on": "", "words": []}, "formation": None, "relations": []}
    return {"id": name, "name": name, "count": count, "words": words} | usual | more


FORM = {
    "room": {"type": "study", "words": ["Arbeitszimmer"], "clauses": []},
    "openings": [], "finishes": [], "styles": [], "palette": [], "people": {"count": 0, "seats": 0, "words": []},
    "things": [
        thing("chair", 2, ["Stühlen"], count_words=["zwei"], looks=[{"look": "red", "words": ["roten"]}],
              relations=[{"relation": "around", "to": "table", "m": 0, "bound": "exact", "denied": False, "each": 0, "words": ["am Tisch"]}]),
        thing("table", 1, ["Tisch"])],
    "absences": [], "limits": [], "remarks": [], "talk": [{"as": "talk", "words": ["Ein", "mit", "bitte"]}], "rooms": [],
}  # fmt: skip


def play(question):
    QUESTIONS.append(question)
    return json.dumps(FORM)


def main():
    roomgen = sys.argv[1]
    assert not schemas.errors(FORM, "brief"), schemas.errors(FORM, "brief")
    server, url = chat_server(play, "reader-1")
    threading.Thread(target=server.serve_forever, daemon=True).start()

    def plan(*arguments, model=True):
        more = ["--reader", "model", "--model", "reader-1", "--base-url", url] if model else []
        done = subprocess.run([roomgen, *arguments, *more], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return done.stdout

    explained = plan("plan", "--explain", WISH)
    assert len(QUESTIONS) == 1 and WISH in text_of(QUESTIONS[0]["messages"][-1])
    assert QUESTIONS[0]["response_format"]["json_schema"].get("strict"), "the form is no strict schema"
    for line in ("[roten] attribute: red chair", "[zwei] count: 2 chair", "[Tisch] thing: a table"):
        assert line in explained, explained
    assert "not understood" not in explained, explained
    for forms in (plan("--json", "plan", "--explain", WISH),
                  plan("--json", "plan", "--explain", "two red chairs at a desk 1.6 m wide, a lamp on it, no rug", model=False),
                  plan("--json", "plan", "--explain", "a flat: a bedroom with an en-suite bathroom, a kitchen with four stools", model=False)):  # fmt: skip
        found = schemas.errors(json.loads(forms), "brief")
        assert not found, found
    server.shutdown()


if __name__ == "__main__":
    main()
