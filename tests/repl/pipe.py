"""pipe.py ROOMGEN: lines over a pipe are answered one after the other, and the exit code tells what failed."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import scene


def converse(file, lines, *options):
    command = [sys.argv[1], "repl", str(file), "--no-default-libraries", *options]
    return subprocess.run(command, input=lines, capture_output=True, text=True, timeout=100)


def test_answers(file):
    ended = converse(file, "move stool-0 50 cm to the right\n\n# a remark\nundo\nredo 5\nhistory\n")
    assert ended.returncode == 0 and ended.stderr == "", ended
    lines = ended.stdout.splitlines()
    assert lines[0].startswith("stool-0 moved 0.5 m") and lines[1].startswith("stool-0 moved 0.5 m"), lines
    assert "*    2  main  person: move stool-0" in ended.stdout, lines
    assert "> " not in ended.stdout
    assert scene.x_of(file, "stool-0") == 1.5


def test_failures(file):
    """What failed changes nothing and does not stop what follows; the first failure decides the exit code."""
    ended = converse(file, "sing a song\nmove stool-0 9 m to the left\nmove stool-0 10 cm to the left\n")
    assert ended.returncode == 2, ended
    assert ended.stderr.splitlines()[0].startswith("roomgen: line 1: ")
    assert ended.stderr.splitlines()[1].startswith("roomgen: line 2: ")
    assert scene.x_of(file, "stool-0") == 0.9
    assert converse(file, "move stool-0 9 m to the left\nsing\n").returncode == 1
    assert converse(file, "x" * 200_000 + "\nundo\n").returncode == 2
    assert scene.x_of(file, "stool-0") == 1


def test_json(file):
    lines = ["check", "explain stool-1", "preview stool-0 2 2 90",
             '{"do": "turn", "object": "stool-0", "by_deg": 45}', "{", "help", ""]
    ended = converse(file, "\n".join(lines), "--json")
    answers = [json.loads(line) for line in ended.stdout.splitlines()]
    assert [each["ok"] for each in answers] == [True, False, True, True, False, True], answers
    assert "did you mean \"stool-0\"" in answers[1]["error"] and answers[1]["understood"]
    assert answers[2]["feasible"] and answers[2]["yaw_deg"] == 90
    assert not answers[4]["understood"]
    assert ended.returncode == 1


def test_quit_and_bytes(file):
    assert converse(file, "quit\nsing\n").returncode == 0
    command = [sys.argv[1], "repl", str(file), "--no-default-libraries"]
    ended = subprocess.run(command, input=b"\xff\x00\xfe\ncheck", capture_output=True, timeout=100)
    assert ended.returncode == 2 and b"faults" in ended.stdout, ended


def test_changed_by_hand(file):
    """A line at a time, as another program would: who changes the file in between is noticed."""
    command = [sys.argv[1], "repl", str(file), "--no-default-libraries", "--json"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          text=True) as repl:

        def ask(line):
            repl.stdin.write(line + "\n")
            repl.stdin.flush()
            return json.loads(repl.stdout.readline())

        assert ask("move stool-0 10 cm to the right")["ok"]
        undo = [sys.argv[1], "undo", str(file), "--no-default-libraries"]
        other = subprocess.run(undo, capture_output=True, text=True)
        assert other.returncode == 1 and "another program is editing" in other.stderr, other
        scene.write(file, seed=7)
        assert ask("move stool-0 20 cm to the right")["ok"]
        assert scene.x_of(file, "stool-0") == 1.2
        entries = ask("history")["entries"]
        assert [entry["asked"] for entry in entries][-2] == "changed by hand", entries
        repl.stdin.close()
        assert repl.wait(60) == 0


def main():
    for test in (test_answers, test_failures, test_json, test_quit_and_bytes, test_changed_by_hand):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "scene.json"
            scene.write(file)
            test(file)


if __name__ == "__main__":
    main()
