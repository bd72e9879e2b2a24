#!/usr/bin/env python3
"""Plays recorded designers again over HTTP, and holds that their rooms come out as they said.

    playing.py ROOMGEN OUT [PLAY...] [--figures FILE]            plays of tests/data/plays by name; else all
    playing.py --pack RECORDING.jsonl WISH SCENE.json PLAY.json   of `generate --record`, and what came of it

A play is the wish and what was answered to each form, in order. What a question shows and says may differ from when it was
recorded; a place is looked up by the thing that it is for (its id, else how it was described). What was answered more often
than it is asked now is not needed any more. Rooms may come out a little otherwise than they did, and what a review moves is
not where it was put first; bars are below. Exit code 1 if one is missed.
"""

import argparse
import json
import re
import statistics
import subprocess
import sys
import time
from pathlib import Path

from chat_server import serving, text_of

PLAYS = Path(__file__).resolve().parent.parent / "data/plays"
LEAST_THINGS, LEAST_NEAR, MORE_CALLS = 0.93, 0.55, 6
NOTHING = {"things": {"things": []}, "choices": {"choices": []}, "review": {"judgement": "", "operations": []}}
ASKED = re.compile(r"^(?:Now place )?([a-z0-9][^:\n]*-\d+): (.*?)(?:, about |; it is the middle| \(|$)", re.M)


def things_asked(question):
    """What is to be placed, in order: id and description."""
    text = text_of(question["messages"][1])
    text = text[text.rindex("Now place "):]
    others = text.find("Give also")
    found = ASKED.findall(text[:others] if others >= 0 else text)[:1]
    return found + (ASKED.findall(text[others:]) if others >= 0 else [])


def form_of(question):
    return question["response_format"]["json_schema"]["name"]


class Designer:
    """Answers as the recorded one did."""

    def __init__(self, play):
        self.forms, self.places, self.known = {}, {}, []
        for one in play["answers"]:
            if one["form"] != "placement":
                self.forms.setdefault(one["form"], []).append(one["answer"])
                continue
            answer = dict(one["answer"])
            others = {other.get("id"): other for other in answer.pop("others", None) or []}
            for index, (identifier, described) in enumerate(one["things"]):
                said = answer if index == 0 else others.get(identifier)
                if said:
                    self.places.setdefault(identifier, []).append(said)
                    self.known.append((described, identifier))
        self.asked, self.own_seconds, self.sent, self.said = [], [], None, {}

    def answer(self, question):
        now, form = time.monotonic(), form_of(question)
        if self.sent is not None:
            self.own_seconds.append((form, now - self.sent))
        self.asked.append(form)
        answer = self.place(question) if form == "placement" else self.next_of(form)
        self.sent = time.monotonic()
        return json.dumps(answer)

    def next_of(self, form):
        left = self.forms.get(form, [])
        return left.pop(0) if left else NOTHING.get(form, {})

    def place(self, question):
        answers = []
        for identifier, described in things_asked(question):
            said = self.said_of(identifier, described)
            if said:
                answers.append({**said, "id": identifier})
                self.said[identifier] = said
        first = answers[0] if answers else {}
        return {**first, "others": answers[1:]}

    def said_of(self, identifier, described):
        alike = [name for words, name in self.known if words == described and name not in self.said]
        for name in [identifier, *alike]:
            if self.places.get(name):
                left = self.places[name]
                return left.pop(0) if len(left) > 1 else left[0]
        return None


def play_again(roomgen, play, folder):
    designer = Designer(play)
    with serving(designer.answer, "played") as url:
        done = subprocess.run([roomgen, "--json", "generate", play["wish"], "--designer", "model", "--model", "played", "--base-url", url,
                               "--no-fallback", "--no-pictures", "--seconds", "600", "--force", "-o", str(folder)],
                              capture_output=True, text=True)  # fmt: skip
    assert done.returncode == 0, f"{play['wish']}: {done.stderr}"
    return designer, json.loads((folder / "scene.json").read_text())


def figures_of(name, designer, scene):
    objects = {o["id"]: o for o in scene["objects"]}
    off = []
    for identifier, said in designer.said.items():
        if identifier in objects and said.get("location") and not said.get("leave_out"):
            at = objects[identifier]["position"]
            off.append(max(abs(a - b) for a, b in zip(at, said["location"])))
    left = [identifier for identifier, said in designer.said.items() if identifier not in objects and not said.get("leave_out")]
    requirements = scene.get("requirements", [])
    return {
        "name": name, "calls": len(designer.asked), "things": len(objects), "placed": len(off), "off": off,
        "not there": left, "own": [seconds for _, seconds in designer.own_seconds],
        "sheets": [seconds for form, seconds in designer.own_seconds if form == "choices"],
        "met": sum(r["verdict"] == "met" for r in requirements), "not met": [r["clause"] for r in requirements if r["verdict"] == "not met"],
    }  # fmt: skip


def pack(recording, wish, scene, file):
    things = len(json.loads(Path(scene).read_text())["objects"])
    answers = []
    for line in Path(recording).read_text().splitlines():
        entry = json.loads(line)
        if "reply" not in entry:
            continue
        request = entry["request"]
        form = request["schema_name"]
        question = {"messages": [{"content": m["text"]} for m in request["messages"]]}
        text = entry["reply"]["text"]
        try:
            answer = json.loads(text[text.index("{"):text.rindex("}") + 1])
        except ValueError:
            continue
        answers.append({"form": form, "answer": answer})
        if form == "placement":
            answers[-1]["things"] = things_asked(question)
    lines = ",\n".join(json.dumps(one, ensure_ascii=False, separators=(",", ":")) for one in answers)
    head = json.dumps({"wish": wish, "things": things, "calls": len(answers)}, ensure_ascii=False)[:-1]
    Path(file).write_text(f'{head}, "answers": [\n{lines}\n]}}\n')


def misses(play, figures):
    near = sum(off <= 0.05 for off in figures["off"])
    return [what for what, missed in (
        ("things", figures["things"] < LEAST_THINGS * play["things"]),
        ("places", near < LEAST_NEAR * figures["placed"]),
        ("calls", figures["calls"] > play["calls"] + MORE_CALLS),
    ) if missed]  # fmt: skip


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("paths", nargs="+")
    parser.add_argument("--figures", type=Path)
    parser.add_argument("--pack", action="store_true")
    arguments = parser.parse_args()
    if arguments.pack:
        return pack(*arguments.paths)
    roomgen, out, *names = arguments.paths
    rooms, failed = [], []
    for name in names or sorted(file.stem for file in PLAYS.glob("*.json")):
        play = json.loads((PLAYS / f"{name}.json").read_text())
        figures = figures_of(name, *play_again(roomgen, play, Path(out) / name))
        rooms.append(figures)
        failed += [f"{name}: {what}" for what in misses(play, figures)]
        near = sum(off <= 0.05 for off in figures["off"])
        print(f"{name}: {figures['calls']} calls, {figures['things']} things, of {figures['placed']} places {near} within 5 cm, "
              f"not there: {', '.join(figures['not there']) or 'none'}; own time {statistics.median(figures['own']):.2f} s a call, "
              f"sheets {max(figures['sheets'], default=0):.2f} s; {figures['met']} clauses met, not: {'; '.join(figures['not met']) or 'none'}",
              flush=True)  # fmt: skip
    if arguments.figures:
        arguments.figures.write_text(json.dumps(rooms, indent=1))
    return f"missed: {', '.join(failed)}" if failed else 0


if __name__ == "__main__":
    sys.exit(main())
