#!/usr/bin/env python3
"""A tour's video by the real ffmpeg, and photographs by the real Blender, of a room that this writes by hand.

    film.py video ROOMGEN FOLDER
    film.py photographs ROOMGEN FOLDER [PYTHON]     PYTHON: one that has bpy (this one)

Prints "SKIPPED: ..." where ffmpeg or bpy is not installed.
"""

import json
import shutil
import struct
import subprocess
import sys
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[3] / "scripts" / "render-cycles"
WIDTH, HEIGHT = 97, 73  # odd: sides of a video are even

SCENE = {
    "format": "roomgen-scene",
    "version": 1,
    "room": {"type": "bedroom", "polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "height": 2.6,
             "openings": [{"id": "door-0", "type": "door", "wall": 0, "from": 0.5, "to": 1.4, "sill": 0, "head": 2.1}]},
    "objects": [{"id": "wardrobe-0", "category": "wardrobe", "size": [1, 0.5, 1.8], "position": [2, 3.5, 0]}],
}


def run(*command):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)


def need(condition, what):
    if not condition:
        sys.exit(f"failed: {what}")


def make_frames(roomgen, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    scene = folder / "scene.json"
    scene.write_text(json.dumps(SCENE))
    for command in (["tour", scene, "-o", folder / "tour", "--no-default-libraries"],
                    ["frames", scene, "--tour", folder / "tour", "--size", f"{WIDTH}x{HEIGHT}", "--no-default-libraries"]):
        result = run(roomgen, *command)
        need(result.returncode == 0, result.stderr)
    return scene, folder / "tour"


def video(roomgen, folder):
    if not shutil.which("ffmpeg") or not shutil.which("ffprobe"):
        print("SKIPPED: ffmpeg is not installed")
        return
    tour = make_frames(roomgen, folder)[1]
    result = run("ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-of", "json", "-show_entries",
                 "stream=codec_name,width,height,nb_read_frames,avg_frame_rate", tour / "tour.mp4")
    need(result.returncode == 0, result.stderr)
    stream = json.loads(result.stdout)["streams"][0]
    frames = len((tour / "frames.jsonl").read_text().splitlines())
    need(frames > 1, "there is a frame at most")
    need(int(stream["nb_read_frames"]) == frames, f"{stream} of {frames} frames")
    need((stream["width"], stream["height"]) == (WIDTH - 1, HEIGHT - 1), stream)
    need(stream["codec_name"] == "h264" and stream["avg_frame_rate"] == "4/1", stream)
    print(f"{frames} frames")


def photographs(roomgen, folder, python=sys.executable):
    if run(python, "-c", "import bpy").returncode != 0:
        result = run(python, SCRIPT, folder / "scene.glb", folder)
        need(result.returncode == 77 and "pip install bpy" in result.stderr, result.stderr)
        print("SKIPPED: bpy is not installed")
        return
    scene, tour = make_frames(roomgen, folder)
    result = run(roomgen, "export", scene, "-o", folder / "scene.glb", "--no-default-libraries")
    need(result.returncode == 0, result.stderr)
    result = run(python, SCRIPT, folder / "scene.glb", tour, "--samples", 1, "--width", 64, "--every", 1000)
    need(result.returncode == 0, result.stderr)
    picture = (tour / "cycles" / "000000.png").read_bytes()
    need(struct.unpack(">II", picture[16:24]) == (64, 48), "the picture's size")
    print("1 photograph")


if __name__ == "__main__":
    {"video": video, "photographs": photographs}[sys.argv[1]](Path(sys.argv[2]).resolve(), Path(sys.argv[3]), *sys.argv[4:])
