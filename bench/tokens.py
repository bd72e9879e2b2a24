#!/usr/bin/env python3
"""Tokens and roomgen's own time for rooms of 5 to 40 objects, with a scripted model over a real HTTP server.

    tokens.py ROOMGEN FOLDER

Text tokens are counted as a quarter of the characters; a picture of 1024 px adds what the model's maker charges for
it, the same at each step. "Own time" is a step (picture, reading, solving) without the wait for the model. Markdown.
"""

import json
import statistics
import subprocess
import sys
import threading
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "designer"))

from scripted_model import serve  # noqa: E402

KINDS = ["bookshelf", "armchair", "side table", "floor lamp", "dresser", "chair", "desk", "plant", "coffee table", "cabinet"]


def plan(count):
    side = max(4.0, 2.0 * count**0.5)
    objects = [{"category": k, "quantity": count // len(KINDS) + (i < count % len(KINDS))} for i, k in enumerate(KINDS)]
    room = {
        "type": "living room",
        "polygon": [[0, 0], [side, 0], [side, side], [0, side]],
        "height": 2.7,
        "openings": [{"id": "door-0", "type": "door", "wall": 0, "from": 0.4, "to": 1.3, "sill": 0, "head": 2.05}],
    }
    return {"format": "roomgen-plan", "version": 1, "room": room, "objects": [o for o in objects if o["quantity"]]}


def generate(roomgen, folder, *arguments):
    done = subprocess.run(
        [roomgen, "--quiet", "--json", "generate", *arguments, "-o", str(folder), "--force", "--no-pictures"],
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)


def main():
    roomgen, work = sys.argv[1], Path(sys.argv[2])
    work.mkdir(parents=True, exist_ok=True)
    print("| objects | calls | text tokens in | out | in an object | own time a step, median | from the 20th object on | longest |")
    print("|---|---|---|---|---|---|---|---|")
    for count in (5, 10, 20, 40):
        file = work / f"plan-{count}.json"
        file.write_text(json.dumps(plan(count)))
        generate(roomgen, work / "script", "--plan", str(file))
        server, url = serve(work / "script")
        threading.Thread(target=server.serve_forever, daemon=True).start()
        summary = generate(
            roomgen, work / "room", "--plan", str(file), "--designer", "model", "--model", "scripted", "--base-url", url
        )
        server.shutdown()
        server.server_close()
        own = [step["seconds"] - step["model_seconds"] for step in summary["steps"]]
        use = summary["model"]
        late = f"{statistics.median(own[20:]):.3f} s" if own[20:] else ""
        print(
            f"| {count} | {use['calls']} | {use['input_tokens']} | {use['output_tokens']} | "
            f"{use['input_tokens'] / count:.0f} | {statistics.median(own):.3f} s | {late} | {max(own):.3f} s |",
            flush=True,
        )


if __name__ == "__main__":
    main()
