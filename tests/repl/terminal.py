"""terminal.py ROOMGEN: a person at a terminal completes, recalls and drops lines. Exit code 77 without libedit."""

import os
import pty
import select
import sys
import tempfile
import termios
from pathlib import Path

import scene


class Terminal:
    """A program that believes to be at a terminal."""

    def __init__(self, arguments):
        self.shown = b""
        self.pid, self.file = pty.fork()
        if self.pid == 0:
            os.environ["TERM"] = "xterm"
            os.execv(arguments[0], arguments)

    def wait_for(self, text):
        """Until this is shown; what was shown before is forgotten."""
        while text not in self.shown:
            ready, _, _ = select.select([self.file], [], [], 60)
            assert ready, (text, self.shown)
            self.shown += os.read(self.file, 4096)
        shown, self.shown = self.shown.split(text, 1)
        return shown

    def type(self, keys):
        """Once somebody listens to single keys: what comes between the prompt and that is the terminal's."""
        while termios.tcgetattr(self.file)[3] & termios.ICANON:
            select.select([], [], [], 0.01)
        os.write(self.file, keys)

    def end(self):
        try:
            while os.read(self.file, 4096):
                pass
        except OSError:  # the other end is closed
            pass
        return os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])


def begin(file, cache):
    terminal = Terminal([sys.argv[1], "repl", str(file), "--no-default-libraries", "--cache", cache])
    shown = terminal.wait_for(b"> ")
    if b"libedit" in shown:
        print("SKIPPED: " + shown.decode())
        sys.exit(77)
    return terminal


def main():
    with tempfile.TemporaryDirectory() as folder:
        file, cache = Path(folder) / "scene.json", folder + "/cache"
        scene.write(file)
        terminal = begin(file, cache)
        # A command, a kind and an id are completed; the id after what both have in common.
        terminal.type(b"expl\twardr\t-\t\r")
        terminal.wait_for(b"wardrobe-0: wardrobe")
        terminal.wait_for(b"> ")
        # What a word may become is listed; Ctrl-C drops the line.
        terminal.type(b"move sto\t\t")
        terminal.wait_for(b"stool  stool-0")
        terminal.type(b"\x03move st\t-0 50 cm to the right\r")
        terminal.wait_for(b"stool-0 moved 0.5 m")
        terminal.wait_for(b"> ")
        assert scene.x_of(file, "stool-0") == 1.5
        # The line before is recalled by an arrow, and what is wrong ends nothing.
        terminal.type(b"\x1b[A\r")
        terminal.wait_for(b"stool-0 moved 0.5 m")
        terminal.wait_for(b"> ")
        terminal.type(b"sing a song\r")
        terminal.wait_for(b"song\r\n")
        terminal.wait_for(b"> ")
        terminal.type(b"\x04")
        assert terminal.end() == 0
        # The next time too.
        terminal = begin(file, cache)
        terminal.type(b"\x1b[A\x1b[A\r")
        terminal.wait_for(b"stool-0 moved 0.5 m")
        terminal.wait_for(b"> ")
        assert scene.x_of(file, "stool-0") == 2.5
        terminal.type(b"quit\r")
        assert terminal.end() == 0


if __name__ == "__main__":
    main()
