#!/usr/bin/env python3
"""A scripted judge behind a real HTTP server: rules make things, the model sees four pictures of each and gives points.

    judging.py ROOMGEN FOLDER
"""

import base64
import json
import subprocess
import sys
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

SCORES = {rubric: {"reason": f"the {rubric}", "points": points} for rubric, points in (("structure", 5), ("realism", 3), ("alignment", 4))}
SUITE = [
    {"prompt": "a stool with three legs", "group": "common", "parts": [], "size": [[0, 2]] * 3, "mount": "floor"},
    {"prompt": "a fast red racing car", "group": "common", "parts": [], "size": [[0, 2]] * 3, "mount": "floor"},
]


class Judge(BaseHTTPRequestHandler):
    questions = []

    def do_POST(self):  # noqa: N802 - the name is http.server's
        question = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.questions.append(question)
        body = json.dumps(
            {"model": "judge", "choices": [{"message": {"role": "assistant", "content": json.dumps(SCORES)}, "finish_reason": "stop"}]}
        ).encode()
        self.send_response(200)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_):
        pass


def pictures(question):
    content = question["messages"][-1]["content"]
    urls = [part["image_url"]["url"] for part in content if part["type"] == "image_url"]
    return [base64.b64decode(url.split(",", 1)[1]) for url in urls]


def main():
    roomgen, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    server = ThreadingHTTPServer(("127.0.0.1", 0), Judge)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    url = f"http://127.0.0.1:{server.server_port}/v1"

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
    if len(Judge.questions) != 2:
        failures.append(f"{len(Judge.questions)} questions were asked, not one for each thing that was made")
    for question, words in zip(Judge.questions, ("a round oak table", "a stool with three legs")):
        seen = pictures(question)
        if len(set(seen)) != 4 or not all(picture.startswith(b"\x89PNG") for picture in seen):
            failures.append(f"{words}: {len(seen)} pictures of four sides")
        if words not in json.dumps(question["messages"][-1]["content"]):
            failures.append(f"{words}: not in the question")
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
