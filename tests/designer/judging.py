#!/usr/bin/env python3
"""A scripted judge behind a real HTTP server: rules make things, the model sees four pictures of each and gives points.

    judging.py ROOMGEN FOLDER
"""

import json
import subprocess
import sys
import threading
from pathlib import Path

from chat_server import chat_server, pictures_of

SCORES = {rubric: {"reason": f"the {rubric}", "points": points} for rubric, points in (("structure", 5), ("realism", 3), ("alignment", 4))}
SUITE = [
    {"prompt": "a stool with three legs", "group": "common", "parts": [], "size": [[0, 2]] * 3, "mount": "floor"},
    {"prompt": "a fast red racing car", "group": "common", "parts": [], "size": [[0, 2]] * 3, "mount": "floor"},
]


QUESTIONS = []  # as they came


def judge(question):
    QUESTIONS.append(question)
    return json.dumps(SCORES)


def main():
    roomgen, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    server, url = chat_server(judge, "judge")
    threading.Thread(target=server.serve_forever, daemon=True).start()

    def run(*arguments):
        done = subprocess.run(
            [roomgen, "--json", *arguments, "--judge", "--model", "judge", "--base-url", url], capture_output=True, text=True
        )
        if done.returncode != 0:
            sys.exit(f"{arguments}: exit {done.returncode}: {done.stderr}")
        return json.loads(done.stdout)

    failures = []
    made = run("create", "a round oak table", "-o", str(folder / "table.glb"))
    if made.get("scores") != SCORES:
        failures.append(f"create says {made.get('scores')}")
    (folder / "suite.json").write_text(json.dumps(SUITE))
    figures = run("experiment", "--create", str(folder / "suite.json"), "-o", str(folder / "out"), "--force", "--quiet")
    scores = figures["full"]["all"].get("scores")
    if scores != {"judged": 1, "structure": 5.0, "realism": 3.0, "alignment": 4.0}:
        failures.append(f"the experiment says {scores}")
    if "| structure | realism | alignment |" not in (folder / "out" / "report.md").read_text():
        failures.append("the report has no columns of the points")
    if len(QUESTIONS) != 2:
        failures.append(f"{len(QUESTIONS)} questions were asked, not one for each thing that was made")
    for question, words in zip(QUESTIONS, ("a round oak table", "a stool with three legs")):
        seen = pictures_of(question["messages"][-1])
        if len(set(seen)) != 4 or not all(picture.startswith(b"\x89PNG") for picture in seen):
            failures.append(f"{words}: {len(seen)} pictures of four sides")
        if words not in json.dumps(question["messages"][-1]["content"]):
            failures.append(f"{words}: not in the question")
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
