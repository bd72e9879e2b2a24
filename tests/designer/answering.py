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


def ask_with_videos(roomgen, folder, made, count):
    """What goes wrong where an endpoint takes videos, takes none, or takes no pictures either."""
    failures, asked, efforts = [], [], []
    taken = {"video_url", "image_url"}

    def answer(question):
        message = question["messages"][-1]
        asked.append((len(pictures_of(message, "video_url")), len(pictures_of(message))))
        efforts.append(question.get("reasoning_effort"))
        kinds = {part["type"] for part in message["content"]} - {"text"}
        return "3" if kinds <= taken else (400, "this model does not take " + ", ".join(kinds - taken))

    server, url = chat_server(answer, "viewer")
    threading.Thread(target=server.serve_forever, daemon=True).start()

    def run(name, *more):
        asked.clear()
        command = [roomgen, "benchmark", "run", str(made), "--model", "viewer", "--base-url", url, "--frames", "3", "-o", str(folder / name), *more]
        return subprocess.run(command, capture_output=True, text=True)

    done = run("no-frames-of-video", "--video", "--evidence")
    if done.returncode != 1 or "--video" not in done.stderr:
        failures.append(f"--video and --evidence: exit {done.returncode}: {done.stderr}")
    if not list(made.rglob("tour.mp4")):
        done = run("video", "--video")
        return failures + ([] if done.returncode == 1 and "ffmpeg" in done.stderr else [f"no video: {done.stderr}"])
    efforts.clear()
    done = run("video", "--video", "--thinking", "4000")
    if set(efforts) != {"medium"}:
        failures.append(f"thinking: {efforts}")
    if done.returncode != 0 or asked != [(1, 0)] * count:
        failures.append(f"videos: exit {done.returncode}: {done.stderr[-300:]} {asked}")
    taken.remove("video_url")
    done = run("no-video", "--video", "--limit", "2")
    again = run("no-video", "--video")
    if done.returncode or again.returncode or "no video is taken: " not in done.stderr or any(videos for videos, _ in asked):
        failures.append(f"no videos: exit {done.returncode}, {again.returncode}: {done.stderr[-300:]} {asked}")
    lines = [json.loads(line) for line in (folder / "no-video" / "results.jsonl").read_text().splitlines()[1:]]
    if len(lines) != count or {line["shown"] for line in lines} != {"frames"}:
        failures.append(f"no videos: {len(lines)} answers, not all with frames")
    taken.clear()
    done = run("no-pictures", "--video")
    if done.returncode == 0 or "does not take image_url" not in done.stderr or "0 of" not in done.stderr:
        failures.append(f"no pictures: exit {done.returncode}: {done.stderr[-300:]}")
    return failures


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
    failures += ask_with_videos(roomgen, folder, made, len(questions))
    print("\n".join(failures) or f"{len(questions)} questions, {len(asked)} asked")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
