"""A real HTTP server that speaks the OpenAI protocol; what it answers, a function says."""

import base64
import contextlib
import json
import re
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer


def text_of(message):
    """What a message says, whether it has pictures or not."""
    content = message["content"]
    return content if isinstance(content, str) else " ".join(part.get("text", "") for part in content)


def first_choices(text):
    """The first asset of every item of a list that a designer may choose from, or that it is left out; None for other questions."""
    if "What there is:" not in text:
        return None
    choices = []
    for block in re.split(r"^(?=\d+\. )", text.split("What there is:")[1], flags=re.M)[1:]:
        first = re.search(r"^   (\d+[a-z]): ", block, re.M)
        take = first.group(1) if first else "leave out"
        choices.append({"item": block.split(".")[0], "take": take, "words": "", "size_cm": None, "paint": "", "why": "the first"})
    return {"choices": choices}


def pictures_of(message, kind="image_url"):
    """The files of the pictures of a message, or of its videos (video_url)."""
    content = message["content"]
    urls = [part[kind]["url"] for part in content if not isinstance(content, str) and part["type"] == kind]
    return [base64.b64decode(url.split(",", 1)[1]) for url in urls]


def chat_server(answer, model):
    """A server on a free port of 127.0.0.1 that is ready to run, and its base URL. `answer` gets each question
    and gives the answer, or a status and a complaint."""

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def do_POST(self):  # noqa: N802 - the name is http.server's
            question = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            content = answer(question)
            if isinstance(content, tuple):
                self.refuse(*content)
                return
            asked = sum(len(text_of(message)) for message in question["messages"])
            body = json.dumps(
                {
                    "model": model,
                    "choices": [{"message": {"role": "assistant", "content": content}, "finish_reason": "stop"}],
                    "usage": {"prompt_tokens": asked // 4, "completion_tokens": len(content) // 4},
                }
            ).encode("utf-8", "replace")
            self.send_response(200)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def refuse(self, status, complaint):
            body = json.dumps({"error": {"message": complaint}}).encode()
            self.send_response(status)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_):
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    return server, f"http://127.0.0.1:{server.server_port}/v1"


@contextlib.contextmanager
def serving(answer, model):
    """The base URL of such a server while it runs."""
    server, url = chat_server(answer, model)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield url
    finally:
        server.shutdown()
        server.server_close()
