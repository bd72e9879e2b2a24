#!/usr/bin/env python3
"""Kills `roomgen edit` at random moments; the session must open every time and nothing acknowledged be missing.

    kill.py ROOMGEN SCENE.json [--times 300] [--seed 1]

With scene.glb beside SCENE.json each edit writes that too, and exchanges the whole folder.
"""
import argparse
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time


def history(program, scene):
    done = subprocess.run([program, "history", scene, "--json"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"does not open: {done.stderr}")
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("scene", type=pathlib.Path)
    parser.add_argument("--times", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "scene.json"
        shutil.copy(options.scene, scene)
        if (models := options.scene.with_name("scene.glb")).exists():
            shutil.copy(models, folder)
        ids = [o["id"] for o in json.loads(scene.read_text())["objects"]]
        start = time.monotonic()
        is_locked = lambda i: next(o for o in json.loads(scene.read_text())["objects"] if o["id"] == i)["locked"]

        def toggle():
            one = chance.choice(ids)
            return json.dumps({"do": "lock", "objects": [one], "locked": not is_locked(one)})

        subprocess.run([options.program, "edit", scene, "--op", toggle(), "--quiet"], capture_output=True, check=True)
        usual = time.monotonic() - start
        acknowledged, killed = [], 0
        for n in range(options.times):
            asked = f"edit {n}"
            process = subprocess.Popen([options.program, "edit", scene, "--op", toggle(), "--by", asked, "--quiet"],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                process.wait(chance.uniform(0, 1.2 * usual))
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
                killed += 1
                # Who opens it next writes scene.json if it is a step behind: else the next edit may ask for what is so.
                subprocess.run([options.program, "redo", scene, "--quiet"], capture_output=True)
            if process.returncode == 0:
                acknowledged.append(asked)
            by = [item["by"] for item in history(options.program, scene)]
            missing = [a for a in acknowledged if by.count(a) != 1]
            if missing:
                sys.exit(f"after {asked}: {missing} missing")
        states = [item for item in history(options.program, scene) if item.get("state")]
        print(f"{options.times} edits, {killed} killed, {len(acknowledged)} acknowledged, {len(states) - 2} in the history; "
              f"it opened every time")


if __name__ == "__main__":
    main()
