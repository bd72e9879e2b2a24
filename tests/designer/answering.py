#!/usr/bin/env python3
"""A scripted model behind a real HTTP server answers a small set of spatial questions, badly, and well.

    answering.py ROOMGEN FOLDER
"""

import json
import shutil
import subprocess
import sys
import threading
from pathlib import Path

from chat_server import chat_server, pictures_of, text_of

LEVELS = {
    "rooms": {"study": "a study of 4 by 4 m with a desk with a chair, an armchair, a bookshelf and a plant"},
    "seats of a sofa": 3,
    "compositional": {"low": [1, 1], "high": [2, None]},
    "relational": {"medium": [0.0, 1.0]},
    "observational": {"low": {"eye height": 1.5, "hidden": [0.0, 0.3]}},
}


def main():
    roomgen, folder = sys.argv[1], Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "levels.json").write_text(json.dumps(LEVELS))
    failures, asked, answers = [], [], []  # answers as they are to be given, if any

    def answer(question):
        asked.append(question)
        return "Let me see.\n" + (answers.pop(0) if answers else "42")

    server, url = chat_server(answer, "reader")
    threading.Thread(target=server.serve_forever, daemon=True).start()

    def run(*arguments, code=0):
        done = subprocess.run([roomgen, *arguments], capture_output=True, text=True)
        if done.returncode != code:
            failures.append(f"{arguments}: exit {done.returncode}: {done.stderr[-500:]}")
        return done

    made = folder / "set"
    grid = ["benchmark", "make", "-o", str(made), "--levels", str(folder / "levels.json"), "--compositional", "low,high",
            "--size", "96x72", "--fps", "1", "--per-form", "2"]
    run(*grid)
    questions = [json.loads(line) for line in (made / "questions.jsonl").read_text().splitlines()]
    scenes = {q["complexity"]["compositional"]: json.loads((made / q["complexity"]["folder"] / "scene.json").read_text()) for q in questions}
    low, high = ({o["id"]: o for o in scenes[level]["objects"]} for level in ("low", "high"))
    if not set(low) < set(high) or any(high[name] != thing for name, thing in low.items()):
        failures.append("the lower level is no part of the higher one")
    if scenes["low"]["room"] != scenes["high"]["room"]:
        failures.append("the levels have other rooms")
    before = {p: p.stat().st_mtime_ns for p in made.rglob("*.jpg")}
    run(*grid)
    if before != {p: p.stat().st_mtime_ns for p in made.rglob("*.jpg")}:
        failures.append("frames that were there were drawn again")
    run(*grid[:-1], "5", code=1)  # another set is not mixed in

    ask = ["benchmark", "run", str(made), "--model", "reader", "--base-url", url, "--frames", "6"]
    run(*ask, "-o", str(folder / "bad"), "--limit", "5")
    run(*ask, "-o", str(folder / "bad"))
    if len(asked) != len(questions):
        failures.append(f"{len(asked)} questions were asked, not {len(questions)}, each once")
    for one in asked:
        message = one["messages"][-1]
        if not 1 <= len(pictures_of(message)) <= 6 or "answer_index" in json.dumps(one["messages"][0]):
            failures.append("pictures are missing, or too many")
    for one, q in zip(asked, questions):
        if q["question"] not in text_of(one["messages"][-1]):
            failures.append(f"{q['id']} was not asked in its turn")
    answers += [chr(65 + q["answer_index"]) if "choices" in q else str(q["answer"]) for q in questions]
    run(*ask, "-o", str(folder / "good"))
    results = [json.loads(line) for line in (folder / "good" / "results.jsonl").read_text().splitlines()[1:]]
    wrong = [r for r in results if r["exact"] != 1.0 or r["mean_relative"] != 1.0]
    if wrong or len(results) != len(questions):
        failures.append(f"of {len(results)} right answers {len(wrong)} are scored as wrong: {wrong[:3]}")
    report = (folder / "good" / "report.md").read_text()
    if "Over compositional complexity" not in report or "100 (" not in report:
        failures.append("the report lacks its table")
    if "<svg" not in (folder / "good" / "compositional.svg").read_text():
        failures.append("there is no plot")
    lines = [json.dumps({"id": r["id"], "answer": r["answer"]}) for r in results]
    (folder / "answers.jsonl").write_text("\n".join(lines))
    run("benchmark", "score", str(made / "questions.jsonl"), str(folder / "answers.jsonl"), "-o", str(folder / "scores"))
    if (folder / "scores" / "report.md").read_text() != report:
        failures.append("answers from elsewhere are scored otherwise")
    checker = Path(__file__).resolve().parents[2] / "bench" / "questions" / "verify.py"
    folders = sorted({str(made / q["complexity"]["folder"]) for q in questions})
    done = subprocess.run([sys.executable, str(checker), *folders], capture_output=True, text=True)
    print(done.stdout)
    if done.returncode != 0:
        failures.append("answers are wrong: " + done.stdout[-800:] + done.stderr[-500:])
    print("\n".join(failures) or f"{len(questions)} questions, {len(asked)} asked")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
