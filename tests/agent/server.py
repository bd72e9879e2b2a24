"""A server on this machine that answers as language models do, well or badly.

    server.py LOG [CERTIFICATE]

prints its port, then serves until its standard input ends. The first part of a request's path names the
scenario (POST /500-twice/v1/chat/completions); SCENARIOS has them all. Every request is a line of JSON in
LOG: scenario, path, headers, body.
"""

import base64
import binascii
import hashlib
import http.server
import json
import os
import ssl
import struct
import sys
import threading

HUGE = 200 << 20


def openai(text, **choice):
    message = {"role": "assistant", "content": text}
    return {
        "model": "tiny-1",
        "choices": [{"message": message, "finish_reason": "stop", **choice}],
        "usage": {"prompt_tokens": 12, "completion_tokens": 3},
    }


def anthropic(block, **fields):
    return {
        "model": "tiny-1",
        "content": [block],
        "stop_reason": "end_turn",
        "usage": {"input_tokens": 21, "output_tokens": 4},
        **fields,
    }


def failure(message):
    return {"error": {"message": message, "type": "invalid_request_error"}}


def is_png(data):
    """Whether every chunk from the first to IEND is whole."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        return False
    at = 8
    while at + 12 <= len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        kind_and_content = data[at + 4 : at + 8 + size]
        (crc,) = struct.unpack(">I", data[at + 8 + size : at + 12 + size])
        if binascii.crc32(kind_and_content) != crc:
            return False
        at += 12 + size
        if kind_and_content[:4] == b"IEND":
            return at == len(data)
    return False


def seen_image(data):
    return openai(hashlib.sha256(data).hexdigest() if is_png(data) else "not a PNG")


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def do_POST(self):
        body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
        self.scenario = self.path.split("/")[1]
        self.request_json = json.loads(body)
        self.count = self.server.note(self)
        name, _, argument = self.scenario.partition("=")
        SCENARIOS[name](self, *([argument] if argument else []))

    def answer(self, status, content, **headers):
        data = content if isinstance(content, bytes) else json.dumps(content).encode()
        self.send_response(status)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(data)))
        for name, value in headers.items():
            self.send_header(name.replace("_", "-"), value)
        self.end_headers()
        self.wfile.write(data)

    def begin(self, length=None):
        """A 200 whose body follows piece by piece."""
        self.close_connection = True
        self.send_response(200)
        if length is not None:
            self.send_header("Content-Length", str(length))
        self.send_header("Connection", "close")
        self.end_headers()

    def content(self):
        """The parts of the last message."""
        return self.request_json["messages"][-1]["content"]

    def secret(self):
        key = self.headers.get("x-api-key") or self.headers.get("Authorization", "")
        return key.removeprefix("Bearer ")

    def ok(self):
        self.answer(200, openai("hello"))

    def at_first(self, times, status, message, **headers):
        if self.count <= times:
            self.answer(status, failure(message), **headers)
        else:
            self.ok()

    def huge(self):
        self.begin()
        piece = b" " * (1 << 20)
        for _ in range(HUGE // len(piece)):
            self.wfile.write(piece)

    def drip(self):
        self.begin()
        while True:
            self.wfile.write(b" ")

    def silent(self):
        threading.Event().wait()

    def cut(self):
        self.begin(length=1000)
        self.wfile.write(b'{"choices": [')

    def redirect(self, port):
        self.answer(307, b"", Location=f"http://127.0.0.1:{port}/ok/v1/chat/completions?token=t")

    def unless(self, option, message, status=400):
        if option in self.request_json:
            self.answer(status, failure(message))
        else:
            self.ok()

    def image(self):
        prefix = "data:image/png;base64,"
        url = self.content()[1]["image_url"]["url"]
        assert url.startswith(prefix)
        self.answer(200, seen_image(base64.b64decode(url.removeprefix(prefix), validate=True)))

    def schema(self):
        form = self.request_json["response_format"]
        self.answer(200, openai(json.dumps(form, sort_keys=True)))

    def anthropic(self):
        ask = self.request_json
        if self.headers.get("anthropic-version") is None or "max_tokens" not in ask:
            self.answer(400, failure("anthropic-version and max_tokens are required"))
        elif any(message["role"] == "system" for message in ask["messages"]):
            self.answer(400, failure("a system message is no message"))
        elif "tools" in ask:
            named = {"type": "tool", "name": ask["tools"][0]["name"]}
            assert ask["tool_choice"] == ({"type": "auto"} if "thinking" in ask else named)
            assert "thinking" not in ask or ask["max_tokens"] > ask["thinking"]["budget_tokens"] >= 1024
            block = {"type": "tool_use", "name": "answer", "input": {"size": [4, 3]}}
            self.answer(200, anthropic(block, stop_reason="tool_use"))
        else:
            self.answer(200, anthropic({"type": "text", "text": ask.get("system", "")}))

    def anthropic_image(self):
        source = self.content()[1]["source"]
        assert source["type"] == "base64" and source["media_type"] == "image/png"
        text = seen_image(base64.b64decode(source["data"], validate=True))
        self.answer(200, anthropic({"type": "text", "text": text["choices"][0]["message"]["content"]}))

    def log_message(self, *_):
        pass


def plain(status, content, **headers):
    return lambda handler: handler.answer(status, content, **headers)


SCENARIOS = {
    "ok": Handler.ok,
    "401": lambda h: h.answer(401, failure(f"Incorrect API key provided: {h.secret()}")),
    "404": plain(404, failure("The model `tiny-1` does not exist")),
    "413": plain(413, b"<html>Request Entity Too Large</html>"),
    "429": plain(429, failure("slow down"), Retry_After="0"),
    "429-long": plain(429, failure("slow down"), Retry_After="3600"),
    "429-then-ok": lambda h: h.at_first(1, 429, "slow down", Retry_After="1"),
    "quota": plain(429, {"error": {"message": "no credit", "code": "insufficient_quota"}}),
    "500": plain(500, failure("out of order")),
    "loading": lambda h: h.at_first(6, 503, "Loading model"),
    "429-inside": plain(200, {"error": {"message": "slow down", "code": 429}}),
    "stream": plain(200, b': hello\n\ndata: {"choices": [{"delta": {"content": "hel"}}]}\n\n'
                         b'data: {"choices": [{"delta": {"content": "lo"}}]}\n\ndata: [DONE]\n\n'),
    "no-pictures": plain(500, failure("image input is not supported")),
    "500-twice": lambda h: h.at_first(2, 500, "out of order"),
    "html": plain(200, b"<!DOCTYPE html><title>Welcome</title>"),
    "truncated": plain(200, b'{"choices": [{"message": {"content": "hel'),
    "not-utf8": plain(200, b'{"choices": [{"message": {"content": "\xff\xfe"}}]}'),
    "deep": plain(200, b"[" * 100000),
    "nothing": plain(200, b""),
    "no-choices": plain(200, {"choices": []}),
    "wrong-types": plain(200, {"choices": [{"message": {"content": 7}}]}),
    "gateway": plain(200, failure("the provider is down")),
    "empty": plain(200, openai("  ")),
    "filtered": plain(200, openai(None, finish_reason="content_filter")),
    "long": plain(200, openai("", finish_reason="length")),
    "huge": Handler.huge,
    "drip": Handler.drip,
    "silent": Handler.silent,
    "cut": Handler.cut,
    "redirect": Handler.redirect,
    "no-schema": lambda h: h.unless("response_format", "response_format is not supported here"),
    "no-grammar": lambda h: h.unless("response_format", "failed to parse grammar", 500),
    "no-old-limit": lambda h: h.unless("max_tokens", "use max_completion_tokens"),
    "no-temperature": lambda h: h.unless("temperature", "temperature: only 1 is supported"),
    "no-thinking": lambda h: h.unless("reasoning_effort", "Unrecognized request argument: reasoning_effort"),
    "schema": Handler.schema,
    "image": Handler.image,
    "anthropic": Handler.anthropic,
    "anthropic-image": Handler.anthropic_image,
    "echo": lambda h: h.answer(200, openai(f"your key is {h.secret()}")),
    "echo-error": lambda h: h.answer(400, f"your key is {'.' * 270} {h.secret()}".encode()),
}


class Server(http.server.ThreadingHTTPServer):
    daemon_threads = True

    def __init__(self, log):
        super().__init__(("127.0.0.1", 0), Handler)
        self.log = log
        self.lock = threading.Lock()
        self.counts = {}

    def note(self, handler):
        """Writes the request down; returns how many there were of its scenario."""
        entry = {
            "scenario": handler.scenario,
            "path": handler.path,
            "headers": {name.lower(): value for name, value in handler.headers.items()},
            "body": handler.request_json,
        }
        with self.lock:
            self.counts[handler.scenario] = self.counts.get(handler.scenario, 0) + 1
            self.log.write(json.dumps(entry) + "\n")
            self.log.flush()
            return self.counts[handler.scenario]

    def handle_error(self, *_):
        """Clients that leave early are what many scenarios are about."""


def main():
    with open(sys.argv[1], "w", encoding="utf-8") as log:
        server = Server(log)
        if len(sys.argv) > 2:
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
            context.load_cert_chain(sys.argv[2])
            server.socket = context.wrap_socket(server.socket, server_side=True)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        print(server.server_address[1], flush=True)
        sys.stdin.read()
        os._exit(0)


if __name__ == "__main__":
    main()
