"""Attacks on the server of the page, each with the required answer."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import subprocess
import sys
import time
import tomllib
from pathlib import Path
from urllib.request import url2pathname

import pytest
from viscoroll.app import answer
from viscoroll.app import server as server_module
from viscoroll.case import example_text

CASE = tomllib.loads(example_text())


def exchange(server, raw, *, timeout=20.0):
    """Return all that the server sends in answer to the bytes of a request."""
    with socket.create_connection(("127.0.0.1", server.server_port), timeout=timeout) as connection:
        with contextlib.suppress(ConnectionError):  # the server may answer before it has read all
            connection.sendall(raw)
        received = b""
        with contextlib.suppress(ConnectionError):
            while part := connection.recv(65536):
                received += part
    return received


def request(server, line="GET /{token}/ HTTP/1.1", *headers, host="127.0.0.1:{port}", body=b""):
    """Return the bytes of a request; its texts may contain {token} and {port}."""
    lines = [line, *([f"Host: {host}"] if host is not None else []), *headers]
    head = "\r\n".join([*lines, "", ""]).format(token=server.token, port=server.server_port)
    return head.encode("latin-1") + body


POST = "POST /{token}/solve HTTP/1.1"


def posted(server, body, *headers):
    return request(server, POST, f"Content-Length: {len(body)}", *headers, body=body)


ATTACKS = {
    "another host name that resolves to this machine": (403, lambda s: request(s, host="evil.example:{port}")),
    "another port in the host": (403, lambda s: request(s, host="127.0.0.1:1")),
    "no host": (403, lambda s: request(s, host=None)),
    "two hosts": (403, lambda s: request(s, "GET /{token}/ HTTP/1.1", "Host: evil.example")),
    "another site posts": (403, lambda s: posted(s, b"{}", "Origin: http://evil.example")),
    "a page without origin posts": (403, lambda s: posted(s, b"{}", "Origin: null")),
    "another port posts": (403, lambda s: posted(s, b"{}", "Origin: http://127.0.0.1:1")),
    "no token": (403, lambda s: request(s, "GET / HTTP/1.1")),
    "a token that is not ASCII": (403, lambda s: request(s, "GET /\xff\xfe/ HTTP/1.1")),
    "a path with NUL": (404, lambda s: request(s, "GET /{token}/page.css\x00 HTTP/1.1")),
    "a parent folder": (404, lambda s: request(s, "GET /{token}/../server.py HTTP/1.1")),
    "an absolute address": (403, lambda s: request(s, "GET http://evil.example/{token}/ HTTP/1.1")),
    "another method": (501, lambda s: request(s, "PUT /{token}/ HTTP/1.1")),
    "a tunnel": (501, lambda s: request(s, "CONNECT evil.example:443 HTTP/1.1")),
    "a long line": (414, lambda s: request(s, "GET /{token}/" + "a" * 70_000 + " HTTP/1.1")),
    "a long header": (431, lambda s: request(s, "GET /{token}/ HTTP/1.1", "A: " + "a" * 70_000)),
    "many headers": (431, lambda s: request(s, "GET /{token}/ HTTP/1.1", *["A: b"] * 200)),
    "another protocol": (505, lambda s: request(s, "GET /{token}/ HTTP/9.9")),
    "no content": (411, lambda s: request(s, POST)),
    "a length of 5000 digits": (400, lambda s: request(s, POST, "Content-Length: " + "9" * 5000)),
    "a negative length": (400, lambda s: request(s, POST, "Content-Length: -1")),
    "a length in other digits": (400, lambda s: request(s, POST, "Content-Length: \xb2")),
    "two lengths": (400, lambda s: request(s, POST, "Content-Length: 2", "Content-Length: 3", body=b"{}")),
    "chunks": (400, lambda s: posted(s, b"{}", "Transfer-Encoding: chunked")),
    "a length too large": (413, lambda s: request(s, POST, "Content-Length: 1000001")),
    "a lone surrogate in a key": (400, lambda s: posted(s, rb'{"case": {"\ud800": 1}}')),
    "a lone surrogate in a text": (400, lambda s: posted(s, rb'{"case": {"ball": "\udfff"}}')),
    "an integer of 5000 digits": (400, lambda s: posted(s, b'{"case": ' + b"1" * 5000 + b"}")),
    "not a number": (400, lambda s: posted(s, b'{"case": NaN}')),
    "an infinite number": (400, lambda s: posted(s, b'{"case": {"ball": -Infinity}}')),
    "deep nesting": (400, lambda s: posted(s, b"[" * 100_000)),
    "bytes that are not UTF-8": (400, lambda s: posted(s, b"\xff\xfe")),
}


@pytest.mark.parametrize("name", ATTACKS)
def test_attacks_are_rejected(server, name):
    status, attack = ATTACKS[name]
    received = exchange(server, attack(server))
    head, _, content = received.partition(b"\r\n\r\n")
    assert head.split()[1] == str(status).encode(), received[:200]
    assert b"evil" not in content
    assert CASE["ball"]["layers"][0]["shear_modulus"]["type"].encode() not in content
    assert exchange(server, request(server)).startswith(b"HTTP/1.0 200")  # the server continues


def test_answers_have_security_headers(server):
    for raw in (request(server), request(server, "GET / HTTP/1.1"), request(server, "PUT / HTTP/1.1")):
        head = exchange(server, raw).partition(b"\r\n\r\n")[0].decode()
        headers = dict(line.split(": ", 1) for line in head.split("\r\n")[1:])
        assert headers["Server"] == "viscoroll"
        assert headers["X-Frame-Options"] == "DENY"
        policy = headers["Content-Security-Policy"]
        assert "default-src 'none'" in policy
        assert "frame-ancestors 'none'" in policy
        assert "unsafe" not in policy


def test_a_request_that_arrives_too_slowly_is_closed(server, monkeypatch):
    monkeypatch.setattr(server_module, "_LONGEST_TRANSFER", 0.3)
    for beginning in (b"", b"GET /", posted(server, b"{" + b" " * 100)[:-50]):
        begun = time.monotonic()
        with socket.create_connection(("127.0.0.1", server.server_port), timeout=10.0) as connection:
            connection.sendall(beginning)
            with contextlib.suppress(ConnectionError):
                while time.monotonic() < begun + 5.0:
                    connection.sendall(b"x")  # each single byte arrives in time
                    connection.settimeout(0.05)
                    with contextlib.suppress(TimeoutError):
                        if not connection.recv(1):
                            break
        assert time.monotonic() < begun + 3.0


def test_connections_are_limited(server):
    with contextlib.ExitStack() as stack:
        silent = [
            stack.enter_context(socket.create_connection(("127.0.0.1", server.server_port)))
            for _ in range(server_module._MAX_CONNECTIONS)
        ]
        deadline = time.monotonic() + 5.0
        while len(server._open) < len(silent) and time.monotonic() < deadline:
            time.sleep(0.01)
        assert exchange(server, request(server)).startswith(b"HTTP/1.0 503")
    deadline = time.monotonic() + 5.0
    while server._open and time.monotonic() < deadline:
        time.sleep(0.01)
    assert exchange(server, request(server)).startswith(b"HTTP/1.0 200")


SECRET = '[secret]\npassword = "swordfish"\n'


def naming_a_file(path):
    """Yield cases that name a file at every key that may refer to one."""
    network = {"type": "kraus", "plateau": 1e6, "strain": 0.01, "loss": 1e5}
    moduli = [
        path,
        {"type": "measured", "file": path},
        {"type": "measured", "file": path, "temperature": 293.15},
        {"type": "master_curve", "file": path},
        {"type": "softening", "matrix": path, "network": network},
        {"type": "softening", "matrix": {"type": "measured", "file": path}, "network": network},
        {"type": "softening", "matrix": {"type": "master_curve", "file": path}, "network": network},
        {"type": "softening", "matrix": 1e6, "network": {"type": "strain_sweep", "file": path}},
        {"type": "published", "name": path, "temperature": 293.15},
    ]
    layer = CASE["ball"]["layers"][0]
    for modulus in moduli:
        changed = layer | {"shear_modulus": modulus}
        yield CASE | {"ball": CASE["ball"] | {"layers": [changed]}}
        yield CASE | {"plane": {"layers": [changed]}}
        yield CASE | {"plane": {"base": {"shear_modulus": modulus}}}
    yield CASE | {"thermal": {"file": path}}
    yield path


def test_no_case_can_make_the_server_read_a_file(tmp_path, monkeypatch):
    path = tmp_path / "secret.toml"
    path.write_text(SECRET, encoding="utf-8")
    opened = []
    monkeypatch.setattr(Path, "open", lambda self, *_, **__: opened.append(self))
    monkeypatch.setattr(Path, "read_text", lambda self, *_, **__: opened.append(self))
    for case in naming_a_file(str(path)):
        error = answer({"case": case})["error"]
        assert "swordfish" not in json.dumps(error)
    assert path not in opened


def command_lines_seen_by_another_user(user):
    """Return the command lines of all processes that the given user can read."""
    script = (
        "import os, sys, glob\n"
        f"if {user} is not None: os.setgid({user}); os.setuid({user})\n"
        "for name in glob.glob('/proc/[0-9]*/cmdline'):\n"
        "    try: sys.stdout.write(open(name, 'rb').read().decode(errors='replace') + '\\n')\n"
        "    except OSError: pass\n"
    )
    return subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout


@pytest.mark.skipif(not Path("/proc/self/cmdline").exists(), reason="no list of processes in /proc")
def test_the_list_of_processes_does_not_show_the_token(tmp_path):
    other = 65534 if os.geteuid() == 0 else None
    browser, seen = tmp_path / "browser", tmp_path / "seen"
    browser.write_text(f'#!/bin/sh\necho "$1" > {seen}.new && mv {seen}.new {seen} && sleep 30; true\n')
    browser.chmod(0o755)
    words = [sys.executable, "-m", "viscoroll", "app"]
    environment = os.environ | {"BROWSER": f"{browser} %s &"}
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment, start_new_session=True) as program:
        try:
            address = program.stdout.readline().split()[0]
            token = address.rstrip("/").rpartition("/")[2]
            deadline = time.monotonic() + 20.0
            while not seen.exists() and time.monotonic() < deadline:
                time.sleep(0.05)
            lines = command_lines_seen_by_another_user(other)
            assert str(browser) in lines  # the browser runs, and its command line is visible
            assert token not in lines
            page = Path(url2pathname(seen.read_text().strip().removeprefix("file://")))
            assert address in page.read_text(encoding="utf-8")
            assert (page.stat().st_mode & 0o777, page.parent.stat().st_mode & 0o777) == (0o600, 0o700)
        finally:
            program.send_signal(signal.SIGINT)
            program.wait(timeout=10)
            with contextlib.suppress(ProcessLookupError):
                os.killpg(program.pid, signal.SIGKILL)
    assert not page.parent.exists()


def test_the_redirect_is_removed_when_the_page_is_sent(server):
    page = server.redirect_file()
    assert server.address in page.read_text(encoding="utf-8")
    exchange(server, request(server, "GET /{token}/page.css HTTP/1.1"))
    assert page.exists()
    exchange(server, request(server))
    deadline = time.monotonic() + 5.0
    while page.exists() and time.monotonic() < deadline:
        time.sleep(0.01)
    assert not page.parent.exists()
