#!/usr/bin/env python3
"""A recorded room comes back byte for byte without the network, and no file or message holds the key.

    recording.py ROOMGEN FOLDER
"""

import json
import os
import subprocess
import sys
import threading
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from scripted_model import serve  # noqa: E402

KEY = "sk-7f3a9c1e5b2d8f60a4c7e9b1d3f5a802"
PROMPT = "a bedroom"


def run(roomgen, *arguments, key=""):
    environment = {k: v for k, v in os.environ.items() if not k.endswith("_API_KEY")}
    if key:
        environment["ROOMGEN_API_KEY"] = key
    return subprocess.run(
        [roomgen, "generate", *arguments, "--no-pictures", "--force"], capture_output=True, text=True, env=environment
    )


def files_of(folder):
    return {p.relative_to(folder): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def main():
    roomgen, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    script, record = folder / "script", folder / "answers.jsonl"
    record.unlink(missing_ok=True)
    outputs = [run(roomgen, PROMPT, "--seed", "2", "-o", str(script))]
    server, url = serve(script, "chatty")
    threading.Thread(target=server.serve_forever, daemon=True).start()
    model = ["--designer", "model", "--reader", "rules", "--model", "scripted", "--seed", "2"]
    outputs.append(run(roomgen, PROMPT, *model, "-o", str(folder / "first"), "--base-url", url, "--record", str(record), key=KEY))
    server.shutdown()
    server.server_close()
    outputs.append(run(roomgen, PROMPT, *model, "-o", str(folder / "gone"), "--base-url", url, key=KEY))
    outputs.append(run(roomgen, PROMPT, *model, "-o", str(folder / "second"), "--replay", str(record)))
    outputs.append(run(roomgen, "a kitchen", *model, "-o", str(folder / "other"), "--replay", str(record)))

    failures = []
    codes = [o.returncode for o in outputs]
    if codes != [0, 0, 1, 0, 1]:
        failures.append(f"exit codes {codes}: {[o.stderr for o in outputs]}")
    first, second = files_of(folder / "first"), files_of(folder / "second")
    for name in ("scene.json", "plan.json", "scene.glb"):
        if first.get(Path(name)) is None or first[Path(name)] != second.get(Path(name)):
            failures.append(f"{name} differs when the room is made again")
    if len(json.loads(first[Path("scene.json")])["objects"]) < 8:
        failures.append("the room is nearly empty")
    if "a kitchen" not in outputs[4].stderr:
        failures.append(f"the miss does not show what differs: {outputs[4].stderr}")
    # In no part either: half a key narrows the other half down.
    for part in (KEY, KEY[:12], KEY[-12:]):
        for output in outputs:
            if part in output.stdout + output.stderr:
                failures.append("the key is in a message")
        for name, content in files_of(folder).items():
            if part.encode() in content:
                failures.append(f"the key is in {name}")
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
