#!/usr/bin/env python3
"""Furnishes rooms with a scripted model over HTTP, in several manners, and judges them with the second checker.

    model_in_the_loop.py ROOMGEN FOLDER [--rooms N] [--manners good,chatty,…] [--markdown] [-- MORE OPTIONS]

The script of each room is what the rules made of it. Exit code 1 if a bar is missed.
"""

import argparse
import json
import subprocess
import sys
import threading
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "checker"))
sys.path.insert(0, str(Path(__file__).resolve().parent))

from roomgen_checker import files, reach, report  # noqa: E402
from roomgen_checker.constraints import STRICT  # noqa: E402
from scripted_model import serve  # noqa: E402

ROOMS = ["a living room", "a bedroom", "a kitchen", "a bathroom", "a dining room", "a balcony"]


def folder_of(folder, prompt):
    return folder / prompt.replace(" ", "-")


def run(roomgen, *arguments):
    done = subprocess.run([roomgen, "--quiet", "--json", "generate", *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(arguments)}: exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def write_room(scene, path):
    path.write_text(json.dumps(json.loads(scene.read_text())["room"]))


def write_script(roomgen, prompt, folder):
    """The room that the rules make of this prompt now; one of an older build would prove nothing."""
    folder.mkdir(parents=True, exist_ok=True)
    run(roomgen, prompt, "--seed", "5", "-o", str(folder / "script"), "--no-pictures", "--force")
    write_room(folder / "script" / "scene.json", folder / "room.json")


def one_room(roomgen, prompt, manner, folder, more=()):
    """Furnishes a room with a model of this manner, whose script is the rules' room; the summary."""
    script = folder / "script"
    server, url = serve(script, manner)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    output = folder / manner
    try:
        summary = run(
            roomgen, prompt, "--seed", "5", "-o", str(output), "--no-pictures", "--force",
            "--room", str(folder / "room.json"), "--designer", "model", "--reader", "rules", "--model", "scripted", "--base-url", url, *more,
        )  # fmt: skip
    finally:
        server.shutdown()
        server.server_close()
    options = report.Options(files.Categories.default(), STRICT, "auto", None, reach.LENIENCE)
    summary["violations"] = len(report.check_file(output / "scene.json", options)["violations"])
    return summary


def total(summaries):
    add = lambda *keys: sum(pick(s, keys) for s in summaries)  # noqa: E731
    return {
        "objects": add("objects"),
        "left out": sum(len(s["unplaced"]) for s in summaries),
        "held": add("held") / max(1, add("constraints")),
        "half": add("suggestions", "within_0.5_m") / max(1, add("suggestions", "located")),
        "one": add("suggestions", "within_1_m") / max(1, add("suggestions", "located")),
        "facing": add("suggestions", "facing_kept") / max(1, add("suggestions", "faced")),
        "fallbacks": add("model", "fallbacks"),
        "violations": add("violations"),
    }


def pick(value, keys):
    for key in keys:
        value = value[key]
    return value


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("roomgen")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--rooms", type=int, default=len(ROOMS))
    parser.add_argument("--manners", default="good,chatty,sloppy,hostile")
    parser.add_argument("more", nargs="*")
    args = parser.parse_args()
    failures = []
    print("| model | objects | left out | constraints held | within 0.5 m | within 1 m | facing kept | by rules | violations |")
    print("|---|---|---|---|---|---|---|---|---|")
    for prompt in ROOMS[: args.rooms]:
        write_script(args.roomgen, prompt, folder_of(args.folder, prompt))
    for manner in args.manners.split(","):
        summaries = []
        for prompt in ROOMS[: args.rooms]:
            summaries.append(one_room(args.roomgen, prompt, manner, folder_of(args.folder, prompt), args.more))
        t = total(summaries)
        print(
            f"| {manner} | {t['objects']} | {t['left out']} | {t['held']:.1%} | {t['half']:.1%} | {t['one']:.1%} | "
            f"{t['facing']:.1%} | {t['fallbacks']} | {t['violations']} |",
            flush=True,
        )
        if t["violations"]:
            failures.append(f"{manner}: {t['violations']} violations")
        if manner in ("good", "chatty") and (t["half"] < 0.85 or t["held"] < 0.95 or t["fallbacks"]):
            failures.append(f"{manner}: the suggestions were not followed")
        if manner == "sloppy" and (t["fallbacks"] > 0.1 * t["objects"] or t["held"] < 0.9):
            failures.append("sloppy: too many answers could not be read")
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
